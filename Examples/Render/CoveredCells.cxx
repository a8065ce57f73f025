// SPDX-License-Identifier: BSD-3-Clause

#include "CoveredCells.h"

#include "Blocks.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cctype>

namespace render
{

std::string findVolumeFraction(const std::vector<std::string>& arrays)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(),
    [](std::string name)
    {
      std::transform(name.begin(), name.end(), name.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      return name == "vfrac" || name == "volfrac" || name == "vol_frac";
    });
  return found == arrays.end() ? std::string() : *found;
}

vtkIdType hideCoveredCells(vtkOverlappingAMR* amr, const std::string& volumeFraction)
{
  vtkIdType hidden = 0;
  forEachBlock(amr,
    [&](vtkDataSet* block)
    {
      vtkDataArray* fraction = block->GetCellData()->GetArray(volumeFraction.c_str());
      if (!fraction)
      {
        return;
      }
      vtkUnsignedCharArray* ghosts = block->GetCellGhostArray();
      if (!ghosts)
      {
        ghosts = block->AllocateCellGhostArray();
      }
      for (vtkIdType i = 0; i < fraction->GetNumberOfTuples(); ++i)
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
