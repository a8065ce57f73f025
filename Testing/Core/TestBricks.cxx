// SPDX-License-Identifier: BSD-3-Clause
// Bricks partition the leaf cells: each cell lies in one brick, of its own level.
#include "Core/Bricks.h"
#include "Core/Structures.h"

#include <gtest/gtest.h>

using namespace exabricks;
using namespace exabricks::testing;

TEST(Bricks, OfOneSmallBlockAreThatBlock)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 4, 1 };
  hierarchy.blocks = { { 0, { Int3(-2), Int3(3, 4, 5) } } };
  const std::vector<Brick> bricks = buildBricks(findLeafBoxes(hierarchy), hierarchy.cellWidth);
  ASSERT_EQ(bricks.size(), 1u);
  EXPECT_EQ(bricks[0].lo, Int3(-8));
  EXPECT_EQ(bricks[0].cells, glm::ivec3(5, 6, 7));
  EXPECT_EQ(bricks[0].level, 0);
}

TEST(Bricks, JoinBlocksOfALevel)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(4) } }, { 0, { Int3(4, 0, 0), Int3(8, 4, 4) } } };
  EXPECT_EQ(buildBricks(findLeafBoxes(hierarchy), hierarchy.cellWidth).size(), 1u);
}

TEST(Bricks, AreCutIntoEqualOnesWhereTooLarge)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(20, 4, 4) } } };
  const std::vector<Brick> bricks = buildBricks(findLeafBoxes(hierarchy), hierarchy.cellWidth, 16);
  ASSERT_EQ(bricks.size(), 2u);
  EXPECT_EQ(bricks[0].cells, glm::ivec3(10, 4, 4));
  EXPECT_EQ(bricks[1].cells, glm::ivec3(10, 4, 4));
}

TEST(Bricks, AreFewAroundARefinedCorner)
{
  // An L of coarse cells and a fine corner: a k-d tree needs no more than three coarse bricks.
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(8) } }, { 1, { Int3(0), Int3(8) } } };
  EXPECT_EQ(buildBricks(findLeafBoxes(hierarchy), hierarchy.cellWidth).size(), 4u);
}

TEST(Bricks, HoldEachLeafCellOnceAtItsLevel)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    Lattice levels(built.leaves.bounds, -1);
    for (const LeafBox& leaf : built.leaves.boxes)
    {
      levels.fill(leaf.box, leaf.level);
    }
    std::uint64_t cells = 0;
    for (const Brick& brick : built.bricks())
    {
      const Box box = built.box(brick);
      ASSERT_TRUE(built.leaves.bounds.contains(box));
      ASSERT_TRUE(alignedTo(box, built.width(brick)));
      // Each finest cell is taken off when a brick of its level holds it, so a second one fails.
      bool right = true;
      forEachPoint(box,
        [&](const Int3& p)
        {
          right = right && levels[p] == brick.level;
          levels[p] = -1;
        });
      ASSERT_TRUE(right);
      cells += brick.numberOfCells();
    }
    ASSERT_EQ(levels.count(-1), static_cast<std::size_t>(built.leaves.bounds.volume()));
    ASSERT_EQ(cells, built.leaves.cells);
  }
}

TEST(Bricks, KeepToTheGreatestSize)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed)
  {
    const LeafBoxes leaves = findLeafBoxes(reference::randomHierarchy(seed));
    std::uint64_t cells = 0;
    for (const Brick& brick : buildBricks(leaves, reference::randomHierarchy(seed).cellWidth, 4))
    {
      ASSERT_LE(std::max({ brick.cells.x, brick.cells.y, brick.cells.z }), 4);
      cells += brick.numberOfCells();
    }
    ASSERT_EQ(cells, leaves.cells);
  }
}

TEST(Bricks, AreNoneWhenProgressAborts)
{
  const Hierarchy hierarchy = reference::refinedAtShell({}, 12, 12);
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  double last = 0.0;
  const auto abortAtHalf = [&](double done)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return done < 0.5;
  };
  EXPECT_TRUE(buildBricks(leaves, hierarchy.cellWidth, 1, abortAtHalf).empty());
  EXPECT_GE(last, 0.5);
}
