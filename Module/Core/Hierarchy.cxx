// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hierarchy.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace exabricks
{
std::string describeWideRatio(double ratio, int coarse, int fine, std::int64_t width)
{
  std::ostringstream text;
  text << "expected cells less than 2^30 finest cells wide, found a refinement ratio of "
       << std::setprecision(15) << ratio << " between levels " << coarse << " and " << fine
       << ", whose cells are " << width << (width == 1 ? " finest cell" : " finest cells")
       << " wide: read fewer levels, or check the spacings";
  return text.str();
}

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
  for (std::size_t level = hierarchy.cellWidth.size() - 1; level-- > 0;)
  {
    const std::int64_t coarse = hierarchy.cellWidth[level];
    const std::int64_t fine = hierarchy.cellWidth[level + 1];
    if (coarse >= LatticeLimit)
    {
      return describeWideRatio(static_cast<double>(coarse / fine), static_cast<int>(level),
        static_cast<int>(level) + 1, fine);
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
    // Looked at before they are multiplied with the width: sums of two products have to fit.
    const std::int64_t width = hierarchy.cellWidth[block.level];
    const std::int64_t farthest = (std::int64_t(1) << 61) / width;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (block.cells.lo[axis] < -farthest || block.cells.hi[axis] > farthest)
      {
        return "expected blocks within 2^61 finest cells of the lattice's origin, found one of "
               "level " +
          std::to_string(block.level) + " with cells from " + std::to_string(block.cells.lo[axis]) +
          " to " + std::to_string(block.cells.hi[axis]) + " along axis " + std::to_string(axis) +
          ", each " + std::to_string(width) + " finest cells wide: move the origin to the data";
      }
    }
    bounds = unite(bounds, hierarchy.logicalBox(block));
  }
  const Int3 size = bounds.size();
  if (std::max({ size.x, size.y, size.z }) >= LatticeLimit)
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
