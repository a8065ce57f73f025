// SPDX-License-Identifier: BSD-3-Clause
// The array by which VTK marks cells and points (vtkGhostType).
#ifndef ExaBricksAdaptersGhosts_h
#define ExaBricksAdaptersGhosts_h

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace exabricks
{
/// vtkGhostType of each cell or point; null, if none is of this kind.
inline const unsigned char* findGhosts(vtkFieldData* data, vtkIdType count, unsigned char kind)
{
  auto* ghosts =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const unsigned char* first =
    ghosts && ghosts->GetNumberOfValues() == count ? ghosts->GetPointer(0) : nullptr;
  return first &&
      std::any_of(first, first + count, [kind](unsigned char ghost) { return ghost & kind; })
    ? first
    : nullptr;
}
}

#endif
