// SPDX-License-Identifier: BSD-3-Clause
// What a scene is cut into, and what it takes on the host and on the device.
#include "DirectMethods.h"
#include "Measure.h"
#include "Timing.h"

#include "Core/ActiveRegions.h"

namespace exabricks
{
namespace benchmarks
{
namespace
{
double medianFrame(DirectMethod& method, const Size& size, int frames)
{
  if (frames == 0)
  {
    return NotMeasured;
  }
  method.draw(size, DefaultStepScale);
  Costs costs;
  for (int i = 0; i < frames; ++i)
  {
    costs.measure([&] { method.draw(size, DefaultStepScale); });
  }
  return median(costs.wall);
}
}

SceneFigures measureFigures(
  const Scene& scene, const std::string& group, const Size& size, int frames)
{
  const Structure& structure = scene.structure();
  const RegionTree& tree = structure.tree;
  SceneFigures figures;
  figures.scene = scene.name();
  figures.group = group;
  figures.levels = structure.hierarchy.levels();
  figures.blocks = static_cast<double>(structure.hierarchy.blocks.size());
  figures.leafCells = static_cast<double>(structure.leafCells);
  figures.bricks = static_cast<double>(structure.bricks.size());
  figures.regions = static_cast<double>(tree.regions.size());
  figures.structureTime = scene.structureTime;
  figures.gatherTime = scene.gatherTime;
  figures.rangesTime = scene.rangesTime;
  figures.hostBytes = static_cast<double>(scene.hostBytes(Reconstruction::Basis));
  figures.surfaceBytes = static_cast<double>(scene.model().surface.bytes());

  figures.scalarBytes = 4.0 * static_cast<double>(scene.scalars().values.size());
  figures.brickBytes = static_cast<double>(structure.bricks.size() * sizeof(layout::Brick));
  const double listBytes = static_cast<double>(tree.brickLists.size() * sizeof(std::uint32_t));
  figures.regionHostBytes = listBytes +
    static_cast<double>(tree.regions.size() * sizeof(layout::Region) +
      tree.nodes.size() * sizeof(layout::KdNode) + scene.ranges().bytes());
  const ActiveRegions active =
    selectActiveRegions(scene.volume(Reconstruction::Basis), scene.transfer());
  figures.activeRegions = static_cast<double>(active.regions);
  figures.kdTreeBytes = static_cast<double>(active.nodes.size() * sizeof(layout::KdNode));
  figures.regionBytes = listBytes + figures.kdTreeBytes;
  const double common = figures.scalarBytes + figures.brickBytes + listBytes;

  double tables = 0.0;
  {
    DirectMethod kdTree(scene, { Reconstruction::Basis, Traversal::KdTree });
    kdTree.setUp(DefaultStepScale);
    figures.kdTreeTotal = static_cast<double>(kdTree.statistics().deviceBytes);
    tables = figures.kdTreeTotal - common - figures.kdTreeBytes;
    figures.frameKdTree = medianFrame(kdTree, size, frames);
  }
  DirectMethod rayQuery(scene, { Reconstruction::Basis, Traversal::RayQuery });
  rayQuery.setUp(DefaultStepScale);
  figures.rayQueryTotal = static_cast<double>(rayQuery.statistics().deviceBytes);
  const std::size_t boxBytes = active.boxes.size() * sizeof(layout::ActiveBox);
  figures.accelerationBytes =
    figures.rayQueryTotal - common - tables - static_cast<double>(boxBytes);
  figures.frameRayQuery = medianFrame(rayQuery, size, frames);
  return figures;
}
}
}
