// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/ArraySelection.h"

#include "Adapters/AMRCompatibility.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"

namespace exabricks
{
namespace
{
// Asked for an attribute, VTK marks the filter as modified even where nothing changes: it would
// run again for every picture.
void selectActiveScalars(vtkAlgorithm* filter, int association)
{
  vtkInformation* present = filter->GetInputArrayInformation(0);
  if (present->Has(vtkDataObject::FIELD_NAME()) ||
    present->Get(vtkDataObject::FIELD_ASSOCIATION()) != association)
  {
    filter->SetInputArrayToProcess(0, 0, 0, association, vtkDataSetAttributes::SCALARS);
  }
}

// By the number that the array has in the first block that is there. Returns why it cannot.
std::string findArrayName(vtkAbstractVolumeMapper* mapper, int association, std::string& name)
{
  mapper->GetInputAlgorithm(0, 0)->Update();
  vtkOverlappingAMR* amr = vtkOverlappingAMR::SafeDownCast(mapper->GetDataObjectInput());
  vtkDataSet* block = amr ? getFirstBlock(amr) : nullptr;
  vtkDataSetAttributes* data = block ? block->GetAttributes(association) : nullptr;
  const int id = mapper->GetArrayId();
  const char* found = data && id >= 0 ? data->GetArrayName(id) : nullptr;
  if (!found)
  {
    return "Expected the number of an array from 0 to " +
      std::to_string(data ? data->GetNumberOfArrays() - 1 : -1) + ", found " + std::to_string(id) +
      ". Call SelectScalarArray() with the name of an array";
  }
  name = found;
  return {};
}

std::string selectNamedArray(vtkAlgorithm* filter, vtkAbstractVolumeMapper* mapper, int association)
{
  std::string name = mapper->GetArrayName() ? mapper->GetArrayName() : "";
  if (mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_ID)
  {
    const std::string fault = findArrayName(mapper, association, name);
    if (!fault.empty())
    {
      return fault;
    }
  }
  filter->SetInputArrayToProcess(0, 0, 0, association, name.c_str());
  return {};
}
}

std::string selectArray(vtkAlgorithm* filter, vtkAbstractVolumeMapper* mapper)
{
  switch (mapper->GetScalarMode())
  {
    case VTK_SCALAR_MODE_DEFAULT:
      selectActiveScalars(filter, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS);
      return {};
    case VTK_SCALAR_MODE_USE_POINT_DATA:
      selectActiveScalars(filter, vtkDataObject::FIELD_ASSOCIATION_POINTS);
      return {};
    case VTK_SCALAR_MODE_USE_CELL_DATA:
      selectActiveScalars(filter, vtkDataObject::FIELD_ASSOCIATION_CELLS);
      return {};
    case VTK_SCALAR_MODE_USE_POINT_FIELD_DATA:
      return selectNamedArray(filter, mapper, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
      return selectNamedArray(filter, mapper, vtkDataObject::FIELD_ASSOCIATION_CELLS);
    default:
      return std::string("Expected a scalar mode of points or cells, found ") +
        mapper->GetScalarModeAsString() + ". Call one of SetScalarModeTo...";
  }
}
}
