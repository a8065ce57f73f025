// SPDX-License-Identifier: BSD-3-Clause
// From a mapper's clipping planes, in world coordinates, and its cropping, in those of the data, to
// what is cut away of its volume; and the plane of a slice.
#ifndef ExaBricksAdaptersCutawayInput_h
#define ExaBricksAdaptersCutawayInput_h

#include "Adapters/BrickedVolume.h"
#include "Core/Cutaway.h"

class vtkVolume;
class vtkVolumeMapper;

namespace exabricks
{
/// Why nothing can be cut as the mapper asks for; empty if it can.
std::string checkCutaway(vtkVolumeMapper* mapper);

/// What it asks for, where that can be done.
Cutaway makeCutaway(vtkVolumeMapper* mapper, vtkVolume* volume, const BrickedVolume& bricked);

/// Why the property's slice function cannot be drawn; empty if it can.
std::string checkSlice(vtkVolume* volume);

/// Its plane, in half cells from the lower corner of the bounds; some plane if it has none.
glm::dvec4 findSlicePlane(vtkVolume* volume, const BrickedVolume& bricked);
}

#endif
