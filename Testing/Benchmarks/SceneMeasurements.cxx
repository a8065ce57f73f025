// SPDX-License-Identifier: BSD-3-Clause
// What a scene is cut into, and what it takes on the host and on the device.
#include "DirectMethods.h"
#include "Measure.h"
#include "Timing.h"

#include "Core/ActiveRegions.h"
#include "Vulkan/Traversals.h"

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

void measureFrames(
  const Scene& scene, const Size& size, int frames, bool queriesRays, SceneMeasurements& measured)
{
  const auto frame = [&](const DirectSettings& settings, double value)
  {
    DirectMethod method(scene, settings);
    method.setUp(value);
    const double seconds = medianFrame(method, size, frames, value);
    measured.levelsLeftOut = method.statistics().levelsLeftOut;
    return seconds;
  };
  const Reconstruction basis = Reconstruction::Basis;
  measured.frameKdTree = frame({ basis, Traversal::KdTree }, DefaultStepScale);
  if (queriesRays)
  {
    measured.frameRayQuery = frame({ basis, Traversal::RayQuery }, DefaultStepScale);
  }
  measured.frameOfAllLevels = frame(toleranceSettings(0), GrowthTolerance);
  measured.frameByTolerance = frame(toleranceSettings({}), GrowthTolerance);
}
}

SceneMeasurements measureStructure(
  const Scene& scene, const std::string& group, const Size& size, int frames)
{
  const Structure& structure = scene.structure();
  const RegionTree& tree = structure.tree;
  SceneMeasurements measured;
  measured.scene = scene.name();
  measured.group = group;
  measured.levels = structure.hierarchy.levels();
  measured.blocks = static_cast<double>(structure.hierarchy.blocks.size());
  measured.leafCells = static_cast<double>(structure.leafCells);
  measured.bricks = static_cast<double>(structure.bricks.size());
  measured.regions = static_cast<double>(tree.regions.size());
  measured.structureTime = scene.structureTime;
  measured.gatherTime = scene.gatherTime;
  measured.rangesTime = scene.rangesTime;
  measured.hostBytes = static_cast<double>(scene.hostBytes(Reconstruction::Basis));
  measured.surfaceBytes = static_cast<double>(scene.model().surface.bytes());

  measured.scalarBytes = 4.0 * static_cast<double>(scene.values().normalized.size());
  measured.brickBytes = static_cast<double>(structure.bricks.size() * sizeof(layout::Brick));
  const double listBytes = static_cast<double>(tree.brickLists.size() * sizeof(std::uint32_t));
  measured.regionHostBytes = listBytes +
    static_cast<double>(tree.regions.size() * sizeof(layout::Region) +
      tree.nodes.size() * sizeof(layout::KdNode) + scene.values().ranges.bytes());
  const ActiveRegions active =
    selectActiveRegions(scene.volume(Reconstruction::Basis), scene.transfer());
  measured.activeRegions = static_cast<double>(active.regions);
  measured.kdTreeBytes = static_cast<double>(active.nodes.size() * sizeof(layout::KdNode));
  measured.regionBytes = listBytes + measured.kdTreeBytes;
  const double common = measured.scalarBytes + measured.brickBytes + listBytes;

  double tables = 0.0;
  {
    DirectMethod kdTree(scene, { Reconstruction::Basis, Traversal::KdTree });
    kdTree.setUp(DefaultStepScale);
    measured.kdTreeTotal = static_cast<double>(kdTree.statistics().deviceBytes);
    tables = measured.kdTreeTotal - common - measured.kdTreeBytes;
  }
  const bool queriesRays = deviceHasRayQuery();
  if (queriesRays)
  {
    DirectMethod rayQuery(scene, { Reconstruction::Basis, Traversal::RayQuery });
    rayQuery.setUp(DefaultStepScale);
    measured.rayQueryTotal = static_cast<double>(rayQuery.statistics().deviceBytes);
    const std::size_t boxBytes = active.boxes.size() * sizeof(layout::ActiveBox);
    measured.accelerationBytes =
      measured.rayQueryTotal - common - tables - static_cast<double>(boxBytes);
  }
  if (frames > 0)
  {
    measureFrames(scene, size, frames, queriesRays, measured);
  }
  return measured;
}
}
}
