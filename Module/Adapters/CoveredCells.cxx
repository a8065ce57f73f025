// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/CoveredCells.h"

#include "Adapters/AMRCompatibility.h"
#include "Core/LowerCase.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace exabricks
{
bool isVolumeFraction(const char* array)
{
  const std::string name = lowerCase(array ? array : "");
  return name == "vfrac" || name == "volfrac" || name == "vol_frac";
}

vtkIdType hideCoveredCells(vtkOverlappingAMR* amr)
{
  vtkIdType hidden = 0;
  forEachBlock(amr,
    [&](vtkDataSet* block)
    {
      vtkCellData* const cells = block->GetCellData();
      vtkDataArray* fraction = nullptr;
      for (int i = 0; i < cells->GetNumberOfArrays() && !fraction; ++i)
      {
        fraction = isVolumeFraction(cells->GetArrayName(i)) ? cells->GetArray(i) : nullptr;
      }
      if (!fraction)
      {
        return;
      }
      vtkUnsignedCharArray* ghosts = block->GetCellGhostArray();
      if (!ghosts)
      {
        ghosts = block->AllocateCellGhostArray();
      }
      for (vtkIdType i = 0;
           i < std::min(fraction->GetNumberOfTuples(), ghosts->GetNumberOfTuples()); ++i)
      {
        if (!(fraction->GetComponent(i, 0) > 0.0))
        {
          ghosts->SetValue(i, ghosts->GetValue(i) | vtkDataSetAttributes::HIDDENCELL);
          ++hidden;
        }
      }
      ghosts->Modified();
    });
  return hidden;
}
}
