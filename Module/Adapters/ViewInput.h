// SPDX-License-Identifier: BSD-3-Clause
// From VTK's camera and volume to the matrices of a picture.
#ifndef ExaBricksAdaptersViewInput_h
#define ExaBricksAdaptersViewInput_h

#include "Adapters/BrickedVolume.h"
#include "Adapters/FirstSeen.h"
#include "Vulkan/VolumeRenderer.h"

class vtkRenderer;
class vtkVolume;

namespace exabricks
{
/// The camera that opaque geometry is drawn with, for a picture of `width` x `height` pixels:
/// perspective, parallel, sheared, off-axis and explicit projections, the eye of a stereo picture,
/// the part of a tiled one, and the camera's model transform. The data's own coordinates are those
/// before the volume's matrix, in which VTK measures the opacity unit distance.
View makeView(
  vtkRenderer* ren, vtkVolume* vol, const BrickedVolume& bricked, int width, int height);

/// A pixel of the renderer's window, counted from its lower left corner, with the depth of the
/// window's last picture, if there was one. None where the renderer has no pixels.
std::optional<PlaceInPicture> findPlace(vtkRenderer* ren, double displayX, double displayY);
}

#endif
