// SPDX-License-Identifier: BSD-3-Clause
// Cells that lie in an embedded boundary, where codes write values that mean nothing.

#ifndef ExaBricksRenderCoveredCells_h
#define ExaBricksRenderCoveredCells_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkOverlappingAMR;

namespace render
{

// The array that tells how much of each cell is fluid, by the names that AMReX codes give it; empty
// if there is none.
std::string findVolumeFraction(const std::vector<std::string>& arrays);

// Marks the cells as hidden of which nothing is fluid, and returns how many they are.
vtkIdType hideCoveredCells(vtkOverlappingAMR* amr, const std::string& volumeFraction);

}

#endif
