// SPDX-License-Identifier: BSD-3-Clause
#include "BrickSizes.h"

#include "Timing.h"

#include "Core/Regions.h"
#include "Core/ValueRanges.h"

#include <cstdio>

namespace exabricks
{
namespace benchmarks
{
namespace
{
template <typename Work>
double medianSeconds(int runs, const Work& work)
{
  Costs costs;
  for (int i = 0; i < runs; ++i)
  {
    costs.measure(work);
  }
  return median(costs.wall);
}
}

const char* const BrickSizesHeader =
  "scene,levels,blocks,leaf_cells,brick_cells,bricks_to_stop_at,bricks,regions,bricks_per_region,"
  "bricks_s,regions_s,bytes_per_cell";

void printBrickSizes(const std::string& name, const Hierarchy& hierarchy, int runs)
{
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  const double cells = static_cast<double>(leaves.cells);
  for (const int brickCells : { 8, 16, 32 })
  {
    std::vector<Brick> bricks;
    const double brickSeconds =
      medianSeconds(runs, [&] { bricks = buildBricks(leaves, hierarchy.cellWidth, brickCells); });
    for (const int perRegion : { 1, 2, 3, 4, 8 })
    {
      RegionTree tree;
      const double regionSeconds = medianSeconds(runs,
        [&] { tree = buildRegions(bricks, leaves.bounds, hierarchy.cellWidth, { perRegion }); });
      // all but the scalars, and what a frame adds (active regions, acceleration structure)
      const double bytes =
        static_cast<double>(bricks.size() * (sizeof(Brick) + sizeof(layout::Brick)) +
          tree.regions.size() * (sizeof(layout::Region) + sizeof(ValueRange)) +
          tree.brickLists.size() * sizeof(std::uint32_t) +
          tree.nodes.size() * sizeof(layout::KdNode));
      std::printf("\"%s\",%d,%zu,%.0f,%d,%d,%zu,%zu,%.2f,%.3f,%.3f,%.3f\n", name.c_str(),
        hierarchy.levels(), hierarchy.blocks.size(), cells, brickCells, perRegion, bricks.size(),
        tree.regions.size(),
        static_cast<double>(tree.brickLists.size()) / static_cast<double>(tree.regions.size()),
        brickSeconds, regionSeconds, bytes / cells);
      std::fflush(stdout);
    }
  }
}
}
}
