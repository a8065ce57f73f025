// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ValueRanges.h"

#include "Core/Values.h"

namespace exabricks
{
namespace
{
struct Finder
{
  const Structure& structure;
  const Values& values;

  // The range in a box inside a region, in half cells.
  ValueRange find(const layout::Region& region, const glm::ivec3& lo, const glm::ivec3& hi) const
  {
    ValueRange range;
    for (std::uint32_t k = 0; k < region.brickCount; ++k)
    {
      this->Add(this->structure.tree.brickLists[region.firstBrick + k], Int3(lo), Int3(hi), range);
    }
    return range;
  }

  // The width of the finest cells that reach into a region, in half cells.
  int finest(const layout::Region& region) const
  {
    std::int64_t width = std::numeric_limits<int>::max();
    for (std::uint32_t k = 0; k < region.brickCount; ++k)
    {
      const std::uint32_t brick = this->structure.tree.brickLists[region.firstBrick + k];
      width = std::min(width, 2 * this->structure.width(this->structure.bricks[brick]));
    }
    return static_cast<int>(width);
  }

private:
  void Add(std::uint32_t b, const Int3& lo, const Int3& hi, ValueRange& range) const
  {
    const Brick& brick = this->structure.bricks[b];
    const int layer = this->values.layer;
    const std::int64_t width = this->structure.width(brick);
    const Int3 origin = (brick.lo - this->structure.tree.bounds.lo) * std::int64_t(2);
    // Cell i's tent spans (2 i - 1, 2 i + 3) widths in half cells from the brick's corner.
    glm::ivec3 first, last;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t begin = lo[axis] - origin[axis];
      const std::int64_t end = hi[axis] - origin[axis];
      first[axis] = static_cast<int>(
        std::max<std::int64_t>(floorDivide(begin - 3 * width, 2 * width) + 1, -layer));
      last[axis] = static_cast<int>(
        std::min<std::int64_t>(-floorDivide(-(end + width), 2 * width), brick.cells[axis] + layer));
    }
    first += layer;
    last += layer;
    const glm::ivec3 n = brick.cells + 2 * layer;
    const float* of = this->values.ofBrick(b);
    for (int z = first.z; z < last.z; ++z)
    {
      for (int y = first.y; y < last.y; ++y)
      {
        const float* row = of + n.x * (y + static_cast<std::size_t>(n.y) * z);
        for (int x = first.x; x < last.x; ++x)
        {
          const float value = row[x];
          range.min = value >= 0.0f && value < range.min ? value : range.min;
          range.max = value > range.max && value >= 0.0f ? value : range.max;
        }
      }
    }
  }
};
}

ValueRanges findValueRanges(const Structure& structure, const Values& values, int macrocellCells)
{
  const RegionTree& tree = structure.tree;
  const Finder finder{ structure, values };
  ValueRanges ranges;
  ranges.regions.resize(tree.regions.size());
  std::vector<std::ptrdiff_t> gridOf(tree.regions.size(), -1);
  std::size_t count = 0;
  for (std::size_t r = 0; r < tree.regions.size(); ++r)
  {
    const layout::Region& region = tree.regions[r];
    if (region.brickCount == 0)
    {
      continue;
    }
    const std::int64_t side = std::int64_t(macrocellCells) * finder.finest(region);
    const glm::ivec3 size = region.hi - region.lo;
    if (std::max({ size.x, size.y, size.z }) > side)
    {
      gridOf[r] = static_cast<std::ptrdiff_t>(ranges.grids.size());
      ranges.grids.push_back({ static_cast<std::uint32_t>(r), static_cast<int>(side), count });
      const glm::ivec3 cells = ranges.grids.back().count(region);
      count += static_cast<std::size_t>(cells.x) * cells.y * cells.z;
    }
  }
  ranges.grids.shrink_to_fit();
  ranges.macrocells.resize(count);
  // Nothing in this loop throws, so exceptions need no care.
#pragma omp parallel for schedule(dynamic, 64) if (values.normalized.size() > ParallelCells)
  for (std::ptrdiff_t r = 0; r < static_cast<std::ptrdiff_t>(tree.regions.size()); ++r)
  {
    const layout::Region& region = tree.regions[r];
    if (gridOf[r] < 0)
    {
      ranges.regions[r] = finder.find(region, region.lo, region.hi);
      continue;
    }
    const MacrocellGrid& grid = ranges.grids[gridOf[r]];
    const glm::ivec3 n = grid.count(region);
    ValueRange* to = ranges.macrocells.data() + grid.firstRange;
    for (int z = 0; z < n.z; ++z)
    {
      for (int y = 0; y < n.y; ++y)
      {
        for (int x = 0; x < n.x; ++x)
        {
          const glm::ivec3 cell(x, y, z);
          *to = finder.find(region, grid.corner(region, cell), grid.corner(region, cell + 1));
          ranges.regions[r].add(*to++);
        }
      }
    }
  }
  ranges.splits.resize(tree.nodes.size() / 2); // half of the nodes, as there is a leaf more
  const auto rangeOf = [&](const layout::KdNode& node)
  {
    return (node.link & 3) == layout::KD_LEAF ? ranges.regions[node.link >> 2]
                                              : ranges.splits[(node.link >> 2) / 2];
  };
  for (std::size_t i = ranges.splits.size(); i-- > 0;) // children come behind their parents
  {
    ranges.splits[i] = rangeOf(tree.nodes[2 * i + 1]);
    ranges.splits[i].add(rangeOf(tree.nodes[2 * i + 2]));
  }
  return ranges;
}
}
