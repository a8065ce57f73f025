// SPDX-License-Identifier: BSD-3-Clause
// Each region, and each macrocell of a long one, knows the range of the values in it.
#include "Core/Structures.h"
#include "Core/ValueRanges.h"

#include <functional>
#include <gtest/gtest.h>

using namespace exabricks;
using namespace exabricks::testing;

TEST(ValueRanges, AreThoseOfTheCellsWhoseTentsReachIntoTheRegion)
{
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const Values values = built.gather();
    const ValueRanges ranges = findValueRanges(*built.structure, values);
    ASSERT_EQ(ranges.regions.size(), built.tree().regions.size());

    std::vector<ValueRange> expected(ranges.regions.size());
    forEachLeafCell(built,
      [&](const Brick& brick, const Int3& corner, std::uint64_t i)
      {
        const std::int64_t width = built.width(brick);
        const Int3 lo = (corner - built.tree().bounds.lo) * std::int64_t(2);
        const Box tent{ lo - width, lo + 3 * width };
        for (std::size_t r = 0; r < expected.size() && values.normalized[i] >= 0.0f; ++r)
        {
          const layout::Region& region = built.tree().regions[r];
          if (region.brickCount > 0 && tent.intersects({ Int3(region.lo), Int3(region.hi) }))
          {
            expected[r].min = std::min(expected[r].min, values.normalized[i]);
            expected[r].max = std::max(expected[r].max, values.normalized[i]);
          }
        }
      });
    for (std::size_t r = 0; r < expected.size(); ++r)
    {
      ASSERT_EQ(ranges.regions[r].min, expected[r].min);
      ASSERT_EQ(ranges.regions[r].max, expected[r].max);
    }
  }
}

TEST(ValueRanges, OfMacrocellsAreThoseOfTheCellsWhoseTentsReachIntoThem)
{
  std::size_t cut = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const Values values = built.gather();
    const ValueRanges ranges = findValueRanges(*built.structure, values, 2);
    for (const MacrocellGrid& grid : ranges.grids)
    {
      const layout::Region& region = built.tree().regions[grid.region];
      const glm::ivec3 n = grid.count(region);
      std::vector<ValueRange> expected(n.x * n.y * n.z);
      std::vector<Box> boxes;
      forEachPoint({ Int3(0), Int3(n) },
        [&](const Int3& cell)
        {
          const Int3 lo = Int3(region.lo) + cell * std::int64_t(grid.side);
          boxes.push_back({ lo, glm::min(lo + std::int64_t(grid.side), Int3(region.hi)) });
        });
      ASSERT_EQ(boxes.size(), expected.size());
      forEachLeafCell(built,
        [&](const Brick& brick, const Int3& corner, std::uint64_t i)
        {
          const std::int64_t width = built.width(brick);
          const Int3 lo = (corner - built.tree().bounds.lo) * std::int64_t(2);
          const Box tent{ lo - width, lo + 3 * width };
          for (std::size_t k = 0; k < boxes.size() && values.normalized[i] >= 0.0f; ++k)
          {
            if (tent.intersects(boxes[k]))
            {
              expected[k].add({ values.normalized[i], values.normalized[i] });
            }
          }
        });
      for (std::size_t k = 0; k < expected.size(); ++k)
      {
        ASSERT_EQ(ranges.macrocells[grid.firstRange + k].min, expected[k].min);
        ASSERT_EQ(ranges.macrocells[grid.firstRange + k].max, expected[k].max);
      }
      ++cut;
    }
  }
  EXPECT_GT(cut, 100u);
}

TEST(ValueRanges, OfSplitsAreThoseOfAllRegionsBelow)
{
  std::size_t splits = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const ValueRanges ranges = findValueRanges(*built.structure, built.gather());
    const std::vector<layout::KdNode>& nodes = built.tree().nodes;
    const std::function<ValueRange(const layout::KdNode&)> rangeBelow =
      [&](const layout::KdNode& node)
    {
      const std::uint32_t index = node.link >> 2;
      if ((node.link & 3) == layout::KD_LEAF)
      {
        return ranges.regions[index];
      }
      ValueRange range = rangeBelow(nodes[index]);
      range.add(rangeBelow(nodes[index + 1]));
      EXPECT_EQ(ranges.splits[index / 2].min, range.min);
      EXPECT_EQ(ranges.splits[index / 2].max, range.max);
      ++splits;
      return range;
    };
    rangeBelow(nodes.front());
    ASSERT_EQ(ranges.splits.size(), ranges.regions.size() - 1);
  }
  EXPECT_GT(splits, 1000u);
}

TEST(ValueRanges, AreEmptyWhereAllCellsAreAbsent)
{
  reference::Scene scene;
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(3, 1, 1) } } };
  scene.cells = reference::fillCells(
    scene.hierarchy, [](int, const Int3&) { return std::numeric_limits<double>::quiet_NaN(); });
  const Built built = build(scene);
  const Values values = built.gather();
  const ValueRanges ranges = findValueRanges(*built.structure, values, 1);
  for (const std::vector<ValueRange>* all : { &ranges.regions, &ranges.macrocells })
  {
    EXPECT_FALSE(all->empty());
    for (const ValueRange& range : *all)
    {
      EXPECT_TRUE(range.empty());
    }
  }
}
