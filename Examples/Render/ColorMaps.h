// SPDX-License-Identifier: BSD-3-Clause
// Colour maps by name.

#ifndef ColorMaps_h
#define ColorMaps_h

#include <string>

class vtkColorTransferFunction;

namespace render
{

// All names, separated by commas.
std::string ColorMapNames();

bool HasColorMap(const std::string& name);

// Spreads the map over the range; values outside take the end colours.
void FillColorMap(const std::string& name, const double range[2], vtkColorTransferFunction* colors);

}

#endif
