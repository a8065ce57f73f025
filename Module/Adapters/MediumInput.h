// SPDX-License-Identifier: BSD-3-Clause
// What the volume property says of several components: for the renderer, and in words what of it
// cannot be drawn.
#ifndef ExaBricksAdaptersMediumInput_h
#define ExaBricksAdaptersMediumInput_h

#include "Adapters/BrickedVolume.h"
#include "Adapters/PropertyInput.h"
#include "Core/Medium.h"

class vtkVolumeMapper;
class vtkVolumeProperty;

namespace exabricks
{
/// Of a volume with several components.
Requests checkMedium(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const BrickedVolume& bricked);

/// Of a property that checkMedium() has let pass.
Medium makeMedium(vtkVolumeProperty* property, const BrickedVolume& bricked);
}

#endif
