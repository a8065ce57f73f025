// SPDX-License-Identifier: BSD-3-Clause
// Colour maps by name.

#ifndef ExaBricksAdaptersColorMaps_h
#define ExaBricksAdaptersColorMaps_h

#include <string>

class vtkColorTransferFunction;

namespace exabricks
{

// All names, separated by commas.
std::string colorMapNames();

bool hasColorMap(const std::string& name);

// Spreads the map over the range; values outside take the end colours.
void fillColorMap(const std::string& name, const double range[2], vtkColorTransferFunction* colors);

}

#endif
