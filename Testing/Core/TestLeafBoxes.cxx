// SPDX-License-Identifier: BSD-3-Clause
// Leaf boxes are disjoint and hold exactly the cells that no finer block covers.
#include "Core/LeafBoxes.h"
#include "Core/Structures.h"

#include <gtest/gtest.h>

using namespace exabricks;
using namespace exabricks::testing;

namespace
{
Box cube(int lo, int hi) { return { Int3(lo), Int3(hi) }; }

// Whether finer blocks cover some part of the cell of the block's level that holds p.
bool cellIsCoveredInPart(const Hierarchy& hierarchy, Lattice& finest, const Int3& p)
{
  const int level = finest[p];
  const std::int64_t width = hierarchy.cellWidth[level];
  bool covered = false;
  forEachPoint(scaled(outwardToCells({ p, p + std::int64_t(1) }, width), width),
    [&](const Int3& q) { covered = covered || finest[q] > level; });
  return covered;
}
}

TEST(LeafBoxes, OfOneBlockAreThatBlock)
{
  const Hierarchy hierarchy{ { 1 }, { { 0, cube(-3, 5) } } };
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  ASSERT_EQ(leaves.boxes.size(), 1u);
  EXPECT_EQ(leaves.boxes[0].box, cube(-3, 5));
  EXPECT_EQ(leaves.bounds, cube(-3, 5));
  EXPECT_EQ(leaves.cells, 512u);
}

TEST(LeafBoxes, OfNoBlocksAreNone)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  EXPECT_TRUE(leaves.boxes.empty());
  EXPECT_TRUE(leaves.bounds.empty());
  EXPECT_EQ(leaves.cells, 0u);
}

TEST(LeafBoxes, LeaveOutCoveredCells)
{
  const Hierarchy hierarchy{ { 2, 1 }, { { 0, cube(0, 4) }, { 1, cube(2, 6) } } };
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  EXPECT_EQ(leaves.cells, 64u - 8u + 64u);
  EXPECT_EQ(leaves.partlyCoveredBoxes, 0u);
}

TEST(LeafBoxes, CutPartlyCoveredCellsIntoFinerOnes)
{
  // Of the one coarse cell half is covered: what is left fits cells of width 2.
  const Hierarchy hierarchy{ { 4, 2, 1 },
    { { 0, cube(0, 1) }, { 2, { Int3(0), Int3(2, 4, 4) } } } };
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  ASSERT_EQ(leaves.boxes.size(), 2u);
  EXPECT_EQ(leaves.boxes[0].level, 1);
  EXPECT_EQ(leaves.boxes[0].box, (Box{ Int3(2, 0, 0), Int3(4) }));
  EXPECT_EQ(leaves.cells, 4u + 32u);
  EXPECT_EQ(leaves.partlyCoveredBoxes, 1u);
}

TEST(LeafBoxes, TakeOverlapsOfALevelOnce)
{
  const Hierarchy hierarchy{ { 1 }, { { 0, cube(0, 4) }, { 0, cube(2, 6) }, { 0, cube(0, 4) } } };
  EXPECT_EQ(findLeafBoxes(hierarchy).cells, 64u + 64u - 8u);
}

TEST(LeafBoxes, AreDisjointAndExactlyTheVisibleCells)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Hierarchy hierarchy = reference::randomHierarchy(seed);
    ASSERT_EQ(findFault(hierarchy), "");
    const LeafBoxes leaves = findLeafBoxes(hierarchy);
    Lattice finest = finestLevels(hierarchy);
    ASSERT_EQ(leaves.bounds, finest.bounds());

    Lattice levels(leaves.bounds, -1);
    std::uint64_t cells = 0;
    std::size_t partlyCovered = 0;
    for (const LeafBox& leaf : leaves.boxes)
    {
      const std::int64_t width = hierarchy.cellWidth[leaf.level];
      ASSERT_TRUE(alignedTo(leaf.box, width) && leaves.bounds.contains(leaf.box));
      cells += static_cast<std::uint64_t>(outwardToCells(leaf.box, width).volume());
      partlyCovered += leaf.level != finest[leaf.box.lo];
      bool disjoint = true;
      forEachPoint(leaf.box,
        [&](const Int3& p)
        {
          disjoint = disjoint && levels[p] == -1;
          levels[p] = leaf.level;
        });
      ASSERT_TRUE(disjoint);
    }
    EXPECT_EQ(cells, leaves.cells);
    EXPECT_EQ(partlyCovered, leaves.partlyCoveredBoxes);

    int wrong = 0;
    forEachPoint(leaves.bounds,
      [&](const Int3& p)
      {
        if (finest[p] < 0 || levels[p] < 0)
        {
          wrong += levels[p] != finest[p];
        }
        else if (cellIsCoveredInPart(hierarchy, finest, p))
        {
          wrong += levels[p] <= finest[p];
        }
        else
        {
          wrong += levels[p] != finest[p];
        }
      });
    ASSERT_EQ(wrong, 0);
  }
}

TEST(LeafBoxes, CutPartlyCoveredCellsNoFinerThanNeeded)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    const Hierarchy hierarchy = reference::randomHierarchy(seed);
    Lattice finest = finestLevels(hierarchy);
    for (const LeafBox& leaf : findLeafBoxes(hierarchy).boxes)
    {
      for (int level = finest[leaf.box.lo]; level < leaf.level; ++level)
      {
        ASSERT_FALSE(alignedTo(leaf.box, hierarchy.cellWidth[level])) << seed;
      }
    }
  }
}

TEST(LeafBoxes, AreFoundFarFromTheOrigin)
{
  const std::int64_t far = -(std::int64_t(1) << 40);
  const Hierarchy hierarchy{ { 2, 1 },
    { { 0, { Int3(far), Int3(far + 4) } }, { 1, { Int3(2 * far + 2), Int3(2 * far + 4) } } } };
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  EXPECT_EQ(leaves.bounds, (Box{ Int3(2 * far), Int3(2 * far + 8) }));
  EXPECT_EQ(leaves.cells, 64u - 1u + 8u);
}
