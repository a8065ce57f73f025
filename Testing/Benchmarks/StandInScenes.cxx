// SPDX-License-Identifier: BSD-3-Clause
// The stand-ins for the source's models (Module/Scenes), of any size.
#include "SceneTable.h"
#include "StoredSource.h"

#include "Reference/Scenes.h"
#include "Scenes/StandIn.h"

#include <glm/geometric.hpp>

namespace exabricks
{
namespace benchmarks
{
namespace
{
constexpr double FullCells = 1e6;

// The clipping range that all of the hierarchy lies in.
void fitClipping(const Hierarchy& hierarchy, reference::Camera& camera)
{
  const glm::dvec3 forward = glm::normalize(camera.focalPoint - camera.position);
  const Box bounds = reference::boundsOf(hierarchy);
  camera.nearest = std::numeric_limits<double>::infinity();
  camera.farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Int3 at(corner & 1 ? bounds.hi.x : bounds.lo.x, corner & 2 ? bounds.hi.y : bounds.lo.y,
      corner & 4 ? bounds.hi.z : bounds.lo.z);
    const double distance = glm::dot(forward, hierarchy.spacing * glm::dvec3(at) - camera.position);
    camera.nearest = std::min(camera.nearest, distance);
    camera.farthest = std::max(camera.farthest, distance);
  }
  camera.farthest *= 1.001;
  camera.nearest = std::max(0.999 * camera.nearest, 1e-3 * camera.farthest);
}

Model makeStandInModel(StandInKind kind, double leafCells)
{
  auto made = std::make_shared<StandIn>(makeStandIn(kind, static_cast<std::uint64_t>(leafCells)));
  Model model;
  model.name = describe(kind).name;
  model.hierarchy = made->hierarchy;
  model.cells = std::make_shared<StoredSource>(made->hierarchy, *made->cells);
  model.transfer = [made](const Range& range) { return made->transferFor(range); };
  model.opacityUnitDistance = made->opacityUnitDistance;
  model.camera.position = made->camera.position - made->hierarchy.origin;
  model.camera.focalPoint = made->camera.focalPoint - made->hierarchy.origin;
  model.camera.viewUp = made->camera.viewUp;
  model.camera.viewAngle = made->camera.viewAngle;
  fitClipping(made->hierarchy, model.camera);
  model.tolerance = 1e-5; // on average a hundredth of that is left, and a twentieth of the time
  model.surface = { made->mesh };
  return model;
}
}

std::vector<SceneKind> listStandInScenes()
{
  std::vector<SceneKind> scenes;
  for (int i = 0; i < StandInKinds; ++i)
  {
    const auto kind = static_cast<StandInKind>(i);
    // With the many blocks of the others, peers take hours.
    const bool fewBlocks = kind == StandInKind::Wind || kind == StandInKind::Gear;
    // One of crumbs and one of large blocks for the charts of growth.
    const bool scalable = kind == StandInKind::Cloud || kind == StandInKind::Wind;
    scenes.push_back({ describe(kind).name, "stand-in", false, true,
      [=](double asked) { return makeStandInModel(kind, asked > 0.0 ? asked : FullCells); },
      scalable, fewBlocks });
  }
  return scenes;
}
}
}
