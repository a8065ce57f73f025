// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Parts.h"

#include "Core/FirstException.h"
#include "Layout.h"

#include <array>
#include <cmath>

namespace exabricks
{
namespace
{
// Samples beyond a part lie no farther, as steps are of cells at most.
constexpr std::int64_t StepsBeyond = layout::PART_REACH;
// Of the coarsest level nearby: the cell that is extended, its neighbours by which its slope is
// found, and a cell of the level that is completed.
constexpr std::int64_t CellsToComplete = 3;
// How much more or less than wanted one side of a cut may have, of all.
constexpr double Imbalance = 0.0125;
// Fewer are looked through faster than threads are started.
constexpr std::size_t LeavesForThreads = 10000;
// What a cut costs, beside the area in which it goes through supports, of its whole area: cells on
// both sides of it are held twice.
constexpr double CostOfArea = 0.1;

Box grown(const Box& box, std::int64_t by) { return { box.lo - by, box.hi + by }; }

// A box in half cells, and how many cells there are to a volume of one.
struct Filled
{
  Box box;
  double density;
};

struct Candidate
{
  int axis = -1;
  std::int64_t plane = 0;
  double cost = 0.0;
};

double areaAcross(const Box& box, int axis)
{
  const glm::dvec3 size(box.size());
  return size[(axis + 1) % 3] * size[(axis + 2) % 3];
}

// A leaf box along one axis, and how many cells there are to a length of one.
struct Extent
{
  std::int64_t lo;
  std::int64_t hi;
  double cells;

  double below(std::int64_t plane) const
  {
    return this->cells *
      static_cast<double>(std::clamp<std::int64_t>(plane - this->lo, 0, this->hi - this->lo));
  }
};

std::vector<Extent> extentsAlong(const std::vector<Filled>& leaves, int axis)
{
  std::vector<Extent> extents;
  extents.reserve(leaves.size());
  for (const Filled& leaf : leaves)
  {
    extents.push_back(
      { leaf.box.lo[axis], leaf.box.hi[axis], leaf.density * areaAcross(leaf.box, axis) });
  }
  return extents;
}

double cellsBelow(const std::vector<Extent>& extents, std::int64_t plane)
{
  double cells = 0.0;
  for (const Extent& extent : extents)
  {
    cells += extent.below(plane);
  }
  return cells;
}

// The least plane of those from `low` to `high` with at least so many cells below. What is known to
// lie below or above it is not looked at again, so that all halvings cost about as much as two.
std::int64_t findPlane(std::vector<Extent> open, std::int64_t low, std::int64_t high, double cells)
{
  double settled = 0.0; // of those below
  while (low < high)
  {
    const std::int64_t middle = low + (high - low) / 2;
    const bool isAbove = settled + cellsBelow(open, middle) < cells;
    low = isAbove ? middle + 1 : low;
    high = isAbove ? high : middle;
    std::size_t kept = 0;
    for (const Extent& extent : open)
    {
      const bool isBelow = extent.hi <= low;
      settled += isBelow ? extent.below(low) : 0.0;
      if (!isBelow && extent.lo < high)
      {
        open[kept++] = extent;
      }
    }
    open.resize(kept);
  }
  return low;
}

class Cutter
{
public:
  explicit Cutter(Parts& parts)
    : Result(parts)
  {
  }

  /// `leaves` and `supports`: those in the box, cut at its faces.
  void cut(std::size_t node, const Box& box, const std::vector<Filled>& leaves,
    const std::vector<Box>& supports, int first, int count)
  {
    const int lowerCount = count / 2;
    const Candidate best = count == 1
      ? Candidate()
      : this->Choose(box, leaves, supports, static_cast<double>(lowerCount) / count);
    if (best.axis < 0)
    {
      // Where there is nothing to cut, all is for the first part.
      this->Result.cuts[node] = { -1, 0, first };
      this->Result.boxes[static_cast<std::size_t>(first)] = box;
      return;
    }
    const std::size_t child = this->Result.cuts.size();
    this->Result.cuts[node] = { best.axis, best.plane, static_cast<int>(child) };
    this->Result.cuts.resize(child + 2);
    const auto sides = split(box, best.axis, best.plane);
    for (const bool upper : { false, true })
    {
      const Box& side = upper ? sides.second : sides.first;
      std::vector<Filled> leavesWithin;
      for (const Filled& leaf : leaves)
      {
        const Box common = intersection(leaf.box, side);
        if (!common.empty())
        {
          leavesWithin.push_back({ common, leaf.density });
        }
      }
      std::vector<Box> supportsWithin;
      for (const Box& support : supports)
      {
        const Box common = intersection(support, side);
        if (!common.empty())
        {
          supportsWithin.push_back(common);
        }
      }
      this->cut(child + upper, side, leavesWithin, supportsWithin,
        upper ? first + lowerCount : first, upper ? count - lowerCount : lowerCount);
    }
  }

private:
  // Across which axis, and where.
  Candidate Choose(const Box& box, const std::vector<Filled>& leaves,
    const std::vector<Box>& supports, double fraction) const
  {
    std::array<Candidate, 3> candidates;
    FirstException failure;
#pragma omp parallel for schedule(dynamic) if (leaves.size() > LeavesForThreads)
    for (int axis = 0; axis < 3; ++axis)
    {
      failure.guard(
        [&] { candidates[axis] = this->ChooseAcross(axis, box, leaves, supports, fraction); });
    }
    failure.rethrow();
    Candidate best;
    for (const Candidate& candidate : candidates)
    {
      if (candidate.axis >= 0 && (best.axis < 0 || candidate.cost < best.cost))
      {
        best = candidate;
      }
    }
    return best;
  }

  // Of the planes that balance the cells, the one that goes through the fewest supports, as regions
  // end at their faces.
  Candidate ChooseAcross(int axis, const Box& box, const std::vector<Filled>& leaves,
    const std::vector<Box>& supports, double fraction) const
  {
    if (box.size()[axis] < 2)
    {
      return {};
    }
    const std::vector<Extent> extents = extentsAlong(leaves, axis);
    const double all = cellsBelow(extents, box.hi[axis]);
    if (!(all > 0.0))
    {
      return {};
    }
    const auto findShare = [&](double share)
    { return findPlane(extents, box.lo[axis] + 1, box.hi[axis] - 1, share * all); };
    const std::int64_t low = findShare(fraction - Imbalance);
    const std::int64_t ideal = findShare(fraction);
    const std::int64_t high = findShare(fraction + Imbalance);
    const std::int64_t plane = this->ChoosePlane(supports, axis, low, ideal, high);
    const double below = cellsBelow(extents, plane) / all;
    if (!(below > 0.0 && below < 1.0))
    {
      return {};
    }
    const double cost = this->AreaCut(supports, axis, plane) + CostOfArea * areaAcross(box, axis);
    const bool balanced = std::abs(below - fraction) <= 2.0 * Imbalance;
    // One that does not balance is better than none.
    const double whole = box.size().x * 4.0 * box.size().y + 4.0 * areaAcross(box, 0);
    return { axis, plane, balanced ? cost : cost + whole * 100.0 * std::abs(below - fraction) };
  }

  double AreaCut(const std::vector<Box>& supports, int axis, std::int64_t plane) const
  {
    double area = 0.0;
    for (const Box& support : supports)
    {
      area +=
        support.lo[axis] < plane && plane < support.hi[axis] ? areaAcross(support, axis) : 0.0;
    }
    return area;
  }

  std::int64_t ChoosePlane(const std::vector<Box>& supports, int axis, std::int64_t low,
    std::int64_t ideal, std::int64_t high) const
  {
    // What begins and ends where between them: the area that is cut changes there alone.
    std::vector<std::pair<std::int64_t, double>> begins;
    std::vector<std::pair<std::int64_t, double>> ends;
    std::vector<std::int64_t> planes{ ideal };
    double begun = 0.0;
    double ended = 0.0;
    for (const Box& support : supports)
    {
      const std::int64_t lo = support.lo[axis];
      const std::int64_t hi = support.hi[axis];
      const double area = areaAcross(support, axis);
      begun += lo < low ? area : 0.0;
      ended += hi < low ? area : 0.0;
      if (lo >= low && lo <= high)
      {
        begins.emplace_back(lo, area);
        planes.push_back(lo);
      }
      if (hi >= low && hi <= high)
      {
        ends.emplace_back(hi, area);
        planes.push_back(hi);
      }
    }
    std::sort(begins.begin(), begins.end());
    std::sort(ends.begin(), ends.end());
    std::sort(planes.begin(), planes.end());
    std::int64_t best = ideal;
    double least = 0.0;
    bool any = false;
    std::size_t b = 0;
    std::size_t e = 0;
    for (const std::int64_t plane : planes)
    {
      for (; b < begins.size() && begins[b].first < plane; ++b)
      {
        begun += begins[b].second;
      }
      for (; e < ends.size() && ends[e].first <= plane; ++e)
      {
        ended += ends[e].second;
      }
      const double area = begun - ended;
      const bool nearer = std::abs(plane - ideal) < std::abs(best - ideal);
      if (!any || area < least - 0.5 || (area < least + 0.5 && nearer))
      {
        any = true;
        least = area;
        best = plane;
      }
    }
    return best;
  }

  Parts& Result;
};
}

std::vector<int> Parts::frontToBack(const glm::dvec4& eye) const
{
  std::vector<int> order;
  std::vector<int> open;
  if (!this->cuts.empty())
  {
    open.push_back(0);
  }
  while (!open.empty())
  {
    const Cut& cut = this->cuts[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if (cut.axis < 0)
    {
      order.push_back(cut.lower);
      continue;
    }
    const bool fromAbove = eye[cut.axis] >= eye.w * static_cast<double>(cut.plane);
    open.push_back(fromAbove ? cut.lower : cut.lower + 1); // the farther one
    open.push_back(fromAbove ? cut.lower + 1 : cut.lower);
  }
  return order;
}

Parts cutIntoParts(const LeafBoxes& leaves, const std::vector<Brick>& bricks,
  const std::vector<std::int64_t>& cellWidth, int numberOfParts)
{
  std::vector<Filled> filled;
  filled.reserve(leaves.boxes.size());
  for (const LeafBox& leaf : leaves.boxes)
  {
    const double side = 2.0 * static_cast<double>(cellWidth[static_cast<std::size_t>(leaf.level)]);
    filled.push_back({ scaled(leaf.box, 2), 1.0 / (side * side * side) });
  }
  const Box bounds = scaled(leaves.bounds, 2);
  std::vector<Box> supports;
  supports.reserve(bricks.size());
  for (const Brick& brick : bricks)
  {
    const std::int64_t width = cellWidth[static_cast<std::size_t>(brick.level)];
    supports.push_back(intersection(grown(scaled(brick.box(width), 2), width), bounds));
  }
  Parts parts;
  parts.boxes.resize(static_cast<std::size_t>(numberOfParts));
  parts.cuts.resize(1);
  Cutter(parts).cut(0, bounds, filled, supports, 0, numberOfParts);
  return parts;
}

std::vector<std::int64_t> findReach(const LeafBoxes& leaves,
  const std::vector<std::int64_t>& cellWidth, const Box& part, bool completed)
{
  if (!completed && leaves.partlyCoveredBoxes == 0)
  {
    std::vector<std::int64_t> reach = cellWidth;
    for (std::int64_t& cells : reach)
    {
      cells *= 1 + StepsBeyond;
    }
    return reach;
  }
  std::int64_t widest = 0;
  for (const LeafBox& leaf : leaves.boxes)
  {
    const std::int64_t width = cellWidth[static_cast<std::size_t>(leaf.level)];
    const Box near = grown(outwardToCells(part, 2), (CellsToComplete + StepsBeyond) * width);
    if (width > widest && leaf.box.intersects(near))
    {
      widest = width;
    }
  }
  std::vector<std::int64_t> reach;
  for (const std::int64_t width : cellWidth)
  {
    reach.push_back((CellsToComplete + StepsBeyond) * std::max(width, widest));
  }
  return reach;
}
}
