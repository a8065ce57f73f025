// SPDX-License-Identifier: BSD-3-Clause
// The logarithm of a cell array, as a cell array of its own.
#ifndef ExaBricksAdaptersLogarithm_h
#define ExaBricksAdaptersLogarithm_h

#include <string>

class vtkOverlappingAMR;

namespace exabricks
{
/// Adds log10 of a cell array to every block that has it and returns its name. Of several
/// components one is taken, or the magnitude where `component` is negative. Where there is no
/// logarithm the value is NaN, which the mapper takes for an absent cell.
std::string addLogarithm(vtkOverlappingAMR* amr, const std::string& array, int component);
}

#endif
