// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Structure.h"

namespace exabricks
{
Structure buildStructure(Hierarchy hierarchy, const Progress& progress)
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
    structure.tree = buildRegions(
      structure.bricks, leaves.bounds, width, {}, part(0.5, 1.0), structure.hierarchy.shown);
  }
  return structure;
}
}
