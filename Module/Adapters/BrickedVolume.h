// SPDX-License-Identifier: BSD-3-Clause
// An AMR made into bricks, regions and values, with what leads back from them to VTK's own terms:
// world coordinates, levels and the array. vtkExaBricksData holds one.
#ifndef ExaBricksAdaptersBrickedVolume_h
#define ExaBricksAdaptersBrickedVolume_h

#include "Core/Volume.h"

#include <string>

namespace exabricks
{
/// Never changes once it is made, so that copies of the data share it.
struct BrickedVolume
{
  Volume volume;
  glm::dvec3 origin{ 0.0 };  // world position of logical (0, 0, 0)
  glm::dvec3 spacing{ 1.0 }; // world size of a finest cell
  std::vector<int> amrLevel; // of each level of the hierarchy, which leaves out empty ones
  std::string arrayName;
  int components = 1;    // of the array, of which the volume may have one, or all
  bool joined = false;   // the second component is that of another array
  bool onPoints = false; // cells are around the points of the AMR's only block
  // Of a volume of one component, which of the property's components shows it.
  int propertyComponent = 0;
  double brightest = 1.0;     // what the array's type has for the brightest red, green or blue
  double structureTime = 0.0; // s
  double valuesTime = 0.0;    // s

  /// World position of half cells counted from the lower corner of the bounds.
  glm::dvec3 world(const glm::dvec3& halfCells) const
  {
    return this->origin +
      this->spacing * (glm::dvec3(this->volume.structure->tree.bounds.lo) + 0.5 * halfCells);
  }
};
}

#endif
