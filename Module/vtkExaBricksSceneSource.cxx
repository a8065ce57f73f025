// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksSceneSource.h"

#include "Adapters/SceneOutput.h"
#include "Adapters/UnfinishedRun.h"
#include "Core/LowerCase.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkOverlappingAMR.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cstdint>
#include <new>
#include <string>

vtkStandardNewMacro(vtkExaBricksSceneSource);

using exabricks::StandIn;
using exabricks::StandInKind;

static_assert(vtkExaBricksSceneSource::EXAJET_WING + 1 == exabricks::StandInKinds &&
    vtkExaBricksSceneSource::GEAR == static_cast<int>(StandInKind::Gear),
  "scenes have the numbers of the stand-ins");

struct vtkExaBricksSceneSource::vtkInternals
{
  StandIn Made; // by the last run, without its blocks, cells and triangles
  exabricks::UnfinishedRun Unfinished;
};

vtkExaBricksSceneSource::vtkExaBricksSceneSource()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkExaBricksSceneSource::~vtkExaBricksSceneSource() = default;

vtkMTimeType vtkExaBricksSceneSource::GetMTime()
{
  return this->Internals->Unfinished.modificationTime(this->Superclass::GetMTime());
}

void vtkExaBricksSceneSource::SetSceneName(const char* name)
{
  const std::string requested = exabricks::lowerCase(name ? name : "");
  std::string names;
  for (int scene = 0; scene < exabricks::StandInKinds; ++scene)
  {
    const char* known = exabricks::describe(static_cast<StandInKind>(scene)).name;
    if (exabricks::lowerCase(known) == requested)
    {
      this->SetScene(scene);
      return;
    }
    names += (scene > 0 ? ", " : "") + std::string(known);
  }
  vtkErrorMacro("Expected the name of a scene, found '" << (name ? name : "(null)")
                                                        << "'. Take one of: " << names << ".");
}

const char* vtkExaBricksSceneSource::GetSceneName()
{
  return exabricks::describe(static_cast<StandInKind>(this->Scene)).name;
}

vtkIdType vtkExaBricksSceneSource::GetLeastNumberOfLeafCells()
{
  return static_cast<vtkIdType>(
    exabricks::describe(static_cast<StandInKind>(this->Scene)).leastLeafCells);
}

double vtkExaBricksSceneSource::GetCellsPerBrickOfOriginal()
{
  return exabricks::describe(static_cast<StandInKind>(this->Scene)).cellsPerBrick;
}

vtkPolyData* vtkExaBricksSceneSource::GetMesh()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkExaBricksSceneSource::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkOverlappingAMR" : "vtkPolyData");
  return 1;
}

int vtkExaBricksSceneSource::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

int vtkExaBricksSceneSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkOverlappingAMR* amr = vtkOverlappingAMR::GetData(outputVector, 0);
  vtkPolyData* mesh = vtkPolyData::GetData(outputVector, 1);
  vtkInformation* const info = outputVector->GetInformationObject(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const exabricks::Piece piece{ info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) };
  this->Internals->Made = {};
  this->Internals->Unfinished.set(false);
  if (this->NumberOfLeafCells < this->GetLeastNumberOfLeafCells())
  {
    vtkWarningMacro("Expected at least "
      << this->GetLeastNumberOfLeafCells() << " leaf cells for " << this->GetSceneName()
      << ", found NumberOfLeafCells " << this->NumberOfLeafCells
      << ": the least number is made. Ask for it, or choose another scene.");
  }
  try
  {
    StandIn made = exabricks::makeStandIn(
      static_cast<StandInKind>(this->Scene), static_cast<std::uint64_t>(this->NumberOfLeafCells));
    const auto progress = [this](double done)
    {
      this->UpdateProgress(done);
      return !exabricks::isAborted(this);
    };
    if (!exabricks::writeAMR(made.hierarchy, *made.cells, "value", amr, progress, piece))
    {
      amr->Initialize();
      return 1;
    }
    exabricks::writeMesh(made.mesh, mesh);
    made.hierarchy = {};
    made.cells.reset();
    made.mesh = {};
    this->Internals->Made = std::move(made);
    this->Internals->Unfinished.setEnoughMemory();
  }
  catch (const std::bad_alloc&)
  {
    amr->Initialize();
    mesh->Initialize();
    if (this->Internals->Unfinished.setOutOfMemory())
    {
      vtkErrorMacro("Out of memory on the host: expected memory for "
        << this->NumberOfLeafCells << " leaf cells, which are at least "
        << 5 * static_cast<std::uint64_t>(this->NumberOfLeafCells)
        << " bytes for values and ghost marks alone. Set a smaller NumberOfLeafCells.");
    }
  }
  return 1;
}

void vtkExaBricksSceneSource::InitializeCamera(vtkCamera* camera)
{
  if (!camera)
  {
    vtkErrorMacro("Expected a camera, found none. Give the renderer's active camera.");
    return;
  }
  this->Update();
  if (this->Internals->Made.range.empty())
  {
    return; // the update has reported why
  }
  const exabricks::StandInCamera& own = this->Internals->Made.camera;
  camera->SetParallelProjection(0);
  camera->SetPosition(own.position.x, own.position.y, own.position.z);
  camera->SetFocalPoint(own.focalPoint.x, own.focalPoint.y, own.focalPoint.z);
  camera->SetViewUp(own.viewUp.x, own.viewUp.y, own.viewUp.z);
  camera->SetViewAngle(own.viewAngle);
}

void vtkExaBricksSceneSource::InitializeProperty(vtkVolumeProperty* property)
{
  if (!property)
  {
    vtkErrorMacro("Expected a volume property, found none. Give the volume's own.");
    return;
  }
  this->Update();
  const StandIn& made = this->Internals->Made;
  if (made.range.empty())
  {
    return; // the update has reported why
  }
  exabricks::writeTransfer(made.transfer, made.range, property);
  property->SetScalarOpacityUnitDistance(made.opacityUnitDistance);
  property->SetInterpolationTypeToLinear();
}

void vtkExaBricksSceneSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scene: " << this->GetSceneName() << "\n";
  os << indent << "NumberOfLeafCells: " << this->NumberOfLeafCells << "\n";
}
