// SPDX-License-Identifier: BSD-3-Clause
// Cells that lie in an embedded boundary, where codes write values that mean nothing.
#ifndef ExaBricksAdaptersCoveredCells_h
#define ExaBricksAdaptersCoveredCells_h

#include "vtkType.h"

class vtkOverlappingAMR;

namespace exabricks
{
/// Whether an array of that name tells how much of each cell is fluid: those that AMReX codes give
/// it, vfrac, volFrac and vol_frac.
bool isVolumeFraction(const char* array);

/// Marks the cells as hidden of which nothing is fluid, where the blocks have such an array;
/// returns how many they are.
vtkIdType hideCoveredCells(vtkOverlappingAMR* amr);
}

#endif
