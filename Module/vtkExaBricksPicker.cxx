// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksPicker.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/BrickedVolume.h"
#include "Adapters/FirstSeen.h"
#include "Core/CellSearch.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksVolumeMapper.h"

#include "vtkAMRBox.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
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

bool isDuplicate(
  vtkDataSet* block, const exabricks::BrickedVolume& bricked, double width, const glm::dvec3& cell)
{
  auto* grid = vtkImageData::SafeDownCast(block);
  vtkUnsignedCharArray* ghosts = grid ? grid->GetCellGhostArray() : nullptr;
  const glm::dvec3 middle = bricked.origin + bricked.spacing * (width * (cell + 0.5));
  int ijk[3];
  double fractions[3];
  return ghosts && grid->ComputeStructuredCoordinates(&middle.x, ijk, fractions) &&
    (ghosts->GetValue(grid->ComputeCellId(ijk)) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

// The index of a block of the level that is there and holds the cell, at best not as a duplicate of
// another block's; or -1.
int findBlock(vtkOverlappingAMR* amr, const BrickedVolume& bricked, int level, double width,
  const glm::dvec3& cell)
{
  const auto amrLevel = static_cast<unsigned int>(bricked.amrLevel[level]);
  int found = -1;
  for (unsigned int index = 0; index < exabricks::numberOfBlocks(amr, amrLevel); ++index)
  {
    const vtkAMRBox& box = amr->GetAMRBox(amrLevel, index);
    vtkDataSet* block = exabricks::getBlock(amr, amrLevel, index);
    if (!block ||
      !box.Contains(static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)))
    {
      continue;
    }
    if (!isDuplicate(block, bricked, width, cell))
    {
      return static_cast<int>(index);
    }
    found = found < 0 ? static_cast<int>(index) : found;
  }
  return found;
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
  const auto leaf = exabricks::findLeafCell(structure, glm::dvec3(inCell[0], inCell[1], inCell[2]));
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
  // The cell may be the rest of a coarser one, which finer blocks cover in part.
  const std::vector<std::int64_t>& widths = structure.hierarchy.cellWidth;
  for (int level = structure.bricks[leaf->brick].level; level >= 0; --level)
  {
    const double width = static_cast<double>(widths[level]);
    const glm::dvec3 cell = glm::floor((glm::dvec3(leaf->lo) + 0.5) / width);
    const int block = findBlock(amr, bricked, level, width, cell);
    if (block < 0)
    {
      continue;
    }
    this->Level = bricked.amrLevel[level];
    this->Block = block;
    auto* grid = vtkImageData::SafeDownCast(exabricks::getBlock(
      amr, static_cast<unsigned int>(this->Level), static_cast<unsigned int>(block)));
    const glm::dvec3 middle = bricked.origin + bricked.spacing * (width * (cell + 0.5));
    double fractions[3];
    if (grid && grid->ComputeStructuredCoordinates(&middle.x, this->CellIJK, fractions))
    {
      this->CellId = grid->ComputeCellId(this->CellIJK);
    }
    return;
  }
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
