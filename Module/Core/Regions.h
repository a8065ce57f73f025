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

/// Where splitting stops. A brick too many in a list weighs 0 and saves regions, but costs at each
/// sample. In long regions it does so often: of 1 to 8, 1 and 2 drew fastest. A ray leaves a short
/// one after a few samples, and what saves it entries pays: crumbs of an octree take a tenth of the
/// regions and are drawn in 0.85 to 0.95 of the time (stand-ins of 1 M cells, on lavapipe).
struct RegionLimits
{
  int bricks = 1;      // of any region
  int smallBricks = 8; // of one that is no longer than ...
  int smallCells = 6;  // ... so many of its finest cells
};

/// The support of a brick is its box grown by half its own cell. Regions are cut at the faces of
/// supports, and at the faces of bricks where data end: a region lies in leaf cells altogether or
/// holds none (no bricks). Lists are in ascending order. Returns no nodes if `progress` aborts.
/// Throws std::length_error, with words for the user, if there are too many for the nodes' links.
RegionTree buildRegions(const std::vector<Brick>& bricks, const Box& bounds,
  const std::vector<std::int64_t>& cellWidth, const RegionLimits& limits = {},
  const Progress& progress = {});
}

#endif
