// SPDX-License-Identifier: BSD-3-Clause
// Finds the bricks at a point: what a renderer needs that has no regions, and asks a tree at each
// sample ("cell location" in Wald et al. 2020, section 5).
#ifndef ExaBricksBenchmarksBrickTree_h
#define ExaBricksBenchmarksBrickTree_h

#include "Core/Bricks.h"

#include "BrickTreeNode.h"

namespace exabricks
{
namespace benchmarks
{
enum class BrickExtent
{
  Cells,  // of a brick: no two overlap
  Support // grown by half its own cell
};

/// One leaf for each brick, the root first; none of no bricks. Half cells count from `corner`, a
/// logical position. Split by planes that cut no brick, as bricks were made, so that samples visit
/// hardly a brick in vain; the plane that balances best. Halves of equally many bricks draw as fast
/// as halves where equally many samples are expected.
/// Leaves are nodes, too: splits of four words with their children's links draw slower on lavapipe
/// (by 5 to 10 %), though they need fewer loads.
std::vector<layout::BrickTreeNode> buildBrickTree(const std::vector<Brick>& bricks,
  const std::vector<std::int64_t>& cellWidth, const Int3& corner, BrickExtent extent);

/// Calls `visit(i)` for every brick i whose extent along the axes of the splits above it holds
/// `point` (half cells): as the shaders walk.
template <typename Visitor>
void forEachBrickAt(
  const std::vector<layout::BrickTreeNode>& nodes, const glm::dvec3& point, Visitor&& visit)
{
  std::vector<std::uint32_t> pending;
  if (!nodes.empty())
  {
    pending.push_back(0);
  }
  while (!pending.empty())
  {
    const layout::BrickTreeNode& node = nodes[pending.back()];
    pending.pop_back();
    const std::uint32_t index = node.link >> 2;
    const std::uint32_t axis = node.link & 3;
    if (axis == layout::BRICK_TREE_LEAF)
    {
      visit(static_cast<std::size_t>(index));
      continue;
    }
    if (point[axis] < node.lowerEnd)
    {
      pending.push_back(index);
    }
    if (point[axis] > node.upperBegin)
    {
      pending.push_back(index + 1);
    }
  }
}
}
}

#endif
