// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CellSearch.h"

#include <cmath>

namespace exabricks
{
std::optional<LeafCell> findLeafCell(const Structure& structure, const glm::dvec3& halfCells)
{
  const RegionTree& tree = structure.tree;
  if (tree.nodes.empty())
  {
    return std::nullopt;
  }
  const layout::KdNode* node = tree.nodes.data();
  while ((node->link & 3) != layout::KD_LEAF)
  {
    const bool upper = !(halfCells[static_cast<int>(node->link & 3)] < node->plane);
    node = &tree.nodes[(node->link >> 2) + (upper ? 1 : 0)];
  }
  const layout::Region& region = tree.regions[node->link >> 2];
  const glm::dvec3 logical = glm::dvec3(tree.bounds.lo) + 0.5 * halfCells;
  for (std::uint32_t k = 0; k < region.brickCount; ++k)
  {
    const std::size_t index = tree.brickLists[region.firstBrick + k];
    const Brick& brick = structure.bricks[index];
    const std::int64_t width = structure.width(brick);
    const glm::dvec3 cells =
      glm::floor((logical - glm::dvec3(brick.lo)) / static_cast<double>(width));
    if (glm::all(glm::greaterThanEqual(cells, glm::dvec3(0.0))) &&
      glm::all(glm::lessThan(cells, glm::dvec3(brick.cells))))
    {
      const Int3 cell(cells);
      return LeafCell{ index,
        static_cast<std::size_t>(cell.x + brick.cells.x * (cell.y + brick.cells.y * cell.z)),
        brick.lo + cell * width };
    }
  }
  return std::nullopt;
}
}
