// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksRedistribute.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/Matrices.h"
#include "Adapters/Redistribution.h"

#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <exception>
#include <glm/matrix.hpp>

vtkStandardNewMacro(vtkExaBricksRedistribute);

struct vtkExaBricksRedistribute::vtkInternals
{
  vtkSmartPointer<vtkMultiProcessController> Controller;
  exabricks::Redistribution Redistribution;

  bool IsAlone() const
  {
    return !this->Controller || this->Controller->GetNumberOfProcesses() == 1;
  }
};

vtkExaBricksRedistribute::vtkExaBricksRedistribute()
  : Internals(new vtkInternals)
{
  this->Internals->Controller = vtkMultiProcessController::GetGlobalController();
}

vtkExaBricksRedistribute::~vtkExaBricksRedistribute() = default;

void vtkExaBricksRedistribute::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Internals->Controller)
  {
    this->Internals->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkExaBricksRedistribute::GetController()
{
  return this->Internals->Controller;
}

int vtkExaBricksRedistribute::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkOverlappingAMR");
  info->Set(
    vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // a process without must not leave others waiting
  return 1;
}

int vtkExaBricksRedistribute::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkOverlappingAMR* input = inputVector[0]->GetNumberOfInformationObjects() > 0
    ? vtkOverlappingAMR::GetData(inputVector[0], 0)
    : nullptr;
  vtkOverlappingAMR* output = vtkOverlappingAMR::GetData(outputVector, 0);
  if (this->Internals->IsAlone())
  {
    if (input)
    {
      output->ShallowCopy(input);
    }
    return 1;
  }
  std::string fault;
  try
  {
    if (input)
    {
      output->GetFieldData()->PassData(input->GetFieldData());
    }
    fault = this->Internals->Redistribution.redistribute(this->Internals->Controller, input,
      { static_cast<unsigned int>(std::max(this->LevelRange[0], 0)),
        static_cast<unsigned int>(std::max(this->LevelRange[1], 0)) },
      this->ForCompleted, output);
  }
  catch (const std::exception& error)
  {
    fault = error.what(); // what may differ between processes was agreed on
  }
  if (!fault.empty() && this->Internals->Controller->GetLocalProcessId() == 0)
  {
    vtkErrorMacro("The AMR is not shared out: " << fault << ".");
  }
  if (input && input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      input->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
  }
  return 1;
}

void vtkExaBricksRedistribute::GetFrontToBack(
  vtkCamera* camera, vtkMatrix4x4* toWorld, vtkIdList* processes)
{
  processes->Reset();
  if (this->Internals->IsAlone())
  {
    processes->InsertNextId(0);
    return;
  }
  const exabricks::SharedStructure& shared = this->Internals->Redistribution.structure();
  const glm::dmat4 fromWorld = toWorld ? glm::inverse(exabricks::toGLM(toWorld)) : glm::dmat4(1.0);
  double eye[3];
  double backward[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(backward);
  const glm::dvec4 seenFrom = fromWorld *
    (camera->GetParallelProjection() ? glm::dvec4(-backward[0], -backward[1], -backward[2], 0.0)
                                     : glm::dvec4(eye[0], eye[1], eye[2], 1.0));
  const glm::dvec3 halfCells = 2.0 *
    (glm::dvec3(seenFrom) - seenFrom.w * shared.hierarchy().origin) / shared.hierarchy().spacing;
  for (const int process : shared.parts().frontToBack(glm::dvec4(halfCells, seenFrom.w)))
  {
    processes->InsertNextId(process);
  }
}

void vtkExaBricksRedistribute::GetPartBounds(int process, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  const exabricks::SharedStructure& shared = this->Internals->Redistribution.structure();
  const auto& boxes = shared.parts().boxes;
  if (process < 0 || process >= static_cast<int>(boxes.size()) ||
    boxes[static_cast<std::size_t>(process)].empty())
  {
    return;
  }
  const exabricks::Box& box = boxes[static_cast<std::size_t>(process)];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = shared.hierarchy().origin[axis];
    const double spacing = 0.5 * shared.hierarchy().spacing[axis];
    bounds[2 * axis] = origin + spacing * static_cast<double>(box.lo[axis]);
    bounds[2 * axis + 1] = origin + spacing * static_cast<double>(box.hi[axis]);
  }
}

vtkIdType vtkExaBricksRedistribute::GetNumberOfLeafCells()
{
  return static_cast<vtkIdType>(this->Internals->Redistribution.structure().leafCells());
}

vtkIdType vtkExaBricksRedistribute::GetNumberOfCellsToDraw()
{
  return static_cast<vtkIdType>(this->Internals->Redistribution.structure().cellsToDraw());
}

vtkIdType vtkExaBricksRedistribute::GetNumberOfCells()
{
  return static_cast<vtkIdType>(this->Internals->Redistribution.cellsHeld());
}

vtkTypeInt64 vtkExaBricksRedistribute::GetBytesReceived()
{
  return static_cast<vtkTypeInt64>(this->Internals->Redistribution.bytesReceived());
}

int vtkExaBricksRedistribute::GetNumberOfStructureBuilds()
{
  return this->Internals->Redistribution.structure().builds();
}

void vtkExaBricksRedistribute::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Internals->Controller.Get() << "\n";
  os << indent << "LevelRange: " << this->LevelRange[0] << ", " << this->LevelRange[1] << "\n";
  os << indent << "ForCompleted: " << (this->ForCompleted ? "on" : "off") << "\n";
  os << indent << "NumberOfCellsToDraw: " << this->GetNumberOfCellsToDraw() << "\n";
  os << indent << "NumberOfCells: " << this->GetNumberOfCells() << "\n";
  os << indent << "BytesReceived: " << this->GetBytesReceived() << "\n";
  os << indent << "NumberOfStructureBuilds: " << this->GetNumberOfStructureBuilds() << "\n";
}
