// SPDX-License-Identifier: BSD-3-Clause
// What a scene asks of the mapper that it does not do, in words.
#ifndef ExaBricksAdaptersRequests_h
#define ExaBricksAdaptersRequests_h

#include <string>
#include <vector>

class vtkVolume;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace exabricks
{
struct Requests
{
  std::string refused;                   // empty, or why nothing can be drawn
  std::vector<std::string> drawnWithout; // what the volume is drawn without
};

/// What can be told without data.
Requests checkRequests(vtkVolumeMapper* mapper, vtkVolume* volume);

/// Of an array of so many components. `chosen`: somebody chose one of them, or their magnitude.
Requests checkComponents(vtkVolumeProperty* property, int components, bool chosen);
}

#endif
