// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hierarchy.h"

#include <cmath>

namespace exabricks
{
std::string findFault(const Hierarchy& hierarchy)
{
  if (hierarchy.cellWidth.empty() || hierarchy.cellWidth.back() != 1)
  {
    return "expected cells of the finest level to be 1 finest cell wide";
  }
  for (std::size_t level = 1; level < hierarchy.cellWidth.size(); ++level)
  {
    const std::int64_t coarse = hierarchy.cellWidth[level - 1];
    const std::int64_t fine = hierarchy.cellWidth[level];
    if (fine < 1 || coarse <= fine || coarse % fine != 0)
    {
      return "expected a whole refinement ratio of at least 2 between levels " +
        std::to_string(level - 1) + " and " + std::to_string(level) + ", found cells " +
        std::to_string(coarse) + " and " + std::to_string(fine) + " finest cells wide";
    }
  }
  Box bounds;
  for (const Block& block : hierarchy.blocks)
  {
    if (block.level < 0 || block.level >= hierarchy.levels() || block.cells.empty())
    {
      return "expected blocks with cells on one of the hierarchy's levels, found an empty block or "
             "one of level " +
        std::to_string(block.level);
    }
    bounds = unite(bounds, hierarchy.logicalBox(block));
  }
  // Half cells have to fit 32 bits on the device.
  constexpr std::int64_t limit = std::int64_t(1) << 30;
  const Int3 size = bounds.size();
  if (std::max({ size.x, size.y, size.z }) >= limit)
  {
    return "expected a lattice of less than 2^30 finest cells along each axis, found " +
      std::to_string(std::max({ size.x, size.y, size.z })) + ": read fewer levels";
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(hierarchy.spacing[axis] > 0.0) || !std::isfinite(hierarchy.spacing[axis]) ||
      !std::isfinite(hierarchy.origin[axis]))
    {
      return "expected a finite origin and a positive, finite spacing, found origin " +
        std::to_string(hierarchy.origin[axis]) + " and spacing " +
        std::to_string(hierarchy.spacing[axis]) + " along axis " + std::to_string(axis);
    }
  }
  return {};
}
}
