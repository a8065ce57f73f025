// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExaBricksPluginUnusedProperties_h
#define ExaBricksPluginUnusedProperties_h

#include <string>

class vtkSMProxy;

// ParaView's representation of AMR shows the properties of surfaces and of its own volume
// rendering for every type of representation, and only few of them mean anything to ExaBricks.
namespace exabricks
{
// Hides, while `representation` is of the type ExaBricks, the properties that `drawing`, its
// sub-proxy that draws that type, does not share with the others. To be called before a panel is
// made.
void hideUnusedProperties(vtkSMProxy* representation, vtkSMProxy* drawing);

// Names those of the unused properties that somebody has set, who will expect that they matter, and
// tells what helps in place of each. Empty if there are none.
std::string describeUnusedSettings(vtkSMProxy* representation);
}

#endif
