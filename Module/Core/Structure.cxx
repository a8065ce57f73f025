// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Structure.h"

#include "Core/Parts.h"

namespace exabricks
{
namespace
{
// Leaves of the bricks the cells within reach of what is shown. Regions list those of them that
// they listed before.
void keepBricksInReach(Structure& structure)
{
  const Hierarchy& hierarchy = structure.hierarchy;
  std::vector<std::uint32_t> number(structure.bricks.size(), 0); // from 1 on; 0: it is left out
  std::vector<Brick> kept;
  structure.leafCells = 0;
  for (std::size_t b = 0; b < number.size(); ++b)
  {
    Brick brick = structure.bricks[b];
    const std::int64_t width = structure.width(brick);
    const std::int64_t reach = hierarchy.whole->reach[static_cast<std::size_t>(brick.level)];
    const Box near = intersection(structure.box(brick), cellsInReach(*hierarchy.shown, reach));
    if (near.empty())
    {
      continue;
    }
    const Box cells = outwardToCells(near, width);
    brick.lo = cells.lo * width;
    brick.cells = glm::ivec3(cells.size());
    kept.push_back(brick);
    number[b] = static_cast<std::uint32_t>(kept.size());
    structure.leafCells += brick.numberOfCells();
  }
  std::vector<std::uint32_t> lists;
  for (layout::Region& region : structure.tree.regions)
  {
    const auto list = structure.tree.brickLists.begin() + region.firstBrick;
    const auto first = static_cast<std::uint32_t>(lists.size());
    for (auto brick = list; brick != list + region.brickCount; ++brick)
    {
      if (number[*brick] > 0)
      {
        lists.push_back(number[*brick] - 1);
      }
    }
    region.firstBrick = first;
    region.brickCount = static_cast<std::uint32_t>(lists.size()) - first;
  }
  structure.tree.brickLists = std::move(lists);
  structure.bricks = std::move(kept);
}
}

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
  const bool isPart = structure.hierarchy.whole != nullptr;
  Hierarchy all;
  if (isPart)
  {
    all.cellWidth = width;
    all.blocks = structure.hierarchy.whole->blocks;
  }
  const LeafBoxes leaves = findLeafBoxes(isPart ? all : structure.hierarchy, part(0.0, 0.3));
  structure.leafCells = leaves.cells;
  structure.partlyCoveredBoxes = leaves.partlyCoveredBoxes;
  structure.bricks = buildBricks(leaves, width, DefaultBrickCells, part(0.3, 0.5));
  if (!structure.bricks.empty())
  {
    // Of a part, those around what is shown too, as levels are completed by what is found in them.
    std::optional<Box> shown = structure.hierarchy.shown;
    if (isPart)
    {
      const std::int64_t beyond = 2 * structure.hierarchy.whole->reach.back();
      shown = Box{ shown->lo - beyond, shown->hi + beyond };
    }
    structure.tree =
      buildRegions(structure.bricks, leaves.bounds, width, {}, part(0.5, 1.0), shown, isPart);
  }
  if (isPart)
  {
    keepBricksInReach(structure);
  }
  return structure;
}
}
