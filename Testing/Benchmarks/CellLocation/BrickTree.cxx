// SPDX-License-Identifier: BSD-3-Clause
#include "CellLocation/BrickTree.h"

#include <limits>
#include <numeric>

namespace exabricks
{
namespace benchmarks
{
namespace
{
class Builder
{
public:
  Builder(const std::vector<Brick>& bricks, const std::vector<std::int64_t>& cellWidth,
    const Int3& corner, BrickExtent extent)
  {
    for (const Brick& brick : bricks)
    {
      const std::int64_t width = cellWidth[brick.level];
      const Box box = brick.box(width);
      this->Boxes.push_back(scaled({ box.lo - corner, box.hi - corner }, 2));
      this->Growth.push_back(extent == BrickExtent::Support ? width : 0);
    }
    this->Order.resize(bricks.size());
    std::iota(this->Order.begin(), this->Order.end(), 0);
  }

  std::vector<layout::BrickTreeNode> build()
  {
    if (!this->Order.empty())
    {
      this->Nodes.resize(1);
      this->Build(0, 0, this->Order.size(), layout::BRICK_TREE_DEPTH);
    }
    return std::move(this->Nodes);
  }

private:
  struct Cut
  {
    int axis = -1;
    std::size_t lower = 0; // number of bricks below it
    std::size_t imbalance = std::numeric_limits<std::size_t>::max();
  };

  std::int64_t Center2(int b, int axis) const
  {
    return this->Boxes[b].lo[axis] + this->Boxes[b].hi[axis];
  }

  // Centres order bricks of one side of a plane before those of the other.
  void SortAlong(int axis, std::size_t begin, std::size_t end)
  {
    std::sort(this->Order.begin() + begin, this->Order.begin() + end,
      [&](int a, int b) { return this->Center2(a, axis) < this->Center2(b, axis); });
  }

  // The plane that cuts no brick and balances best; the axis is -1 if there is none.
  Cut FindPlane(std::size_t begin, std::size_t end)
  {
    const std::size_t count = end - begin;
    Cut best;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->SortAlong(axis, begin, end);
      this->Least.resize(count);
      std::int64_t least = std::numeric_limits<std::int64_t>::max();
      for (std::size_t i = end; i-- > begin;)
      {
        least = std::min(least, this->Boxes[this->Order[i]].lo[axis]);
        this->Least[i - begin] = least;
      }
      std::int64_t greatest = std::numeric_limits<std::int64_t>::min();
      for (std::size_t i = begin; i + 1 < end; ++i)
      {
        greatest = std::max(greatest, this->Boxes[this->Order[i]].hi[axis]);
        const std::size_t lower = i + 1 - begin;
        const std::size_t imbalance = std::max(lower, count - lower);
        if (greatest <= this->Least[lower] && imbalance < best.imbalance)
        {
          best = { axis, lower, imbalance };
        }
      }
    }
    return best;
  }

  // Halves of equal number along the longest axis: for the depth that is left.
  Cut FindMedian(std::size_t begin, std::size_t end) const
  {
    Box bounds;
    for (std::size_t i = begin; i < end; ++i)
    {
      bounds = unite(bounds, this->Boxes[this->Order[i]]);
    }
    const Int3 size = bounds.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return { axis, (end - begin) / 2, 0 };
  }

  void Build(std::size_t n, std::size_t begin, std::size_t end, int depthLeft)
  {
    if (end - begin == 1)
    {
      this->Nodes[n] = { 0, 0,
        4 * static_cast<std::uint32_t>(this->Order[begin]) + layout::BRICK_TREE_LEAF };
      return;
    }
    Cut cut;
    if ((std::uint64_t(1) << (depthLeft - 1)) >= end - begin)
    {
      cut = this->FindPlane(begin, end);
    }
    if (cut.axis < 0)
    {
      cut = this->FindMedian(begin, end);
    }
    this->SortAlong(cut.axis, begin, end);
    const std::size_t middle = begin + cut.lower;
    std::int64_t lowerEnd = std::numeric_limits<std::int64_t>::min();
    std::int64_t upperBegin = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = begin; i < end; ++i)
    {
      const int b = this->Order[i];
      if (i < middle)
      {
        lowerEnd = std::max(lowerEnd, this->Boxes[b].hi[cut.axis] + this->Growth[b]);
      }
      else
      {
        upperBegin = std::min(upperBegin, this->Boxes[b].lo[cut.axis] - this->Growth[b]);
      }
    }
    const std::size_t children = this->Nodes.size();
    this->Nodes.resize(children + 2);
    this->Nodes[n] = { static_cast<int>(lowerEnd), static_cast<int>(upperBegin),
      static_cast<std::uint32_t>(4 * children + cut.axis) };
    this->Build(children, begin, middle, depthLeft - 1);
    this->Build(children + 1, middle, end, depthLeft - 1);
  }

  std::vector<Box> Boxes; // of cells, half cells
  std::vector<std::int64_t> Growth;
  std::vector<int> Order;
  std::vector<std::int64_t> Least; // scratch
  std::vector<layout::BrickTreeNode> Nodes;
};
}

std::vector<layout::BrickTreeNode> buildBrickTree(const std::vector<Brick>& bricks,
  const std::vector<std::int64_t>& cellWidth, const Int3& corner, BrickExtent extent)
{
  return Builder(bricks, cellWidth, corner, extent).build();
}
}
}
