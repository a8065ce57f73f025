// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksPicker.h"

#include "Adapters/BlockSearch.h"
#include "Adapters/FirstSeen.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksVolumeMapper.h"

#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkExaBricksPicker);

namespace
{
using exabricks::BrickedVolume;

// Where one volume is first seen along the ray.
struct Hit
{
  vtkSmartPointer<vtkAssemblyPath> path; // to the volume
  std::shared_ptr<const BrickedVolume> bricked;
  vtkOverlappingAMR* amr = nullptr;
  glm::dvec3 inCell{ 0.0 };               // half cells
  double position[3] = { 0.0, 0.0, 0.0 }; // world
  double distance = std::numeric_limits<double>::infinity();
};

// From the camera's position; along its view where all rays are parallel.
double distanceFromCamera(vtkCamera* camera, const double position[3])
{
  double way[3];
  vtkMath::Subtract(position, camera->GetPosition(), way);
  return camera->GetParallelProjection() ? vtkMath::Dot(way, camera->GetDirectionOfProjection())
                                         : vtkMath::Norm(way);
}

// The path's volume where one of ours draws it, and it may be picked.
vtkVolume* findVolume(vtkAssemblyPath* path)
{
  vtkVolume* volume = vtkVolume::SafeDownCast(path->GetLastNode()->GetViewProp());
  return volume && volume->GetVisibility() && volume->GetPickable() &&
      vtkExaBricksVolumeMapper::SafeDownCast(volume->GetMapper())
    ? volume
    : nullptr;
}

// Puts the volume where its path, which may lead through assemblies, has it.
class MovedByPath
{
public:
  MovedByPath(vtkVolume* volume, vtkAssemblyPath* path)
    : Volume(volume)
  {
    volume->PokeMatrix(path->GetLastNode()->GetMatrix());
  }
  ~MovedByPath() { this->Volume->PokeMatrix(nullptr); }
  MovedByPath(const MovedByPath&) = delete;
  void operator=(const MovedByPath&) = delete;

private:
  vtkVolume* const Volume;
};
}

void vtkExaBricksPicker::Initialize()
{
  this->Superclass::Initialize();
  this->Level = -1;
  this->Block = -1;
  this->CellId = -1;
  this->Values.clear();
  std::fill_n(this->CellIJK, 3, -1);
}

int vtkExaBricksPicker::Pick(double x, double y, double z, vtkRenderer* renderer)
{
  this->Initialize();
  this->SetPath(nullptr);
  this->Renderer = renderer;
  if (!renderer || !renderer->GetRenderWindow())
  {
    vtkErrorMacro("Expected a renderer in a window to pick in, found "
      << (renderer ? "one without a window" : "none") << ".");
    return 0;
  }
  this->SelectionPoint[0] = x;
  this->SelectionPoint[1] = y;
  this->SelectionPoint[2] = z;
  this->InvokeEvent(vtkCommand::StartPickEvent, nullptr);

  Hit nearest;
  vtkPropCollection* props = this->PickFromList ? this->PickList : renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* prop = props->GetNextProp(place))
  {
    if (!prop->GetVisibility() || !prop->GetPickable())
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkVolume* volume = findVolume(path);
      if (!volume)
      {
        continue;
      }
      const MovedByPath moved(volume, path);
      auto* mapper = vtkExaBricksVolumeMapper::SafeDownCast(volume->GetMapper());
      const auto seen = mapper->FindFirstSeen(renderer, volume, x, y, this->VolumeOpacityIsovalue);
      if (!seen)
      {
        continue;
      }
      Hit hit;
      hit.inCell = seen->inCell;
      hit.bricked = mapper->GetBuilder()->GetOutput()->GetBrickedVolume();
      hit.amr = vtkOverlappingAMR::SafeDownCast(mapper->GetDataObjectInput());
      const glm::dvec3 at = hit.bricked->world(seen->place);
      const double point[4] = { at.x, at.y, at.z, 1.0 };
      double inWorld[4];
      volume->GetMatrix()->MultiplyPoint(point, inWorld);
      std::copy_n(inWorld, 3, hit.position);
      hit.distance = distanceFromCamera(renderer->GetActiveCamera(), hit.position);
      if (hit.distance < nearest.distance)
      {
        hit.path = vtkSmartPointer<vtkAssemblyPath>::New();
        hit.path->ShallowCopy(path);
        nearest = hit;
      }
    }
  }
  if (nearest.path)
  {
    std::copy_n(nearest.position, 3, this->PickPosition);
    this->FindCell(*nearest.bricked, nearest.amr, &nearest.inCell.x);
    this->SetPath(nearest.path);
    nearest.path->GetLastNode()->GetViewProp()->Pick();
    this->InvokeEvent(vtkCommand::PickEvent, nullptr);
  }
  this->InvokeEvent(vtkCommand::EndPickEvent, nullptr);
  return nearest.path ? 1 : 0;
}

void vtkExaBricksPicker::FindCell(
  const BrickedVolume& bricked, vtkOverlappingAMR* amr, const double inCell[3])
{
  const exabricks::Structure& structure = *bricked.volume.structure;
  const glm::dvec3 place(inCell[0], inCell[1], inCell[2]);
  const auto leaf = exabricks::findLeafCell(structure, place);
  if (!leaf || !amr)
  {
    return;
  }
  for (std::size_t k = 0; k < bricked.volume.components(); ++k)
  {
    const exabricks::Values& values = *bricked.volume.valuesOf(k);
    const float normalized = values.ofBrick(leaf->brick)[leaf->number];
    this->Values.push_back(normalized < 0.0f
        ? std::numeric_limits<double>::quiet_NaN()
        : values.range.min + normalized * (values.range.max - values.range.min));
  }
  const exabricks::CellOfBlock cell = exabricks::BlockSearch(amr, bricked).find(*leaf, place);
  this->Level = cell.level;
  this->Block = cell.block;
  this->CellId = cell.id;
  std::copy_n(cell.ijk, 3, this->CellIJK);
}

double vtkExaBricksPicker::GetValue(int component)
{
  return component >= 0 && component < static_cast<int>(this->Values.size())
    ? this->Values[component]
    : std::numeric_limits<double>::quiet_NaN();
}

void vtkExaBricksPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VolumeOpacityIsovalue: " << this->VolumeOpacityIsovalue << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Block: " << this->Block << "\n";
  os << indent << "CellId: " << this->CellId << "\n";
  os << indent << "CellIJK: " << this->CellIJK[0] << ", " << this->CellIJK[1] << ", "
     << this->CellIJK[2] << "\n";
  os << indent << "Value: " << this->GetValue() << "\n";
}
