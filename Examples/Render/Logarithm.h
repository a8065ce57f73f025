// SPDX-License-Identifier: BSD-3-Clause
// The logarithm of a cell array, as a cell array of its own.

#ifndef ExaBricksRenderLogarithm_h
#define ExaBricksRenderLogarithm_h

#include <optional>
#include <string>

class vtkOverlappingAMR;

namespace render
{

// Adds log10 of a cell array to every block and returns its name. Of a vector, one component or the
// magnitude is taken. Where there is no logarithm the value is NaN, which the mapper takes for an
// absent cell.
std::string addLogarithm(
  vtkOverlappingAMR* amr, const std::string& array, std::optional<int> component);

}

#endif
