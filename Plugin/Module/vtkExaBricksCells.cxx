// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksCells.h"

#include "Adapters/AMRCompatibility.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"

#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkExaBricksCells);

vtkExaBricksCells::vtkExaBricksCells()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::SCALARS);
}

vtkExaBricksCells::~vtkExaBricksCells() = default;

int vtkExaBricksCells::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkOverlappingAMR");
  return 1;
}

int vtkExaBricksCells::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkOverlappingAMR* input = vtkOverlappingAMR::GetData(inputVector[0], 0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector, 0);
  if (!input || !exabricks::getFirstBlock(input))
  {
    return 1; // one of several processes may have no blocks
  }
  vtkSmartPointer<vtkOverlappingAMR> amr;
  amr.TakeReference(input->NewInstance());
  amr->ShallowCopy(input);
  this->Builder->SetInputDataObject(amr);
  this->Builder->SetInputArrayToProcess(0, this->GetInputArrayInformation(0));
  this->Builder->Update();
  vtkExaBricksData* data = this->Builder->GetOutput();
  if (this->Cells == REGIONS)
  {
    data->GetRegionsAsCells(output);
  }
  else
  {
    data->GetBricksAsCells(output);
  }
  this->Builder->SetInputDataObject(nullptr);
  return 1;
}

void vtkExaBricksCells::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cells: " << (this->Cells == REGIONS ? "Regions" : "Bricks") << "\n";
}
