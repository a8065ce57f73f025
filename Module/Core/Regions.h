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
  Box bounds;      // logical; bounds.lo is the origin of all coordinates in half cells
  glm::ivec3 size; // half cells
  std::vector<layout::Region> regions; // in the order of the tree's leaves
  std::vector<std::uint32_t> brickLists;
  /// The root first. Of a leaf `plane` is the width of the finest cells that reach into its region;
  /// 0: none do. Of a part of a hierarchy also of cells beyond the part's reach, which its lists
  /// lack.
  std::vector<layout::KdNode> nodes;
};

/// How long a list of bricks may be for its node to become a region. A brick too many in a list
/// weighs 0 and saves regions, but each sample pays for it. In long regions many samples do: of
/// limits from 1 to 8, those of 1 and 2 drew fastest. A ray leaves a short region after a few
/// samples, so that there fewer entries into regions save more: the small fragments of an octree
/// take a tenth of the regions, and are drawn in 0.85 to 0.95 of the time (stand-ins of 1 M cells,
/// on lavapipe).
struct RegionLimits
{
  int bricks = 1;      // in the list of any region
  int smallBricks = 8; // in the list of a region that is no longer than smallCells
  int smallCells = 6;  // length of a small region, in the finest cells that reach into it
};

/// The support of a brick is its box grown by half its own cell. Regions are cut at the faces of
/// supports, and at the faces of bricks where data end: a region lies in leaf cells altogether or
/// holds none (no bricks). Lists are in ascending order. `shown`: as of a Hierarchy; regions beyond
/// it hold nothing, and those in it what they would hold without it. Those in between are cut at
/// its faces, or left `whole`. Returns no nodes if `progress` aborts. Throws std::length_error,
/// with words for the user, if there are too many for the nodes' links.
RegionTree buildRegions(const std::vector<Brick>& bricks, const Box& bounds,
  const std::vector<std::int64_t>& cellWidth, const RegionLimits& limits = {},
  const Progress& progress = {}, const std::optional<Box>& shown = {}, bool whole = false);
}

#endif
