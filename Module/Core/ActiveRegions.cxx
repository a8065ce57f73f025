// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ActiveRegions.h"

#include "Core/KdLink.h"

#include <algorithm>
#include <cstring>
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

class Selection
{
public:
  // `ranges`: of the first component, by which steps are weighted.
  Selection(const Volume& volume, const ValueRanges& ranges, std::vector<Shown> shown,
    const StepWeights* weights, const ActiveForm& form)
    : Subject(*volume.structure)
    , Tree(volume.structure->tree)
    , BrickHasAbsentCells(volume.values->brickHasAbsentCells)
    , BrickHasUndefinedCells(volume.values->brickHasUndefinedCells)
    , Ranges(ranges)
    , Components(std::move(shown))
    , Weights(weights)
    , Form(form)
  {
    if (!this->Tree.nodes.empty())
    {
      this->Resize(1);
      this->Put(0, this->Select(0));
    }
  }

  ActiveRegions take() { return std::move(this->Result); }

private:
  bool WantsExtremes() const { return this->Form.extreme != Extreme::None; }

  float ExtremeOf(const ValueRange& range) const
  {
    return this->Form.extreme == Extreme::Greatest ? range.max : range.min;
  }

  void Resize(std::size_t nodes)
  {
    this->Result.nodes.resize(nodes);
    this->Result.nodeExtremes.resize(this->WantsExtremes() ? nodes : 0);
  }

  void Put(std::size_t place, const Subtree& subtree)
  {
    this->Result.nodes[place] = subtree.node;
    if (this->WantsExtremes())
    {
      this->Result.nodeExtremes[place] = this->ExtremeOf(subtree.range);
    }
  }

  // Makes room for two children side by side, fills it with what `lower` and `upper` return, and
  // returns the node above them: Nothing, if both children are.
  template <typename Lower, typename Upper>
  Subtree Join(int axis, int plane, const Lower& lower, const Upper& upper)
  {
    const std::size_t place = this->Result.nodes.size();
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

  // Of a part of a hierarchy there are regions around what is shown.
  bool IsInPart(const layout::Region& region) const
  {
    // Also one that ends at its face: the cell before a surface may be in it.
    return this->Subject.shown().intersects(
      { Int3(region.lo) - std::int64_t(1), Int3(region.hi) + std::int64_t(1) });
  }

  bool ShowsUndefined(const layout::Region& region) const
  {
    const auto first = this->Tree.brickLists.begin() + region.firstBrick;
    return this->Form.undefined && !this->BrickHasUndefinedCells.empty() &&
      std::any_of(first, first + region.brickCount,
        [this](std::uint32_t brick) { return this->BrickHasUndefinedCells[brick] != 0; });
  }

  bool ShowsRegion(std::uint32_t region) const
  {
    return std::any_of(this->Components.begin(), this->Components.end(),
      [=](const Shown& of) { return of.transfer->visible(of.ranges->regions[region]); });
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
      return this->Join(
        node.link & 3, node.plane, [&] { return this->Select(index); },
        [&] { return this->Select(index + 1); });
    }
    const layout::Region& region = this->Tree.regions[index];
    const std::vector<MacrocellGrid>& grids = this->Ranges.grids;
    // Leaves come in the order of regions, as grids do.
    while (this->NextGrid < grids.size() && grids[this->NextGrid].region < index)
    {
      ++this->NextGrid;
    }
    const bool undefined = this->ShowsUndefined(region);
    if (region.brickCount == 0 || !this->IsInPart(region) ||
      (!undefined && !this->ShowsRegion(index)))
    {
      return {};
    }
    ++this->Result.regions;
    if (undefined || this->NextGrid == grids.size() || grids[this->NextGrid].region != index)
    {
      return this->Show(region, region.lo, region.hi, this->Ranges.regions[index]);
    }
    const MacrocellGrid& grid = grids[this->NextGrid];
    return this->Cut(region, grid, glm::ivec3(0), grid.count(region));
  }

  // Selects among the macrocells of a region from `begin` up to `end`: layers that show nothing are
  // cut off, side by side, and where there are none, the macrocells are halved.
  Subtree Cut(const layout::Region& region, const MacrocellGrid& grid, const glm::ivec3& begin,
    const glm::ivec3& end)
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
      return this->Show(region, grid.corner(region, begin), grid.corner(region, end), range);
    }
    const auto join = [&](int axis, int middle, bool lower, bool upper)
    {
      glm::ivec3 lowerEnd = end;
      glm::ivec3 upperBegin = begin;
      lowerEnd[axis] = upperBegin[axis] = middle;
      return this->Join(
        axis, grid.corner(region, glm::ivec3(middle))[axis],
        [&] { return lower ? this->Cut(region, grid, begin, lowerEnd) : Subtree(); },
        [&] { return upper ? this->Cut(region, grid, upperBegin, end) : Subtree(); });
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

  Subtree Show(const layout::Region& region, const glm::ivec3& lo, const glm::ivec3& hi,
    const ValueRange& range)
  {
    std::int64_t width = std::numeric_limits<std::int64_t>::max();
    bool absent = false;
    for (std::uint32_t k = 0; k < region.brickCount; ++k)
    {
      const std::uint32_t brick = this->Tree.brickLists[region.firstBrick + k];
      width = std::min(width, this->Subject.width(this->Subject.bricks[brick]));
      absent = absent || this->BrickHasAbsentCells[brick];
    }
    if (!this->Tree.finestCells.empty())
    {
      width = this->Tree.finestCells[static_cast<std::size_t>(&region - this->Tree.regions.data())];
    }
    const double cells =
      this->Weights ? this->Weights->step(range, static_cast<double>(width)) : 1.0;
    const float length = static_cast<float>(cells * 2.0 * static_cast<double>(width));
    const float step = absent ? -length : length;
    layout::KdNode leaf{ 0, makeLink(region.firstBrick, layout::KD_LEAF) };
    std::memcpy(&leaf.plane, &step, sizeof step);
    ++this->Result.boxCount;
    if (this->Form.boxes)
    {
      this->Result.boxes.push_back({ lo, region.firstBrick, hi, step });
      if (this->WantsExtremes())
      {
        this->Result.boxExtremes.push_back(this->ExtremeOf(range));
      }
    }
    return { leaf, range };
  }

  const Structure& Subject;
  const RegionTree& Tree;
  const std::vector<unsigned char>& BrickHasAbsentCells;
  const std::vector<unsigned char>& BrickHasUndefinedCells;
  const ValueRanges& Ranges;
  const std::vector<Shown> Components;
  const StepWeights* Weights;
  const ActiveForm Form;
  ActiveRegions Result;
  std::size_t NextGrid = 0;
};
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
  return Selection(volume, volume.values->ranges, std::move(shown), weights, form).take();
}

ActiveRegions selectAllRegions(const Volume& volume, const ActiveForm& form)
{
  ValueRanges whole;
  whole.regions.assign(volume.structure->tree.regions.size(), { 0.0f, 1.0f });
  const TransferFunction opaque({ { 0.0, glm::dvec4(1.0) } });
  return Selection(volume, whole, { { &whole, &opaque } }, nullptr, form).take();
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
