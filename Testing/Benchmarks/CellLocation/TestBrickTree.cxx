// SPDX-License-Identifier: BSD-3-Clause
// The tree finds every brick that has a point in its extent, and the walk fits the shaders' stack.
#include "CellLocation/BrickTree.h"
#include "Core/Structures.h"

#include <gtest/gtest.h>
#include <random>

using namespace exabricks;
using namespace exabricks::benchmarks;
using namespace exabricks::testing;

namespace
{
/// Its extent in half cells from the bounds' corner.
Box extentOf(const Built& built, const Brick& brick, BrickExtent extent)
{
  const Box box = built.box(brick);
  const Int3 corner = built.leaves.bounds.lo;
  const Int3 growth(extent == BrickExtent::Support ? built.width(brick) : 0);
  return { std::int64_t(2) * (box.lo - corner) - growth,
    std::int64_t(2) * (box.hi - corner) + growth };
}

int depthOf(const std::vector<layout::BrickTreeNode>& nodes, std::size_t n)
{
  const std::size_t index = nodes[n].link >> 2;
  return (nodes[n].link & 3) == layout::BRICK_TREE_LEAF
    ? 0
    : 1 + std::max(depthOf(nodes, index), depthOf(nodes, index + 1));
}
}

TEST(BrickTree, FindsTheBricksAtAPoint)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    std::mt19937 random(seed);
    for (const BrickExtent extent : { BrickExtent::Cells, BrickExtent::Support })
    {
      const std::vector<layout::BrickTreeNode> tree =
        buildBrickTree(built.bricks(), built.cellWidth(), built.leaves.bounds.lo, extent);
      ASSERT_EQ(tree.size(), 2 * built.bricks().size() - 1);
      EXPECT_LE(depthOf(tree, 0), layout::BRICK_TREE_DEPTH);
      for (int k = 0; k < 100; ++k)
      {
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis)
        {
          point[axis] = std::uniform_real_distribution<double>(
            0.0, 2.0 * static_cast<double>(built.leaves.bounds.size()[axis]))(random);
        }
        std::vector<int> visits(built.bricks().size(), 0);
        forEachBrickAt(tree, point, [&](std::size_t b) { ++visits[b]; });
        for (std::size_t b = 0; b < built.bricks().size(); ++b)
        {
          const Box box = extentOf(built, built.bricks()[b], extent);
          const bool inside = glm::all(glm::lessThan(glm::dvec3(box.lo), point)) &&
            glm::all(glm::lessThan(point, glm::dvec3(box.hi)));
          EXPECT_LE(visits[b], 1);
          EXPECT_TRUE(!inside || visits[b] == 1) << "brick " << b;
        }
      }
    }
  }
}

TEST(BrickTree, OfDisjointBoxesIsOnePathDown)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    for (const layout::BrickTreeNode& node :
      buildBrickTree(built.bricks(), built.cellWidth(), built.leaves.bounds.lo, BrickExtent::Cells))
    {
      EXPECT_TRUE((node.link & 3) == layout::BRICK_TREE_LEAF || node.lowerEnd <= node.upperBegin);
    }
  }
}

TEST(BrickTree, VisitsFewBricksBesideTheRightOnes)
{
  const Built built =
    build(reference::makeShellScene("shell", reference::refinedAtShell({ 2, 2 }, 32, 4)));
  const std::vector<layout::BrickTreeNode> tree =
    buildBrickTree(built.bricks(), built.cellWidth(), built.leaves.bounds.lo, BrickExtent::Support);
  std::mt19937 random(1);
  std::size_t visited = 0;
  std::size_t right = 0;
  for (int k = 0; k < 2000; ++k)
  {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = std::uniform_real_distribution<double>(
        0.0, 2.0 * static_cast<double>(built.leaves.bounds.size()[axis]))(random);
    }
    forEachBrickAt(tree, point,
      [&](std::size_t b)
      {
        const Box box = extentOf(built, built.bricks()[b], BrickExtent::Support);
        ++visited;
        right += glm::all(glm::lessThan(glm::dvec3(box.lo), point)) &&
          glm::all(glm::lessThan(point, glm::dvec3(box.hi)));
      });
  }
  std::cout << built.bricks().size() << " bricks, depth " << depthOf(tree, 0) << ": visited "
            << visited << ", of which right " << right << "\n";
  EXPECT_LT(visited, 2 * right);
}
