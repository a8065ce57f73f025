// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Regions.h"

#include "Core/KdLink.h"

#include <limits>

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

class Builder
{
public:
  Builder(const std::vector<Brick>& bricks, const Box& bounds,
    const std::vector<std::int64_t>& cellWidth, const RegionLimits& limits,
    const Progress& progress, const std::optional<Box>& shown, bool whole)
    : Limits(limits)
    , Report(progress)
  {
    this->Tree.bounds = bounds;
    this->Tree.size = glm::ivec3(bounds.size() * std::int64_t(2));
    this->Bricks.reserve(bricks.size());
    this->Supports.reserve(bricks.size());
    this->Widths.reserve(bricks.size());
    const Int3 size(this->Tree.size);
    const Int3 corner = bounds.lo * std::int64_t(2);
    const Box bounded{ Int3(0), size };
    this->Shown = shown ? Box{ shown->lo - corner, shown->hi - corner } : bounded;
    const Box part = whole ? bounded : this->Shown;
    const auto inPart = [&](const Int3& lo, const Int3& hi) {
      return HalfBox{ glm::ivec3(glm::max(lo, part.lo)), glm::ivec3(glm::min(hi, part.hi)) };
    };
    for (const Brick& brick : bricks)
    {
      const std::int64_t width = cellWidth[brick.level];
      const Box box = brick.box(width);
      const Int3 lo = (box.lo - bounds.lo) * std::int64_t(2);
      const Int3 hi = (box.hi - bounds.lo) * std::int64_t(2);
      this->Bricks.push_back(inPart(lo, hi));
      this->Widths.push_back(width);
      this->Supports.push_back(inPart(glm::max(lo - width, Int3(0)), glm::min(hi + width, size)));
    }
  }

  RegionTree build()
  {
    this->Lists.reserve(this->Supports.size());
    for (std::size_t i = 0; i < this->Supports.size(); ++i)
    {
      const std::uint32_t index = checkIndex(i);
      if (!this->Supports[i].empty())
      {
        this->Lists.push_back(index);
      }
    }
    this->Tree.nodes.push_back({});
    this->BuildNode({ glm::ivec3(0), this->Tree.size }, 0, 0, 1.0);
    if (this->Aborted)
    {
      this->Tree.nodes.clear();
    }
    this->Tree.nodes.shrink_to_fit();
    this->Tree.regions.shrink_to_fit();
    this->Tree.brickLists.shrink_to_fit();
    this->Tree.finestCells.shrink_to_fit();
    return std::move(this->Tree);
  }

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
      volume += commonVolume(box, this->Bricks[this->Lists[i]]);
    }
    return volume.empty()                ? Cover::None
      : volume == commonVolume(box, box) ? Cover::Full
                                         : Cover::Partial;
  }

  // Whether the node's list is short enough for a region.
  bool IsFew(const HalfBox& box, std::size_t begin) const
  {
    const std::size_t count = this->Lists.size() - begin;
    if (count > static_cast<std::size_t>(this->Limits.smallBricks))
    {
      return count <= static_cast<std::size_t>(this->Limits.bricks);
    }
    const glm::ivec3 size = box.hi - box.lo;
    return count <= static_cast<std::size_t>(this->Limits.bricks) ||
      std::max({ size.x, size.y, size.z }) <=
      2 * this->Limits.smallCells * this->FinestOfList(begin);
  }

  std::int64_t FinestOfList(std::size_t begin) const
  {
    std::int64_t finest = std::numeric_limits<int>::max();
    for (std::size_t i = begin; i < this->Lists.size(); ++i)
    {
      finest = std::min(finest, this->Widths[this->Lists[i]]);
    }
    return finest;
  }

  // The node's list is the end of Lists, from `begin` on; `fraction` is its part of the whole work.
  void BuildNode(const HalfBox& box, std::size_t node, std::size_t begin, double fraction)
  {
    if (this->Aborted)
    {
      return;
    }
    if (!this->Shown.intersects({ Int3(box.lo), Int3(box.hi) }))
    {
      this->AddRegion(box, node, this->Lists.size(), fraction);
      return;
    }
    const std::size_t count = this->Lists.size() - begin;
    this->Best = {};
    if (count > ExactCount)
    {
      this->ChooseMedian(box, begin);
    }
    if (this->Best.axis < 0)
    {
      const Cover cover = this->FindCover(box, begin);
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
    for (int side = 0; side < 2; ++side)
    {
      HalfBox part = box;
      (side ? part.lo : part.hi)[axis] = plane;
      const std::size_t end = begin + count;
      for (std::size_t i = begin; i < end; ++i)
      {
        const HalfBox& support = this->Supports[this->Lists[i]];
        if (side ? support.hi[axis] > plane : support.lo[axis] < plane)
        {
          const std::uint32_t brick = this->Lists[i];
          this->Lists.push_back(brick);
        }
      }
      // The child's list begins where the node's ends.
      this->BuildNode(part, child + side, end, fraction * 0.5);
      this->Lists.resize(end);
    }
  }

  void AddRegion(const HalfBox& box, std::size_t node, std::size_t begin, double fraction)
  {
    const std::size_t region = this->Tree.regions.size();
    this->Tree.nodes[node] = { 0, makeLink(region, layout::KD_LEAF) };
    this->Tree.regions.push_back({ box.lo, checkIndex(this->Tree.brickLists.size()), box.hi,
      static_cast<std::uint32_t>(this->Lists.size() - begin) });
    this->Tree.brickLists.insert(
      this->Tree.brickLists.end(), this->Lists.begin() + begin, this->Lists.end());
    this->Tree.finestCells.push_back(begin < this->Lists.size() ? this->FinestOfList(begin) : 0);
    this->Done += fraction;
    if (this->Report && region % 4096 == 0)
    {
      this->Aborted = !this->Report(std::min(this->Done, 1.0));
    }
  }

  struct Candidate
  {
    int axis = -1;
    int position = 0;
  };

  // Finds the face inside the node at which cutting it costs least: area times length of list, both
  // children added. That isolates boxes with short lists, where most samples are. Faces of supports
  // count only while the list is too long, faces of bricks only where the node lies in data in
  // part.
  void ChoosePlane(const HalfBox& box, std::size_t begin, bool cutSupports, bool cutBricks)
  {
    double bestCost = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Positions.clear();
      for (std::size_t i = begin; i < this->Lists.size(); ++i)
      {
        const HalfBox& support = this->Supports[this->Lists[i]];
        const HalfBox& brick = this->Bricks[this->Lists[i]];
        for (const int position :
          { cutSupports ? support.lo[axis] : 0, cutSupports ? support.hi[axis] : 0,
            cutBricks ? brick.lo[axis] : 0, cutBricks ? brick.hi[axis] : 0 })
        {
          if (position > box.lo[axis] && position < box.hi[axis])
          {
            this->Positions.push_back(position);
          }
        }
      }
      std::sort(this->Positions.begin(), this->Positions.end());
      this->Positions.erase(
        std::unique(this->Positions.begin(), this->Positions.end()), this->Positions.end());
      for (const int position : this->Positions)
      {
        HalfBox lower = box;
        HalfBox upper = box;
        lower.hi[axis] = upper.lo[axis] = position;
        int lowerCount = 0;
        int upperCount = 0;
        for (std::size_t i = begin; i < this->Lists.size(); ++i)
        {
          const HalfBox& support = this->Supports[this->Lists[i]];
          lowerCount += support.lo[axis] < position;
          upperCount += support.hi[axis] > position;
        }
        const double cost = lower.area() * lowerCount + upper.area() * upperCount;
        if (cost < bestCost)
        {
          bestCost = cost;
          this->Best = { axis, position };
        }
      }
    }
  }

  // Finds the face of a support that is nearest to the middle of the longest axis that has one, to
  // halve a long list.
  void ChooseMedian(const HalfBox& box, std::size_t begin)
  {
    const glm::ivec3 size = box.hi - box.lo;
    std::int64_t bestScore = std::numeric_limits<std::int64_t>::min();
    for (std::size_t i = begin; i < this->Lists.size(); ++i)
    {
      const HalfBox& support = this->Supports[this->Lists[i]];
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
              this->Best = { axis, position };
            }
          }
        }
      }
    }
  }

  // Longer lists are split at the middle, shorter ones by cost.
  static constexpr std::size_t ExactCount = 24;

  const RegionLimits Limits;
  const Progress& Report;
  RegionTree Tree;
  Box Shown; // half cells from the bounds' lower corner
  std::vector<HalfBox> Bricks;
  std::vector<HalfBox> Supports;
  std::vector<std::int64_t> Widths; // of the bricks' cells, finest cells
  std::vector<std::uint32_t> Lists; // a stack of the lists of the nodes on the current path
  double Done = 0.0;
  bool Aborted = false;
  Candidate Best;
  std::vector<int> Positions;
};
}

RegionTree buildRegions(const std::vector<Brick>& bricks, const Box& bounds,
  const std::vector<std::int64_t>& cellWidth, const RegionLimits& limits, const Progress& progress,
  const std::optional<Box>& shown, bool whole)
{
  return Builder(bricks, bounds, cellWidth, limits, progress, shown, whole).build();
}
}
