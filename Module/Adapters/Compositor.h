// SPDX-License-Identifier: BSD-3-Clause
// From a renderer's picture to VTK's window: rays end at the depth of opaque geometry, or are drawn
// in the pieces that VTK's depth peeling asks for, and the picture is blended into what is bound.
#ifndef ExaBricksAdaptersCompositor_h
#define ExaBricksAdaptersCompositor_h

#include "Adapters/ColorWindow.h"
#include "Adapters/OpenGLPicture.h"
#include "Vulkan/VolumeRenderer.h"

#include <functional>
#include <optional>

class vtkHardwareSelector;
class vtkRenderer;

namespace exabricks
{
/// Whether the selector's present pass asks which prop or process is where: what it asks for in
/// others is not told of volumes.
bool marksProps(vtkHardwareSelector* selector);

class Compositor
{
public:
  /// Draws the volume into the window of `ren`. `makeView` is called with the size of the picture
  /// in pixels; `colors` is applied to it. Returns an empty string, or what went wrong. Returns
  /// nothing where nothing is drawn for a good reason: `progress` gave the picture up, or it is a
  /// peel after the first one that has no use for the volume.
  std::optional<std::string> draw(vtkAbstractVolumeMapper* mapper, vtkRenderer* ren, vtkVolume* vol,
    const std::function<View(int width, int height)>& makeView, const ColorWindow& colors,
    VolumeRenderer& renderer, const VolumeRenderer::Progress& progress);

  /// Draws, in a selector's pass for which marksProps() is true, the prop's colour where more than
  /// 3/255 of opacity shows in the selected area. Returns as draw() does.
  std::optional<std::string> drawSelection(vtkRenderer* ren,
    const std::function<View(int width, int height)>& makeView, VolumeRenderer& renderer);

  /// May be called twice, and with a window that is going away.
  void release(vtkWindow* window);

private:
  std::optional<std::string> DrawPeel(vtkOpenGLRenderWindow* window, const Viewport& viewport,
    View view, const ColorWindow& colors, VolumeRenderer& renderer,
    const VolumeRenderer::Progress& progress);

  OpenGLPicture Picture;
  DepthPeel Peel;
  Pixels Back;  // the picture; of a peel, the part behind what is peeled
  Pixels Front; // of a peel, the part before it
  std::vector<float> Depth;
};
}

#endif
