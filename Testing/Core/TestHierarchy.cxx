// SPDX-License-Identifier: BSD-3-Clause
// What a hierarchy has to be, and what is said of one that is not.
#include "Core/Structure.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iomanip>
#include <limits>
#include <sstream>

using namespace exabricks;

namespace
{
Hierarchy twoLevels()
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(-2), Int3(2) } }, { 1, { Int3(0), Int3(2) } } };
  return hierarchy;
}

void expectFault(const Hierarchy& hierarchy, const std::string& words)
{
  EXPECT_NE(findFault(hierarchy).find(words), std::string::npos) << findFault(hierarchy);
}
}

TEST(Hierarchy, HasNoFaultInTheNormalCase) { EXPECT_EQ(findFault(twoLevels()), ""); }

TEST(Hierarchy, MayHaveNoBlocks)
{
  Hierarchy hierarchy = twoLevels();
  hierarchy.blocks.clear();
  EXPECT_EQ(findFault(hierarchy), "");
}

TEST(Hierarchy, WantsFinestCellsOfWidth1)
{
  Hierarchy hierarchy = twoLevels();
  hierarchy.cellWidth = { 4, 2 };
  expectFault(hierarchy, "1 finest cell wide");
  hierarchy.cellWidth.clear();
  expectFault(hierarchy, "1 finest cell wide");
}

TEST(Hierarchy, WantsWholeRatiosOfAtLeast2)
{
  Hierarchy hierarchy = twoLevels();
  hierarchy.cellWidth = { 3, 2, 1 };
  expectFault(hierarchy, "between levels 0 and 1, found cells 3 and 2 finest cells wide");
  hierarchy.cellWidth = { 2, 1, 1 };
  expectFault(hierarchy, "between levels 1 and 2");
  hierarchy.cellWidth = { 0, 1 };
  expectFault(hierarchy, "between levels 0 and 1");
}

TEST(Hierarchy, WantsBlocksWithCellsOnItsLevels)
{
  Hierarchy hierarchy = twoLevels();
  hierarchy.blocks[1].cells.hi.y = 0;
  expectFault(hierarchy, "found an empty block or one of level 1");
  hierarchy = twoLevels();
  hierarchy.blocks[1].level = 2;
  expectFault(hierarchy, "one of level 2");
  hierarchy.blocks[1].level = -1;
  expectFault(hierarchy, "one of level -1");
}

TEST(Hierarchy, WantsALatticeOfLessThan2To30Cells)
{
  Hierarchy hierarchy = twoLevels();
  hierarchy.blocks[0].cells.hi.z = std::int64_t(1) << 29;
  expectFault(hierarchy, "2^30 finest cells along each axis, found 1073741828");
  // It counts how large the lattice is, not where it lies.
  hierarchy = twoLevels();
  for (Block& block : hierarchy.blocks)
  {
    block.cells.lo += std::int64_t(1) << 40;
    block.cells.hi += std::int64_t(1) << 40;
  }
  hierarchy.blocks.pop_back();
  EXPECT_EQ(findFault(hierarchy), "");
}

TEST(Hierarchy, WantsCellsOfLessThan2To30FinestCells)
{
  // Widths whose products with a block's corners would not fit 64 bits.
  Hierarchy hierarchy = twoLevels();
  for (const int bits : { 30, 31, 61, 62 })
  {
    hierarchy.cellWidth = { std::int64_t(1) << bits, 1 };
    expectFault(hierarchy, "less than 2^30 finest cells wide");
    std::ostringstream ratio;
    ratio << std::setprecision(15) << std::ldexp(1.0, bits);
    expectFault(hierarchy, "ratio of " + ratio.str() + " between levels 0 and 1");
  }
  // Of several levels it is the product that counts.
  hierarchy.cellWidth = { std::int64_t(1) << 62, std::int64_t(1) << 31, std::int64_t(1) << 20, 1 };
  expectFault(hierarchy, "ratio of 2048 between levels 1 and 2, whose cells are 1048576 finest");
  hierarchy.cellWidth = { std::int64_t(1) << 29, 1 };
  hierarchy.blocks = { { 0, { Int3(-1), Int3(0) } } };
  EXPECT_EQ(findFault(hierarchy), "");
}

TEST(Hierarchy, WantsBlocksThatCanBeReached)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { std::int64_t(1) << 20, 1 };
  const std::int64_t farthest = std::int64_t(1) << 41; // 2^61 finest cells away
  for (const std::int64_t corner : { -farthest - 1, farthest, std::int64_t(1) << 62 })
  {
    hierarchy.blocks = { { 0, { Int3(corner, 0, 0), Int3(corner + 1, 1, 1) } } };
    expectFault(
      hierarchy, "within 2^61 finest cells of the lattice's origin, found one of level 0");
  }
  for (const std::int64_t corner : { -farthest, farthest - 1 })
  {
    hierarchy.blocks = { { 0, { Int3(corner, 0, 0), Int3(corner + 1, 1, 1) } } };
    EXPECT_EQ(findFault(hierarchy), "");
  }
  // The lattice is too large, and its size is right.
  hierarchy.blocks.push_back({ 0, { Int3(-farthest, 0, 0), Int3(1 - farthest, 1, 1) } });
  expectFault(hierarchy, "along each axis, found 4611686018427387904");
}

TEST(Hierarchy, MayLieAtTheEndOfTheLattice)
{
  // AMR boxes near the largest int, in the widest cells: the same bricks as at 0.
  Hierarchy hierarchy;
  hierarchy.cellWidth = { std::int64_t(1) << 28, std::int64_t(1) << 27, 1 };
  hierarchy.blocks = { { 0, { Int3(-2), Int3(0) } }, { 1, { Int3(-3), Int3(-2) } } };
  const Structure here = buildStructure(hierarchy);
  const std::int64_t end = std::int64_t(std::numeric_limits<int>::max()) + 1;
  for (Block& block : hierarchy.blocks)
  {
    block.cells.lo += end << block.level;
    block.cells.hi += end << block.level;
  }
  ASSERT_EQ(findFault(hierarchy), "");
  const Structure there = buildStructure(hierarchy);
  ASSERT_EQ(there.bricks.size(), here.bricks.size());
  const Int3 shift(end << 28);
  for (std::size_t b = 0; b < here.bricks.size(); ++b)
  {
    EXPECT_EQ(there.bricks[b].lo, here.bricks[b].lo + shift);
    EXPECT_EQ(there.bricks[b].cells, here.bricks[b].cells);
    EXPECT_EQ(there.bricks[b].level, here.bricks[b].level);
  }
  EXPECT_EQ(there.tree.size, here.tree.size);
  EXPECT_EQ(there.tree.nodes.size(), here.tree.nodes.size());
  EXPECT_EQ(there.leafCells, here.leafCells);
}

TEST(Hierarchy, WantsAFinitePlaceInTheWorld)
{
  Hierarchy hierarchy = twoLevels();
  hierarchy.spacing.y = 0.0;
  expectFault(hierarchy, "spacing 0.000000 along axis 1");
  hierarchy.spacing.y = -1.0;
  expectFault(hierarchy, "along axis 1");
  hierarchy = twoLevels();
  hierarchy.origin.z = std::numeric_limits<double>::infinity();
  expectFault(hierarchy, "found origin inf");
}

TEST(Hierarchy, KeepsItsStructureWhenItMovesInTheWorld)
{
  Hierarchy moved = twoLevels();
  moved.origin = glm::dvec3(1.0, 2.0, 3.0);
  EXPECT_TRUE(moved.sameStructure(twoLevels()));
  moved.blocks[1].cells.hi.x = 1;
  EXPECT_FALSE(moved.sameStructure(twoLevels()));
}
