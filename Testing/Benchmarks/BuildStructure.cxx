// SPDX-License-Identifier: BSD-3-Clause
// Times the building of bricks, regions and value ranges from block-structured AMR, and counts what
// they take: `BuildStructure [runs]`; each time is the median of that many runs (5).
#include "Core/Regions.h"
#include "Core/Scalars.h"
#include "Reference/Scenes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace exabricks;

namespace
{
double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Runs `work` several times; returns the median of the seconds it took.
template <typename Work>
double measure(int runs, const Work& work)
{
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    work();
    seconds.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return median(seconds);
}

// Cheap and smooth, as the values are not what is measured.
class WaveSource : public CellSource
{
public:
  void read(int block, const Box& cells, double* values) const override
  {
    for (std::int64_t z = cells.lo.z; z < cells.hi.z; ++z)
    {
      for (std::int64_t y = cells.lo.y; y < cells.hi.y; ++y)
      {
        const double row = std::sin(0.05 * static_cast<double>(y + z + block));
        for (std::int64_t x = cells.lo.x; x < cells.hi.x; ++x)
        {
          *values++ = row + 0.01 * static_cast<double>(x);
        }
      }
    }
  }
};

void runCase(const char* name, const Hierarchy& hierarchy, int runs)
{
  LeafBoxes leaves;
  const double leafSeconds = measure(runs, [&] { leaves = findLeafBoxes(hierarchy); });
  const double cells = static_cast<double>(leaves.cells);
  std::printf("%s: %d levels, %zu blocks, %.2f M leaf cells in %zu boxes, found in %.3f s\n", name,
    hierarchy.levels(), hierarchy.blocks.size(), cells / 1e6, leaves.boxes.size(), leafSeconds);
  std::printf("brick  per     bricks    regions   list  bricks s  gather s  regions s  ranges s "
              " total s  Mcells/s  bytes/cell\n");
  for (const int brickCells : { 8, 16, 32 })
  {
    std::vector<Brick> bricks;
    const double brickSeconds =
      measure(runs, [&] { bricks = buildBricks(leaves, hierarchy.cellWidth, brickCells); });
    Scalars scalars;
    const double gatherSeconds =
      measure(runs, [&] { scalars = gatherScalars(hierarchy, bricks, WaveSource()); });
    for (const int perRegion : { 1, 2, 3, 4, 8 })
    {
      RegionTree tree;
      const double regionSeconds = measure(runs,
        [&] { tree = buildRegions(bricks, leaves.bounds, hierarchy.cellWidth, { perRegion }); });
      ValueRanges ranges;
      const double rangeSeconds = measure(
        runs, [&] { ranges = findValueRanges(tree, bricks, hierarchy.cellWidth, scalars); });

      // all but the scalars and what a frame adds (active regions, acceleration structure)
      const double bytes =
        static_cast<double>(bricks.size() * (sizeof(Brick) + sizeof(layout::Brick)) +
          tree.regions.size() * (sizeof(layout::Region) + sizeof(ValueRange)) +
          tree.brickLists.size() * sizeof(std::uint32_t) +
          tree.nodes.size() * sizeof(layout::KdNode));
      const double total = leafSeconds + brickSeconds + regionSeconds + rangeSeconds;
      std::printf("%5d %4d %10zu %10zu %6.2f %9.3f %9.3f %10.3f %9.3f %8.3f %9.1f %11.3f\n",
        brickCells, perRegion, bricks.size(), tree.regions.size(),
        static_cast<double>(tree.brickLists.size()) / static_cast<double>(tree.regions.size()),
        brickSeconds, gatherSeconds, regionSeconds, rangeSeconds, total, cells / total / 1e6,
        bytes / cells);
      std::fflush(stdout);
    }
  }
}
}

int main(int argc, char** argv)
{
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf(
    "\"total\" is all stages but the gathering of values; \"list\" is bricks per region\n");
  // As of a block-structured solver: every level in blocks of 32^3 cells.
  runCase("blocks of 32^3", reference::refinedAtShell({ 2, 2 }, 128, 32), runs);
  // Crumbs around a thin shell: small blocks over four levels.
  runCase("wrinkled shell, blocks of 16^3", reference::refinedAtShell({ 2, 2, 2 }, 32, 16), runs);
}
