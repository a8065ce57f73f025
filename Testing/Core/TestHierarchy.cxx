// SPDX-License-Identifier: BSD-3-Clause
// What a hierarchy has to be, and what is said of one that is not.
#include "Core/Hierarchy.h"

#include <gtest/gtest.h>
#include <limits>

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
