// SPDX-License-Identifier: BSD-3-Clause
#include "VTKScene.h"

#include "Adapters/SceneOutput.h"

#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace exabricks
{
namespace benchmarks
{
namespace
{
vtkSmartPointer<vtkVolumeProperty> makeProperty(const Scene& scene)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  writeTransfer(scene.transfer(), scene.values().range, property);
  property->SetScalarOpacityUnitDistance(scene.model().opacityUnitDistance);
  return property;
}
}

std::shared_ptr<VTKScene> makeVTKScene(const Scene& scene)
{
  auto made = std::make_shared<VTKScene>();
  made->array = "value";
  made->amr = vtkSmartPointer<vtkOverlappingAMR>::New();
  writeAMR(scene.model().hierarchy, *scene.model().cells, made->array.c_str(), made->amr);
  made->property = makeProperty(scene);
  return made;
}

vtkSmartPointer<vtkActor> makeSurfaceActor(const Surface& surface)
{
  if (surface.triangles.empty())
  {
    return nullptr;
  }
  vtkNew<vtkPolyData> data;
  writeMesh(surface, data);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkCamera> makeCamera(const Model& model)
{
  const reference::Camera& from = model.camera;
  const glm::dvec3 position = model.hierarchy.origin + from.position;
  const glm::dvec3 focus = model.hierarchy.origin + from.focalPoint;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(from.viewUp.x, from.viewUp.y, from.viewUp.z);
  camera->SetClippingRange(from.nearest, from.farthest);
  if (from.viewAngle > 0.0)
  {
    camera->SetViewAngle(from.viewAngle);
  }
  else
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(from.parallelScale);
  }
  return camera;
}

PeerData makePeerData(const Scene& scene)
{
  const VTKScene& vtk = scene.vtk();
  const Hierarchy& hierarchy = scene.model().hierarchy;
  const Box& bounds = scene.structure().tree.bounds;
  const glm::dvec3& spacing = hierarchy.spacing;
  return { vtk.amr, vtk.array, vtk.component, hierarchy.origin + spacing * glm::dvec3(bounds.lo),
    hierarchy.origin + spacing * glm::dvec3(bounds.hi),
    std::min({ spacing.x, spacing.y, spacing.z }) };
}
}
}
