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
double medianFrame(DirectMethod& method, const Size& size, int frames, double value)
{
  method.draw(size, value);
  Costs costs;
  for (int i = 0; i < frames; ++i)
  {
    costs.measure([&] { method.draw(size, value); });
  }
  return median(costs.wall);
}

void measureFrames(const Scene& scene, const Size& size, int frames, SceneFigures& figures)
{
  const auto frame = [&](const DirectSettings& settings, double value)
  {
    DirectMethod method(scene, settings);
    method.setUp(value);
    const double seconds = medianFrame(method, size, frames, value);
    figures.levelsLeftOut = method.statistics().levelsLeftOut;
    return seconds;
  };
  const Reconstruction basis = Reconstruction::Basis;
  figures.frameKdTree = frame({ basis, Traversal::KdTree }, DefaultStepScale);
  figures.frameRayQuery = frame({ basis, Traversal::RayQuery }, DefaultStepScale);
  figures.frameOfAllLevels = frame(toleranceSettings(0), GrowthTolerance);
  figures.frameByTolerance = frame(toleranceSettings({}), GrowthTolerance);
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

  figures.scalarBytes = 4.0 * static_cast<double>(scene.values().normalized.size());
  figures.brickBytes = static_cast<double>(structure.bricks.size() * sizeof(layout::Brick));
  const double listBytes = static_cast<double>(tree.brickLists.size() * sizeof(std::uint32_t));
  figures.regionHostBytes = listBytes +
    static_cast<double>(tree.regions.size() * sizeof(layout::Region) +
      tree.nodes.size() * sizeof(layout::KdNode) + scene.values().ranges.bytes());
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
  }
  DirectMethod rayQuery(scene, { Reconstruction::Basis, Traversal::RayQuery });
  rayQuery.setUp(DefaultStepScale);
  figures.rayQueryTotal = static_cast<double>(rayQuery.statistics().deviceBytes);
  const std::size_t boxBytes = active.boxes.size() * sizeof(layout::ActiveBox);
  figures.accelerationBytes =
    figures.rayQueryTotal - common - tables - static_cast<double>(boxBytes);
  if (frames > 0)
  {
    measureFrames(scene, size, frames, figures);
  }
  return figures;
}
}
}
