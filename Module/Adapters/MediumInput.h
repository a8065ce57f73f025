// SPDX-License-Identifier: BSD-3-Clause
// What the volume property says of several components: for the renderer, and in words what of it
// cannot be drawn.
#ifndef ExaBricksAdaptersMediumInput_h
#define ExaBricksAdaptersMediumInput_h

#include "Adapters/BrickedVolume.h"
#include "Adapters/PropertyInput.h"
#include "Core/Medium.h"

#include <optional>

class vtkVolumeMapper;
class vtkVolumeProperty;

namespace exabricks
{
/// Whether the property's 2-D transfer function is drawn: of one component, or of two arrays.
bool isPlanar(vtkVolumeProperty* property, const BrickedVolume& bricked);

/// Of a volume with several components, or a 2-D function.
Requests checkMedium(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const BrickedVolume& bricked);

/// Of several independent components, the one whose surfaces are drawn, as VTK's GPU mapper does:
/// that of the greatest weight. None: the blend mode is another one, or all components count.
std::optional<int> findSurfaceComponent(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const BrickedVolume& bricked);

/// Of a property that checkMedium() has let pass. `planar`: by its 2-D function.
Medium makeMedium(
  vtkVolumeProperty* property, const BrickedVolume& bricked, bool planar, ColorsOf colors);
}

#endif
