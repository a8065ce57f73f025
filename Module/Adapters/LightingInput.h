// SPDX-License-Identifier: BSD-3-Clause
// The renderer's lights and the property's material, for the shading of volumes.
#ifndef ExaBricksAdaptersLightingInput_h
#define ExaBricksAdaptersLightingInput_h

#include "Adapters/BrickedVolume.h"
#include "Adapters/PropertyInput.h"
#include "Core/Lighting.h"

#include <optional>

class vtkRenderer;
class vtkVolume;

namespace exabricks
{
/// Whether all lights that shine are heeded.
Requests checkLights(vtkRenderer* ren, vtkVolume* vol);

/// Whether the property asks for shading of anything that is drawn.
bool isShaded(vtkVolumeProperty* property, const BrickedVolume& bricked);

/// Of the light that the property's medium scatters; 0 with versions of VTK that have none.
double findScatteringAnisotropy(vtkVolumeProperty* property);

/// None where the property's Shade is off. Lights are taken where they are in this picture:
/// vtkRenderer has moved headlights and camera lights with the camera.
std::optional<Lighting> makeLighting(
  vtkRenderer* ren, vtkVolume* vol, const BrickedVolume& bricked);

/// By what the extinction is multiplied, for the gradients of VolumeRenderer::setGradientOpacity();
/// empty where the property has no such function, or one that is 1 everywhere. As for VTK's
/// mappers, gradients are the change of the value over a mean width of (here, finest) cells, up to
/// a quarter of the range of all values.
std::vector<float> makeGradientOpacity(vtkVolumeProperty* property, const BrickedVolume& bricked);
}

#endif
