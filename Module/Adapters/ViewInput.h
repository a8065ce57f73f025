// SPDX-License-Identifier: BSD-3-Clause
// From VTK's camera and volume to the matrices of a picture.
#ifndef ExaBricksAdaptersViewInput_h
#define ExaBricksAdaptersViewInput_h

#include "Adapters/DataContents.h"
#include "Vulkan/VolumeRenderer.h"

class vtkRenderer;
class vtkVolume;

namespace exabricks
{
/// Perspective, parallel and explicit projections, with the volume's matrix.
View makeView(vtkRenderer* ren, vtkVolume* vol, const vtkExaBricksData::Contents& contents);
}

#endif
