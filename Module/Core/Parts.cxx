// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Parts.h"

#include <array>
#include <cmath>

namespace exabricks
{
namespace
{
// Two samples at most are beyond a part, an interval of cells apart (Shaders/Cursor.glsl).
constexpr std::int64_t StepsBeyond = 2;
// Of the coarsest level nearby: the cell that is extended, its neighbours by which its slope is
// found, and a cell of the level that is completed.
constexpr std::int64_t CellsToComplete = 3;

Box grown(const Box& box, std::int64_t by) { return { box.lo - by, box.hi + by }; }

class Cutter
{
public:
  Cutter(const std::vector<std::int64_t>& cellWidth, Parts& parts)
    : CellWidth(cellWidth)
    , Result(parts)
  {
  }

  /// `leaves`: those in the box, cut at its faces.
  void cut(
    std::size_t node, const Box& box, const std::vector<LeafBox>& leaves, int first, int count)
  {
    if (count == 1)
    {
      this->Result.cuts[node] = { -1, 0, first };
      this->Result.boxes[first] = box;
      return;
    }
    const int lowerCount = count / 2;
    const Candidate best = this->Choose(box, leaves, static_cast<double>(lowerCount) / count);
    if (best.axis < 0)
    {
      // Nothing to cut: all of it for the first part.
      this->Result.cuts[node] = { -1, 0, first };
      this->Result.boxes[first] = box;
      return;
    }
    const std::size_t child = this->Result.cuts.size();
    this->Result.cuts[node] = { best.axis, best.plane, static_cast<int>(child) };
    this->Result.cuts.resize(child + 2);
    const auto sides = split(box, best.axis, best.plane);
    for (const bool upper : { false, true })
    {
      const Box& side = upper ? sides.second : sides.first;
      std::vector<LeafBox> within;
      for (const LeafBox& leaf : leaves)
      {
        const Box common = intersection(leaf.box, side);
        if (!common.empty())
        {
          within.push_back({ leaf.level, common });
        }
      }
      this->cut(child + upper, side, within, upper ? first + lowerCount : first,
        upper ? count - lowerCount : lowerCount);
    }
  }

private:
  struct Candidate
  {
    int axis = -1;
    std::int64_t plane = 0;
    double off = 2.0; // how much more or less than wanted the lower side has, of all
  };

  double CellsBelow(const std::vector<LeafBox>& leaves, int axis, std::int64_t plane) const
  {
    double cells = 0.0;
    for (const LeafBox& leaf : leaves)
    {
      const std::int64_t length = std::min(plane, leaf.box.hi[axis]) - leaf.box.lo[axis];
      if (length > 0)
      {
        const Int3 size = leaf.box.size();
        const auto width = static_cast<double>(this->CellWidth[leaf.level]);
        cells += static_cast<double>(size[(axis + 1) % 3]) *
          static_cast<double>(size[(axis + 2) % 3]) * static_cast<double>(length) /
          (width * width * width);
      }
    }
    return cells;
  }

  // The plane at a multiple of `width` below which the cells are nearest to a fraction of all.
  Candidate ChoosePlane(const Box& box, const std::vector<LeafBox>& leaves, int axis,
    double fraction, std::int64_t width) const
  {
    const double all = this->CellsBelow(leaves, axis, box.hi[axis]);
    std::int64_t low = floorDivide(box.lo[axis], width) + 1;
    std::int64_t high = -floorDivide(-box.hi[axis], width) - 1;
    Candidate best;
    const auto look = [&](std::int64_t plane)
    {
      const double off = this->CellsBelow(leaves, axis, plane * width) / all - fraction;
      if (std::abs(off) < best.off)
      {
        best = { axis, plane * width, std::abs(off) };
      }
      return off < 0.0;
    };
    while (low <= high && all > 0.0)
    {
      const std::int64_t middle = floorDivide(low + high, 2);
      if (look(middle))
      {
        low = middle + 1;
      }
      else
      {
        high = middle - 1;
      }
    }
    return best;
  }

  // Across the longest axis that does, at faces of the coarsest cells that do.
  Candidate Choose(const Box& box, const std::vector<LeafBox>& leaves, double fraction) const
  {
    constexpr double enough = 0.01;
    Box tight;
    for (const LeafBox& leaf : leaves)
    {
      tight = unite(tight, leaf.box);
    }
    std::array<int, 3> axes{ 0, 1, 2 };
    const Int3 size = tight.size();
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size[a] > size[b]; });
    Candidate best;
    for (const std::int64_t width : this->CellWidth)
    {
      for (const int axis : axes)
      {
        const Candidate candidate = this->ChoosePlane(box, leaves, axis, fraction, width);
        if (candidate.off < best.off)
        {
          best = candidate;
        }
        if (best.off <= enough)
        {
          return best;
        }
      }
    }
    return best;
  }

  const std::vector<std::int64_t>& CellWidth;
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
    const Cut& cut = this->cuts[open.back()];
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

Parts cutIntoParts(
  const LeafBoxes& leaves, const std::vector<std::int64_t>& cellWidth, int numberOfParts)
{
  Parts parts;
  parts.boxes.resize(static_cast<std::size_t>(numberOfParts));
  parts.cuts.resize(1);
  Cutter(cellWidth, parts).cut(0, leaves.bounds, leaves.boxes, 0, numberOfParts);
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
    const std::int64_t width = cellWidth[leaf.level];
    if (width > widest && leaf.box.intersects(grown(part, (CellsToComplete + StepsBeyond) * width)))
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
