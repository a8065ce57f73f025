// SPDX-License-Identifier: BSD-3-Clause
// What a vtkExaBricksData holds. Never changed once made, shared by copies.
#ifndef ExaBricksAdaptersDataContents_h
#define ExaBricksAdaptersDataContents_h

#include "Core/Volume.h"
#include "vtkExaBricksData.h"

struct vtkExaBricksData::Contents
{
  exabricks::Volume Volume;
  glm::dvec3 Origin{ 0.0 };  // world position of logical (0, 0, 0)
  glm::dvec3 Spacing{ 1.0 }; // world size of a finest cell
  std::vector<int> AMRLevel; // of each level of the hierarchy, which leaves out empty ones
  std::string ArrayName;
  int Components = 1;         // of the array
  double StructureTime = 0.0; // s
  double ScalarsTime = 0.0;   // s

  /// World position of half cells counted from the lower corner of the bounds.
  glm::dvec3 World(const glm::dvec3& halfCells) const
  {
    return this->Origin +
      this->Spacing * (glm::dvec3(this->Volume.structure->tree.bounds.lo) + 0.5 * halfCells);
  }
};

#endif
