// SPDX-License-Identifier: BSD-3-Clause
// All that depends on the hierarchy's boxes alone, and not on values: kept as long as they are.
#ifndef ExaBricksCoreStructure_h
#define ExaBricksCoreStructure_h

#include "Core/Regions.h"

namespace exabricks
{
struct Structure
{
  Hierarchy hierarchy;
  std::uint64_t leafCells = 0;
  std::size_t partlyCoveredBoxes = 0; // see LeafBoxes
  std::vector<Brick> bricks;
  RegionTree tree;

  /// Of bricks, regions, lists and tree.
  std::uint64_t bytes() const
  {
    return this->bricks.capacity() * sizeof(Brick) +
      this->tree.regions.capacity() * sizeof(layout::Region) +
      this->tree.brickLists.capacity() * sizeof(std::uint32_t) +
      this->tree.nodes.capacity() * sizeof(layout::KdNode);
  }
};

/// Leaf boxes, bricks and regions. No regions if `progress` aborts.
inline Structure buildStructure(Hierarchy hierarchy, const Progress& progress = {})
{
  Structure structure;
  structure.hierarchy = std::move(hierarchy);
  const std::vector<std::int64_t>& width = structure.hierarchy.cellWidth;
  const auto part = [&](double from, double to) -> Progress
  {
    return !progress ? Progress() : [&progress, from, to](double done) {
      return progress(from + (to - from) * done);
    };
  };
  const LeafBoxes leaves = findLeafBoxes(structure.hierarchy, part(0.0, 0.3));
  structure.leafCells = leaves.cells;
  structure.partlyCoveredBoxes = leaves.partlyCoveredBoxes;
  structure.bricks = buildBricks(leaves, width, DefaultBrickCells, part(0.3, 0.5));
  if (!structure.bricks.empty())
  {
    structure.tree = buildRegions(structure.bricks, leaves.bounds, width, {}, part(0.5, 1.0));
  }
  return structure;
}
}

#endif
