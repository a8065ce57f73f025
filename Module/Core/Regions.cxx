// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Regions.h"

#include "Core/FirstException.h"
#include "Core/KdLink.h"
#include "Core/SharedProgress.h"

#include <limits>
#include <memory>

namespace exabricks
{
namespace
{
// In half cells from the bounds' lower corner.
struct HalfBox
{
  glm::ivec3 lo, hi;

  bool empty() const { return glm::any(glm::lessThanEqual(this->hi, this->lo)); }

  double area() const
  {
    const glm::dvec3 s = glm::dvec3(this->hi) - glm::dvec3(this->lo);
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
};

LatticeVolume commonVolume(const HalfBox& a, const HalfBox& b)
{
  const Int3 size = Int3(glm::min(a.hi, b.hi)) - Int3(glm::max(a.lo, b.lo));
  const glm::u64vec3 length(glm::max(size, Int3(0)));
  return { length.x, length.y, length.z };
}

struct Candidate
{
  int axis = -1;
  int position = 0;
};

// What regions are made of, in half cells from the bounds' lower corner.
struct Given
{
  RegionLimits limits;
  Box shown;
  std::vector<HalfBox> bricks;
  std::vector<HalfBox> supports;
  std::vector<std::int64_t> widths; // of the bricks' cells, finest cells
};

// Finds the face of a support that is nearest to the middle of the longest axis that has one, to
// halve a long list.
template <typename Iterator>
Candidate chooseMedian(const Given& given, const HalfBox& box, Iterator first, Iterator last)
{
  Candidate best;
  const glm::ivec3 size = box.hi - box.lo;
  std::int64_t bestScore = std::numeric_limits<std::int64_t>::min();
  for (; first != last; ++first)
  {
    const HalfBox& support = given.supports[*first];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int position : { support.lo[axis], support.hi[axis] })
      {
        if (position > box.lo[axis] && position < box.hi[axis])
        {
          const std::int64_t off =
            std::abs(2 * (std::int64_t(position) - box.lo[axis]) - std::int64_t(size[axis]));
          const std::int64_t score = std::int64_t(size[axis]) - off;
          if (score > bestScore)
          {
            bestScore = score;
            best = { axis, position };
          }
        }
      }
    }
  }
  return best;
}

// Whether a support reaches into the lower or the upper side of a plane.
bool reaches(const HalfBox& support, int axis, int plane, bool upper)
{
  return upper ? support.hi[axis] > plane : support.lo[axis] < plane;
}

HalfBox sideOf(HalfBox box, int axis, int plane, bool upper)
{
  (upper ? box.lo : box.hi)[axis] = plane;
  return box;
}

// The regions of one subtree.
class Branch
{
public:
  Branch(const Given& given, SharedProgress& progress)
    : Of(given)
    , Watched(progress)
  {
  }

  void build(const HalfBox& box, std::vector<std::uint32_t> list, double fraction)
  {
    this->Lists = std::move(list);
    this->Tree.nodes.push_back({});
    this->BuildNode(box, 0, 0, Cover::Partial, fraction);
    this->Lists = {};
  }

  /// Without bounds.
  RegionTree& tree() { return this->Tree; }

private:
  enum class Cover
  {
    None,
    Partial,
    Full
  };

  Cover FindCover(const HalfBox& box, std::size_t begin) const
  {
    LatticeVolume volume;
    for (std::size_t i = begin; i < this->Lists.size(); ++i)
    {
      volume += commonVolume(box, this->Of.bricks[this->Lists[i]]);
    }
    return volume.empty()                ? Cover::None
      : volume == commonVolume(box, box) ? Cover::Full
                                         : Cover::Partial;
  }

  // Whether the node's list is short enough for a region.
  bool IsFew(const HalfBox& box, std::size_t begin) const
  {
    const std::size_t count = this->Lists.size() - begin;
    if (count > static_cast<std::size_t>(this->Of.limits.smallBricks))
    {
      return count <= static_cast<std::size_t>(this->Of.limits.bricks);
    }
    const glm::ivec3 size = box.hi - box.lo;
    return count <= static_cast<std::size_t>(this->Of.limits.bricks) ||
      std::max({ size.x, size.y, size.z }) <=
      2 * this->Of.limits.smallCells * this->FinestOfList(begin);
  }

  std::int64_t FinestOfList(std::size_t begin) const
  {
    std::int64_t finest = std::numeric_limits<int>::max();
    for (std::size_t i = begin; i < this->Lists.size(); ++i)
    {
      finest = std::min(finest, this->Of.widths[this->Lists[i]]);
    }
    return finest;
  }

  // The node's list is the end of Lists, from `begin` on; `fraction` is its part of the whole work.
  // `cover`: of a node around this one, which is that of this one unless it is Partial.
  void BuildNode(
    const HalfBox& box, std::size_t node, std::size_t begin, Cover cover, double fraction)
  {
    if (this->Watched.aborted())
    {
      return;
    }
    if (!this->Of.shown.intersects({ Int3(box.lo), Int3(box.hi) }))
    {
      this->AddRegion(box, node, this->Lists.size(), fraction);
      return;
    }
    const std::size_t count = this->Lists.size() - begin;
    this->Best = {};
    if (count > ExactCount)
    {
      this->Best = chooseMedian(
        this->Of, box, this->Lists.begin() + static_cast<std::ptrdiff_t>(begin), this->Lists.end());
    }
    if (this->Best.axis < 0)
    {
      cover = cover == Cover::Partial ? this->FindCover(box, begin) : cover;
      if (cover != Cover::None)
      {
        this->ChoosePlane(box, begin, !this->IsFew(box, begin), cover == Cover::Partial);
      }
      if (this->Best.axis < 0)
      {
        this->AddRegion(box, node, cover == Cover::None ? this->Lists.size() : begin, fraction);
        return;
      }
    }

    const int axis = this->Best.axis;
    const int plane = this->Best.position;
    const std::size_t child = this->Tree.nodes.size();
    this->Tree.nodes[node] = { plane, makeLink(child, static_cast<std::uint32_t>(axis)) };
    this->Tree.nodes.resize(child + 2);
    for (const bool upper : { false, true })
    {
      const std::size_t end = begin + count;
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::uint32_t brick = this->Lists[i];
        if (reaches(this->Of.supports[brick], axis, plane, upper))
        {
          this->Lists.push_back(brick);
        }
      }
      // The child's list begins where the node's ends.
      this->BuildNode(sideOf(box, axis, plane, upper), child + upper, end, cover, fraction * 0.5);
      this->Lists.resize(end);
    }
  }

  void AddRegion(const HalfBox& box, std::size_t node, std::size_t begin, double fraction)
  {
    const std::size_t region = this->Tree.regions.size();
    const std::int64_t finest = begin < this->Lists.size() ? this->FinestOfList(begin) : 0;
    this->Tree.nodes[node] = { static_cast<int>(finest), makeLink(region, layout::KD_LEAF) };
    this->Tree.regions.push_back({ box.lo, checkIndex(this->Tree.brickLists.size()), box.hi,
      static_cast<std::uint32_t>(this->Lists.size() - begin) });
    this->Tree.brickLists.insert(
      this->Tree.brickLists.end(), this->Lists.begin() + begin, this->Lists.end());
    this->Watched.pass(fraction);
  }

  // Finds the face inside the node at which cutting it costs least: area times length of list, both
  // children added. That isolates boxes with short lists, where most samples are. Faces of supports
  // count only while the list is too long, faces of bricks only where the node lies in data in
  // part.
  void ChoosePlane(const HalfBox& box, std::size_t begin, bool cutSupports, bool cutBricks)
  {
    double bestCost = std::numeric_limits<double>::max();
    const std::size_t count = this->Lists.size() - begin;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Positions.clear();
      this->Lowest.resize(count);
      this->Highest.resize(count);
      for (std::size_t i = 0; i < count; ++i)
      {
        const HalfBox& support = this->Of.supports[this->Lists[begin + i]];
        this->Lowest[i] = support.lo[axis];
        this->Highest[i] = support.hi[axis];
        if (cutSupports)
        {
          this->AddPosition(box, axis, support.lo[axis]);
          this->AddPosition(box, axis, support.hi[axis]);
        }
        if (cutBricks)
        {
          const HalfBox& brick = this->Of.bricks[this->Lists[begin + i]];
          this->AddPosition(box, axis, brick.lo[axis]);
          this->AddPosition(box, axis, brick.hi[axis]);
        }
      }
      for (const int position : this->Positions)
      {
        int lowerCount = 0;
        int upperCount = 0;
        for (std::size_t i = 0; i < count; ++i)
        {
          lowerCount += this->Lowest[i] < position;
          upperCount += this->Highest[i] > position;
        }
        const double cost = sideOf(box, axis, position, false).area() * lowerCount +
          sideOf(box, axis, position, true).area() * upperCount;
        // Of equal ones the first axis, and on it the lowest position.
        const bool isLower = this->Best.axis == axis && position < this->Best.position;
        if (cost < bestCost || (cost == bestCost && isLower))
        {
          bestCost = cost;
          this->Best = { axis, position };
        }
      }
    }
  }

  // Lists are short: to search them takes less time than to sort them.
  void AddPosition(const HalfBox& box, int axis, int position)
  {
    if (position > box.lo[axis] && position < box.hi[axis] &&
      std::find(this->Positions.begin(), this->Positions.end(), position) == this->Positions.end())
    {
      this->Positions.push_back(position);
    }
  }

  // Longer lists are split at the middle, shorter ones by cost.
  static constexpr std::size_t ExactCount = 24;

  const Given& Of;
  SharedProgress& Watched;
  RegionTree Tree;
  std::vector<std::uint32_t> Lists; // a stack of the lists of the nodes on the current path
  Candidate Best;
  // Scratch of ChoosePlane.
  std::vector<int> Lowest;
  std::vector<int> Highest;
  std::vector<int> Positions;
};

// Halves the bounds until lists are short enough for branches, which are made at once, and puts
// these together. What comes of it does not depend on the number of threads.
class Builder
{
public:
  Builder(const std::vector<Brick>& bricks, const Box& bounds,
    const std::vector<std::int64_t>& cellWidth, const RegionLimits& limits,
    const Progress& progress, const std::optional<Box>& shown, bool whole)
    : Watched(progress)
  {
    this->Of.limits = limits;
    this->Tree.bounds = bounds;
    this->Tree.size = glm::ivec3(bounds.size() * std::int64_t(2));
    this->Of.bricks.reserve(bricks.size());
    this->Of.supports.reserve(bricks.size());
    this->Of.widths.reserve(bricks.size());
    const Int3 size(this->Tree.size);
    const Int3 corner = bounds.lo * std::int64_t(2);
    const Box bounded{ Int3(0), size };
    this->Of.shown = shown ? Box{ shown->lo - corner, shown->hi - corner } : bounded;
    const Box part = whole ? bounded : this->Of.shown;
    const auto inPart = [&](const Int3& lo, const Int3& hi) {
      return HalfBox{ glm::ivec3(glm::max(lo, part.lo)), glm::ivec3(glm::min(hi, part.hi)) };
    };
    for (const Brick& brick : bricks)
    {
      const std::int64_t width = cellWidth[brick.level];
      const Box box = brick.box(width);
      const Int3 lo = (box.lo - bounds.lo) * std::int64_t(2);
      const Int3 hi = (box.hi - bounds.lo) * std::int64_t(2);
      this->Of.bricks.push_back(inPart(lo, hi));
      this->Of.widths.push_back(width);
      this->Of.supports.push_back(
        inPart(glm::max(lo - width, Int3(0)), glm::min(hi + width, size)));
    }
  }

  RegionTree build()
  {
    std::vector<std::uint32_t> all;
    all.reserve(this->Of.supports.size());
    for (std::size_t i = 0; i < this->Of.supports.size(); ++i)
    {
      const std::uint32_t index = checkIndex(i);
      if (!this->Of.supports[i].empty())
      {
        all.push_back(index);
      }
    }
    this->Tree.nodes.push_back({});
    this->Split({ glm::ivec3(0), this->Tree.size }, 0, std::move(all), MostSplits, 1.0);
    this->MakeBranches();
    if (this->Watched.aborted())
    {
      return { this->Tree.bounds, this->Tree.size, {}, {}, {} };
    }
    this->PutTogether();
    return std::move(this->Tree);
  }

private:
  struct Subtree
  {
    HalfBox box;
    std::size_t node;
    std::vector<std::uint32_t> list;
    double fraction; // of all work
    std::unique_ptr<Branch> branch;
  };

  static constexpr int MostSplits = 6;
  // Lists that are shorter are made at once, whole.
  static constexpr std::size_t WorthIt = 1024;

  void Split(const HalfBox& box, std::size_t node, std::vector<std::uint32_t> list, int splits,
    double fraction)
  {
    const Candidate best = splits > 0 && list.size() > WorthIt &&
        this->Of.shown.intersects({ Int3(box.lo), Int3(box.hi) })
      ? chooseMedian(this->Of, box, list.begin(), list.end())
      : Candidate();
    if (best.axis < 0)
    {
      this->Subtrees.push_back({ box, node, std::move(list), fraction, nullptr });
      return;
    }
    const std::size_t child = this->Tree.nodes.size();
    this->Tree.nodes[node] = { best.position,
      makeLink(child, static_cast<std::uint32_t>(best.axis)) };
    this->Tree.nodes.resize(child + 2);
    for (const bool upper : { false, true })
    {
      std::vector<std::uint32_t> part;
      for (const std::uint32_t brick : list)
      {
        if (reaches(this->Of.supports[brick], best.axis, best.position, upper))
        {
          part.push_back(brick);
        }
      }
      this->Split(sideOf(box, best.axis, best.position, upper), child + upper, std::move(part),
        splits - 1, fraction * 0.5);
    }
  }

  void MakeBranches()
  {
    FirstException failure;
#pragma omp parallel for schedule(dynamic, 1) if (this->Subtrees.size() > 1)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(this->Subtrees.size()); ++i)
    {
      failure.guard(
        [&]
        {
          Subtree& subtree = this->Subtrees[static_cast<std::size_t>(i)];
          subtree.branch = std::make_unique<Branch>(this->Of, this->Watched);
          subtree.branch->build(subtree.box, std::move(subtree.list), subtree.fraction);
        });
    }
    failure.rethrow();
  }

  void PutTogether()
  {
    std::size_t nodes = this->Tree.nodes.size();
    std::size_t regions = 0;
    std::size_t listed = 0;
    for (const Subtree& subtree : this->Subtrees)
    {
      const RegionTree& tree = subtree.branch->tree();
      nodes += tree.nodes.size() - 1; // its root has a place
      regions += tree.regions.size();
      listed += tree.brickLists.size();
    }
    checkIndex(nodes);
    checkIndex(regions);
    this->Tree.nodes.reserve(nodes);
    this->Tree.regions.reserve(regions);
    this->Tree.brickLists.reserve(listed);
    for (Subtree& subtree : this->Subtrees)
    {
      this->Append(subtree.branch->tree(), subtree.node);
      subtree.branch.reset();
    }
  }

  // Of a tree whose root is at a node of this one.
  void Append(const RegionTree& tree, std::size_t root)
  {
    const std::size_t firstNode = this->Tree.nodes.size();
    const std::size_t firstRegion = this->Tree.regions.size();
    const std::size_t firstListed = this->Tree.brickLists.size();
    const auto moved = [&](const layout::KdNode& node)
    { return moveLink(node, firstNode - 1, firstRegion); };
    this->Tree.nodes[root] = moved(tree.nodes.front());
    for (std::size_t i = 1; i < tree.nodes.size(); ++i)
    {
      this->Tree.nodes.push_back(moved(tree.nodes[i]));
    }
    for (layout::Region region : tree.regions)
    {
      region.firstBrick = checkIndex(region.firstBrick + firstListed);
      this->Tree.regions.push_back(region);
    }
    this->Tree.brickLists.insert(
      this->Tree.brickLists.end(), tree.brickLists.begin(), tree.brickLists.end());
  }

  Given Of;
  SharedProgress Watched;
  RegionTree Tree;
  std::vector<Subtree> Subtrees; // in the order of their leaves
};
}

RegionTree buildRegions(const std::vector<Brick>& bricks, const Box& bounds,
  const std::vector<std::int64_t>& cellWidth, const RegionLimits& limits, const Progress& progress,
  const std::optional<Box>& shown, bool whole)
{
  return Builder(bricks, bounds, cellWidth, limits, progress, shown, whole).build();
}
}
