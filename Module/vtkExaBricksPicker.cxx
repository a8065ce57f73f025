// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksPicker.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/BrickedVolume.h"
#include "Core/CellSearch.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksVolumeMapper.h"

#include "vtkAMRBox.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkExaBricksPicker);

namespace
{
using exabricks::BrickedVolume;

// The volume's picture of one ray.
struct Hit
{
  vtkVolume* volume = nullptr;
  std::shared_ptr<const BrickedVolume> bricked;
  glm::dvec3 halfCells{ 0.0 };
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

// The cell of a block that is there, by its place in the level's lattice. The index of the block,
// or -1: the level has none.
int findBlock(vtkOverlappingAMR* amr, unsigned int level, const int cell[3])
{
  for (unsigned int index = 0; index < exabricks::numberOfBlocks(amr, level); ++index)
  {
    const vtkAMRBox& box = amr->GetAMRBox(level, index);
    if (box.Contains(cell[0], cell[1], cell[2]) && exabricks::getBlock(amr, level, index))
    {
      return static_cast<int>(index);
    }
  }
  return -1;
}
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
  this->SelectionPoint[0] = x;
  this->SelectionPoint[1] = y;
  this->SelectionPoint[2] = z;
  this->InvokeEvent(vtkCommand::StartPickEvent, nullptr);

  Hit nearest;
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator iterator;
  volumes->InitTraversal(iterator);
  while (vtkVolume* volume = volumes->GetNextVolume(iterator))
  {
    auto* mapper = vtkExaBricksVolumeMapper::SafeDownCast(volume->GetMapper());
    if (!mapper || !volume->GetVisibility() || !volume->GetPickable() ||
      (this->PickFromList && !this->PickList->IsItemPresent(volume)))
    {
      continue;
    }
    Hit hit;
    hit.volume = volume;
    if (!mapper->FindFirstSeen(
          renderer, volume, x, y, this->VolumeOpacityIsovalue, &hit.halfCells.x))
    {
      continue;
    }
    hit.bricked = mapper->GetBuilder()->GetOutput()->GetBrickedVolume();
    const glm::dvec3 place = hit.bricked->world(hit.halfCells);
    const double point[4] = { place.x, place.y, place.z, 1.0 };
    double moved[4];
    volume->GetMatrix()->MultiplyPoint(point, moved);
    std::copy_n(moved, 3, hit.position);
    hit.distance = distanceFromCamera(renderer->GetActiveCamera(), hit.position);
    if (hit.distance < nearest.distance)
    {
      nearest = hit;
    }
  }
  if (nearest.volume)
  {
    std::copy_n(nearest.position, 3, this->PickPosition);
    this->FindCell(*nearest.bricked,
      vtkOverlappingAMR::SafeDownCast(nearest.volume->GetMapper()->GetDataObjectInput()),
      &nearest.halfCells.x);
    vtkNew<vtkAssemblyPath> path;
    path->AddNode(nearest.volume, nearest.volume->GetMatrix());
    this->SetPath(path);
    nearest.volume->Pick();
    this->InvokeEvent(vtkCommand::PickEvent, nullptr);
  }
  this->InvokeEvent(vtkCommand::EndPickEvent, nullptr);
  return nearest.volume ? 1 : 0;
}

void vtkExaBricksPicker::FindCell(
  const BrickedVolume& bricked, vtkOverlappingAMR* amr, const double halfCells[3])
{
  const exabricks::Structure& structure = *bricked.volume.structure;
  const auto leaf =
    exabricks::findLeafCell(structure, glm::dvec3(halfCells[0], halfCells[1], halfCells[2]));
  if (!leaf || !amr)
  {
    return;
  }
  for (std::size_t k = 0; k < bricked.volume.components(); ++k)
  {
    const exabricks::Values& values = *bricked.volume.valuesOf(k);
    this->Values.push_back(values.range.min +
      values.ofBrick(leaf->brick)[leaf->number] * (values.range.max - values.range.min));
  }
  // The cell may be the rest of a coarser one, which finer blocks cover in part.
  const std::vector<std::int64_t>& widths = structure.hierarchy.cellWidth;
  for (int level = structure.bricks[leaf->brick].level; level >= 0; --level)
  {
    const double width = static_cast<double>(widths[level]);
    const glm::dvec3 at = glm::floor((glm::dvec3(leaf->lo) + 0.5) / width);
    const int cell[3] = { static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z) };
    const int block = findBlock(amr, static_cast<unsigned int>(bricked.amrLevel[level]), cell);
    if (block < 0)
    {
      continue;
    }
    auto* grid = vtkImageData::SafeDownCast(exabricks::getBlock(
      amr, static_cast<unsigned int>(bricked.amrLevel[level]), static_cast<unsigned int>(block)));
    const glm::dvec3 middle = bricked.origin + bricked.spacing * (width * (at + 0.5));
    double fractions[3];
    this->Level = bricked.amrLevel[level];
    this->Block = block;
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
