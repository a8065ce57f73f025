// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ActiveRegions.h"

#include "Core/FirstException.h"
#include "Core/KdLink.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>

namespace exabricks
{
namespace
{
constexpr layout::KdNode Nothing{ 0, 4 * layout::KD_NO_REGION + layout::KD_LEAF };

// A node and the range of values below it.
struct Subtree
{
  layout::KdNode node = Nothing;
  ValueRange range;
};

// The ranges of a component, and the function by which it shows.
struct Shown
{
  const ValueRanges* ranges;
  const TransferFunction* transfer;
};

// Makes the tree of what is active, from the leaves on.
class TreeMaker
{
public:
  explicit TreeMaker(Extreme extreme)
    : Wanted(extreme)
  {
    this->Resize(1);
  }

  ActiveRegions take(const Subtree& root)
  {
    this->Put(0, root);
    this->Result.nodes.resize(this->Used);
    this->Result.nodeExtremes.resize(this->wantsExtremes() ? this->Used : 0);
    return std::move(this->Result);
  }

  /// With the root, for which there is a place.
  std::size_t nodes() const { return this->Used; }
  ActiveRegions& result() { return this->Result; }

  float extremeOf(const ValueRange& range) const
  {
    return this->Wanted == Extreme::Greatest ? range.max : range.min;
  }
  bool wantsExtremes() const { return this->Wanted != Extreme::None; }

  // Makes room for two children side by side, fills it with what `lower` and `upper` return, and
  // returns the node above them: Nothing, if both children are.
  template <typename Lower, typename Upper>
  Subtree join(int axis, int plane, const Lower& lower, const Upper& upper)
  {
    const std::size_t place = this->nodes();
    this->Resize(place + 2);
    const Subtree first = lower();
    const Subtree second = upper();
    if (first.node.link == Nothing.link && second.node.link == Nothing.link)
    {
      this->Resize(place);
      return {};
    }
    this->Put(place, first);
    this->Put(place + 1, second);
    ValueRange range = first.range;
    range.add(second.range);
    return { { plane, makeLink(place, static_cast<std::uint32_t>(axis)) }, range };
  }

  /// Where in this tree and its boxes those of another one are. Roots do not count.
  struct Place
  {
    std::size_t nodes = 1;
    std::size_t boxes = 0;

    void pass(const TreeMaker& other)
    {
      this->nodes += other.nodes() - 1;
      this->boxes += other.Result.boxes.size();
    }
  };

  void makeRoom(const Place& end)
  {
    this->Resize(end.nodes);
    this->Result.boxes.resize(end.boxes);
    this->Result.boxExtremes.resize(this->wantsExtremes() ? end.boxes : 0);
  }

  /// Puts another tree there, where there is room; from several threads at once.
  void put(const TreeMaker& other, const Place& place)
  {
    const ActiveRegions& from = other.Result;
    for (std::size_t i = 1; i < other.Used; ++i)
    {
      this->Result.nodes[place.nodes + i - 1] = moved(from.nodes[i], place);
    }
    const auto at = [](auto& items, std::size_t i)
    { return items.begin() + static_cast<std::ptrdiff_t>(i); };
    if (this->wantsExtremes())
    {
      std::copy(at(from.nodeExtremes, 1), at(from.nodeExtremes, other.Used),
        at(this->Result.nodeExtremes, place.nodes));
      std::copy(from.boxExtremes.begin(), from.boxExtremes.end(),
        at(this->Result.boxExtremes, place.boxes));
    }
    std::copy(from.boxes.begin(), from.boxes.end(), at(this->Result.boxes, place.boxes));
  }

  /// A node of a tree that is there.
  static layout::KdNode moved(const layout::KdNode& node, const Place& place)
  {
    return moveLink(node, place.nodes - 1, 0);
  }

  void count(const TreeMaker& other)
  {
    this->Result.regions += other.Result.regions;
    this->Result.boxCount += other.Result.boxCount;
  }

private:
  // There is room for more than is used, so that vectors seldom grow.
  void Resize(std::size_t nodes)
  {
    this->Used = nodes;
    if (nodes > this->Result.nodes.size())
    {
      const std::size_t room = std::max(nodes, 2 * this->Result.nodes.size());
      this->Result.nodes.resize(room);
      this->Result.nodeExtremes.resize(this->wantsExtremes() ? room : 0);
    }
  }

  void Put(std::size_t place, const Subtree& subtree)
  {
    this->Result.nodes[place] = subtree.node;
    if (this->wantsExtremes())
    {
      this->Result.nodeExtremes[place] = this->extremeOf(subtree.range);
    }
  }

  const Extreme Wanted;
  ActiveRegions Result;
  std::size_t Used = 0; // of the nodes
};

// Selects below one node of the regions' tree.
class Selection
{
public:
  // `ranges`: of the first component, by which steps are weighted.
  Selection(const Volume& volume, const ValueRanges& ranges, const std::vector<Shown>& shown,
    const StepWeights* weights, const ActiveForm& form, bool anyAbsentCells)
    : Part(volume.structure->shown())
    , IsWhole(!volume.structure->hierarchy.shown)
    , Tree(volume.structure->tree)
    , BrickHasAbsentCells(volume.values->brickHasAbsentCells)
    , BrickHasUndefinedCells(volume.values->brickHasUndefinedCells)
    , AnyAbsentCells(anyAbsentCells)
    , Ranges(ranges)
    , Components(shown)
    , Weights(weights)
    , Form(form)
    , Made(form.extreme)
  {
  }

  void selectBelow(std::size_t node)
  {
    std::size_t first = node;
    while ((this->Tree.nodes[first].link & 3) != layout::KD_LEAF)
    {
      first = this->Tree.nodes[first].link >> 2;
    }
    const std::vector<MacrocellGrid>& grids = this->Ranges.grids;
    // Leaves come in the order of regions, as grids do.
    this->NextGrid = static_cast<std::size_t>(
      std::lower_bound(grids.begin(), grids.end(), this->Tree.nodes[first].link >> 2,
        [](const MacrocellGrid& grid, std::uint32_t region) { return grid.region < region; }) -
      grids.begin());
    this->Root = this->Select(node);
  }

  const TreeMaker& made() const { return this->Made; }
  const Subtree& root() const { return this->Root; }

private:
  // Of a part of a hierarchy there are regions around what is shown.
  bool IsInPart(const layout::Region& region) const
  {
    // Also one that ends at its face: the cell before a surface may be in it.
    return this->IsWhole ||
      this->Part.intersects(
        { Int3(region.lo) - std::int64_t(1), Int3(region.hi) + std::int64_t(1) });
  }

  bool ShowsUndefined(const layout::Region& region) const
  {
    if (!this->Form.undefined || this->BrickHasUndefinedCells.empty())
    {
      return false;
    }
    const auto first = this->Tree.brickLists.begin() + region.firstBrick;
    return std::any_of(first, first + region.brickCount,
      [this](std::uint32_t brick) { return this->BrickHasUndefinedCells[brick] != 0; });
  }

  bool ShowsRegion(std::uint32_t region) const
  {
    return std::any_of(this->Components.begin(), this->Components.end(),
      [=](const Shown& of) { return of.transfer->visible(of.ranges->regions[region]); });
  }

  bool ShowsSplit(std::size_t split) const
  {
    return std::any_of(this->Components.begin(), this->Components.end(),
      [=](const Shown& of) { return of.transfer->visible(of.ranges->splits[split]); });
  }

  bool ShowsMacrocell(std::size_t i) const
  {
    return std::any_of(this->Components.begin(), this->Components.end(),
      [=](const Shown& of) { return of.transfer->visible(of.ranges->macrocells[i]); });
  }

  Subtree Select(std::size_t n)
  {
    const layout::KdNode& node = this->Tree.nodes[n];
    const std::uint32_t index = node.link >> 2;
    if ((node.link & 3) != layout::KD_LEAF)
    {
      if (!this->Form.undefined && !this->ShowsSplit(index / 2))
      {
        return {};
      }
      return this->Made.join(
        node.link & 3, node.plane, [&] { return this->Select(index); },
        [&] { return this->Select(index + 1); });
    }
    const layout::Region& region = this->Tree.regions[index];
    const std::vector<MacrocellGrid>& grids = this->Ranges.grids;
    while (this->NextGrid < grids.size() && grids[this->NextGrid].region < index)
    {
      ++this->NextGrid;
    }
    const bool undefined = this->ShowsUndefined(region);
    // Values first: where they do not show, the region is not read.
    if ((!undefined && !this->ShowsRegion(index)) || region.brickCount == 0 ||
      !this->IsInPart(region))
    {
      return {};
    }
    ++this->Made.result().regions;
    if (undefined || this->NextGrid == grids.size() || grids[this->NextGrid].region != index)
    {
      return this->Show(region, node.plane, region.lo, region.hi, this->Ranges.regions[index]);
    }
    const MacrocellGrid& grid = grids[this->NextGrid];
    return this->Cut(region, node.plane, grid, glm::ivec3(0), grid.count(region));
  }

  // Selects among the macrocells of a region from `begin` up to `end`: layers that show nothing are
  // cut off, side by side, and where there are none, the macrocells are halved. `width`: of its
  // finest cells.
  Subtree Cut(const layout::Region& region, int width, const MacrocellGrid& grid,
    const glm::ivec3& begin, const glm::ivec3& end)
  {
    const glm::ivec3 n = grid.count(region);
    glm::ivec3 first = end;
    glm::ivec3 last = begin;
    bool all = true;
    ValueRange range;
    for (int z = begin.z; z < end.z; ++z)
    {
      for (int y = begin.y; y < end.y; ++y)
      {
        for (int x = begin.x; x < end.x; ++x)
        {
          const std::size_t macrocell =
            grid.firstRange + x + n.x * (y + static_cast<std::size_t>(n.y) * z);
          const bool shown = this->ShowsMacrocell(macrocell);
          if (shown)
          {
            range.add(this->Ranges.macrocells[macrocell]);
            first = glm::min(first, glm::ivec3(x, y, z));
            last = glm::max(last, glm::ivec3(x, y, z) + 1);
          }
          all = all && shown;
        }
      }
    }
    if (first.x >= last.x)
    {
      return {};
    }
    if (all)
    {
      return this->Show(region, width, grid.corner(region, begin), grid.corner(region, end), range);
    }
    const auto join = [&](int axis, int middle, bool lower, bool upper)
    {
      glm::ivec3 lowerEnd = end;
      glm::ivec3 upperBegin = begin;
      lowerEnd[axis] = upperBegin[axis] = middle;
      return this->Made.join(
        axis, grid.corner(region, glm::ivec3(middle))[axis],
        [&] { return lower ? this->Cut(region, width, grid, begin, lowerEnd) : Subtree(); },
        [&] { return upper ? this->Cut(region, width, grid, upperBegin, end) : Subtree(); });
    };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (begin[axis] < first[axis])
      {
        return join(axis, first[axis], false, true);
      }
      if (last[axis] < end[axis])
      {
        return join(axis, last[axis], true, false);
      }
    }
    const int axis = longestAxis(end - begin);
    return join(axis, (begin[axis] + end[axis]) / 2, true, true);
  }

  Subtree Show(const layout::Region& region, int width, const glm::ivec3& lo, const glm::ivec3& hi,
    const ValueRange& range)
  {
    const auto bricks = this->Tree.brickLists.begin() + region.firstBrick;
    const bool absent = this->AnyAbsentCells &&
      std::any_of(bricks, bricks + region.brickCount,
        [this](std::uint32_t brick) { return this->BrickHasAbsentCells[brick] != 0; });
    const double cells = this->Weights ? this->Weights->step(range, width) : 1.0;
    const float length = static_cast<float>(cells * 2.0 * width);
    const float step = absent ? -length : length;
    layout::KdNode leaf{ 0, makeLink(region.firstBrick, layout::KD_LEAF) };
    std::memcpy(&leaf.plane, &step, sizeof step);
    ActiveRegions& result = this->Made.result();
    ++result.boxCount;
    if (this->Form.boxes)
    {
      result.boxes.push_back({ lo, region.firstBrick, hi, step });
      if (this->Made.wantsExtremes())
      {
        result.boxExtremes.push_back(this->Made.extremeOf(range));
      }
    }
    return { leaf, range };
  }

  const Box Part;     // in half cells from the bounds' lower corner
  const bool IsWhole; // it is all there is
  const RegionTree& Tree;
  const std::vector<unsigned char>& BrickHasAbsentCells;
  const std::vector<unsigned char>& BrickHasUndefinedCells;
  const bool AnyAbsentCells;
  const ValueRanges& Ranges;
  const std::vector<Shown>& Components;
  const StepWeights* Weights;
  const ActiveForm Form;
  TreeMaker Made;
  Subtree Root;
  std::size_t NextGrid = 0;
};

// The regions' tree is cut into subtrees that are selected at once, and what comes of them is put
// together.
class ParallelSelection
{
public:
  ParallelSelection(const RegionTree& tree, const ActiveForm& form)
    : Tree(tree)
    , Depth(tree.regions.size() < WorthIt ? 0 : DepthOfSubtrees)
    , Made(form.extreme)
  {
    this->List(0, this->Depth);
  }

  template <typename MakeSelection>
  ActiveRegions select(const MakeSelection& makeSelection)
  {
    this->Selected.resize(this->Subtrees.size());
    FirstException failure;
#pragma omp parallel for schedule(dynamic, 1) if (this->Subtrees.size() > 1)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(this->Subtrees.size()); ++i)
    {
      failure.guard(
        [&]
        {
          const auto k = static_cast<std::size_t>(i);
          this->Selected[k] = makeSelection();
          this->Selected[k]->selectBelow(this->Subtrees[k]);
        });
    }
    failure.rethrow();
    this->PutTogether();
    return this->Made.take(this->Merge(0, this->Depth));
  }

private:
  // Below that threads would wait for each other longer than they work.
  static constexpr std::size_t WorthIt = 4096;
  // A few hundred subtrees, of which some take much longer than others.
  static constexpr int DepthOfSubtrees = 8;

  bool IsSubtree(std::size_t node, int depth) const
  {
    return depth == 0 || (this->Tree.nodes[node].link & 3) == layout::KD_LEAF;
  }

  void List(std::size_t node, int depth)
  {
    if (this->IsSubtree(node, depth))
    {
      this->Subtrees.push_back(node);
      return;
    }
    const std::size_t lower = this->Tree.nodes[node].link >> 2;
    this->List(lower, depth - 1);
    this->List(lower + 1, depth - 1);
  }

  void PutTogether()
  {
    TreeMaker::Place end;
    for (const std::unique_ptr<Selection>& selected : this->Selected)
    {
      this->Places.push_back(end);
      end.pass(selected->made());
      this->Made.count(selected->made());
    }
    checkIndex(end.nodes); // before any thread makes a link
    this->Made.makeRoom(end);
#pragma omp parallel for schedule(dynamic, 1) if (this->Subtrees.size() > 1)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(this->Subtrees.size()); ++i)
    {
      const auto k = static_cast<std::size_t>(i);
      this->Made.put(this->Selected[k]->made(), this->Places[k]);
    }
  }

  // What is above the subtrees, in the order of the list.
  Subtree Merge(std::size_t node, int depth)
  {
    if (this->IsSubtree(node, depth))
    {
      Subtree root = this->Selected[this->Next]->root();
      root.node = TreeMaker::moved(root.node, this->Places[this->Next++]);
      return root;
    }
    const layout::KdNode& split = this->Tree.nodes[node];
    const std::size_t lower = split.link >> 2;
    return this->Made.join(
      static_cast<int>(split.link & 3), split.plane, [&] { return this->Merge(lower, depth - 1); },
      [&] { return this->Merge(lower + 1, depth - 1); });
  }

  const RegionTree& Tree;
  const int Depth;
  TreeMaker Made;
  std::vector<std::size_t> Subtrees; // their nodes
  std::vector<std::unique_ptr<Selection>> Selected;
  std::vector<TreeMaker::Place> Places; // of what was selected
  std::size_t Next = 0;
};

ActiveRegions select(const Volume& volume, const ValueRanges& ranges,
  const std::vector<Shown>& shown, const StepWeights* weights, const ActiveForm& form)
{
  const RegionTree& tree = volume.structure->tree;
  if (tree.nodes.empty())
  {
    return {};
  }
  const std::vector<unsigned char>& absent = volume.values->brickHasAbsentCells;
  const bool anyAbsentCells =
    std::any_of(absent.begin(), absent.end(), [](unsigned char hasThem) { return hasThem != 0; });
  return ParallelSelection(tree, form)
    .select(
      [&] {
        return std::make_unique<Selection>(volume, ranges, shown, weights, form, anyAbsentCells);
      });
}
}

ActiveRegions selectActiveRegions(const Volume& volume, const TransferFunction& transfer,
  const StepWeights* weights, const ActiveForm& form)
{
  return selectActiveRegions(volume, std::vector{ &transfer }, weights, form);
}

ActiveRegions selectActiveRegions(const Volume& volume,
  const std::vector<const TransferFunction*>& transfers, const StepWeights* weights,
  const ActiveForm& form)
{
  std::vector<Shown> shown;
  for (std::size_t k = 0; k < transfers.size(); ++k)
  {
    if (transfers[k])
    {
      shown.push_back({ &volume.valuesOf(k)->ranges, transfers[k] });
    }
  }
  return select(volume, volume.values->ranges, shown, weights, form);
}

ActiveRegions selectAllRegions(const Volume& volume, const ActiveForm& form)
{
  ValueRanges whole;
  whole.regions.assign(volume.structure->tree.regions.size(), { 0.0f, 1.0f });
  whole.splits.assign(volume.structure->tree.nodes.size() / 2, { 0.0f, 1.0f });
  const TransferFunction opaque({ { 0.0, glm::dvec4(1.0) } });
  return select(volume, whole, { { &whole, &opaque } }, nullptr, form);
}

void sortByMedianSplits(ActiveRegions& active)
{
  const std::vector<layout::ActiveBox>& boxes = active.boxes;
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto center = [](const layout::ActiveBox& box, int axis)
  { return std::int64_t(box.lo[axis]) + box.hi[axis]; };
  std::vector<std::pair<std::size_t, std::size_t>> ranges{ { 0, boxes.size() } };
  while (!ranges.empty())
  {
    const auto range = ranges.back();
    ranges.pop_back();
    if (range.second - range.first < 3)
    {
      continue;
    }
    Int3 lo(std::numeric_limits<std::int64_t>::max());
    Int3 hi(std::numeric_limits<std::int64_t>::min());
    for (std::size_t i = range.first; i < range.second; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        lo[axis] = std::min(lo[axis], center(boxes[order[i]], axis));
        hi[axis] = std::max(hi[axis], center(boxes[order[i]], axis));
      }
    }
    const int axis = longestAxis(hi - lo);
    const std::size_t middle = range.first + (range.second - range.first) / 2;
    std::nth_element(order.begin() + range.first, order.begin() + middle,
      order.begin() + range.second,
      [&](std::size_t a, std::size_t b)
      { return center(boxes[a], axis) < center(boxes[b], axis); });
    ranges.emplace_back(range.first, middle);
    ranges.emplace_back(middle, range.second);
  }
  ActiveRegions sorted;
  sorted.boxes.reserve(boxes.size());
  sorted.boxExtremes.reserve(active.boxExtremes.size());
  for (const std::size_t i : order)
  {
    sorted.boxes.push_back(active.boxes[i]);
    if (!active.boxExtremes.empty())
    {
      sorted.boxExtremes.push_back(active.boxExtremes[i]);
    }
  }
  active.boxes = std::move(sorted.boxes);
  active.boxExtremes = std::move(sorted.boxExtremes);
}
}
