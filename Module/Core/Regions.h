// SPDX-License-Identifier: BSD-3-Clause
// Active brick regions: disjoint boxes that partition the data's bounds, each with the fixed list
// of bricks whose support reaches into it, and the k-d tree over them (Wald et al. 2020,
// section 4.2).
#ifndef ExaBricksCoreRegions_h
#define ExaBricksCoreRegions_h

#include "Core/Bricks.h"
#include "Layout.h"

namespace exabricks
{
struct RegionTree
{
  Box bounds;      // logical; the origin of all half-cell coordinates is bounds.lo
  glm::ivec3 size; // half cells
  std::vector<layout::Region> regions; // in the order of the tree's leaves
  std::vector<std::uint32_t> brickLists;
  std::vector<layout::KdNode> nodes; // the root first
};

/// Splitting stops at lists of this many bricks. A brick too many in a list weighs 0 and saves
/// regions, but costs at each sample: of 1 to 6, 1 and 2 drew fastest (a shell of 3.2 M
/// cells, on lavapipe), and 1 skips best.
constexpr int DefaultBricksPerRegion = 1;

/// The support of a brick is its box grown by half its own cell. Regions are cut at the faces of
/// supports, and at the faces of bricks where data end: a region lies in leaf cells altogether or
/// holds none (no bricks). Lists are in ascending order. Returns no nodes if `progress` aborts.
RegionTree buildRegions(const std::vector<Brick>& bricks, const Box& bounds,
  const std::vector<std::int64_t>& cellWidth, int bricksPerRegion = DefaultBricksPerRegion,
  const Progress& progress = {});
}

#endif
