// SPDX-License-Identifier: BSD-3-Clause
// From a renderer's picture to VTK's window: rays end at the depth of opaque geometry, or are drawn
// in the pieces that VTK's depth peeling asks for, and the picture is blended into what is bound.
#ifndef ExaBricksAdaptersCompositor_h
#define ExaBricksAdaptersCompositor_h

#include "Adapters/ColorWindow.h"
#include "Adapters/OpenGLPicture.h"
#include "Adapters/SelectionPasses.h"
#include "Vulkan/VolumeRenderer.h"

#include <functional>
#include <optional>

class vtkRenderer;

namespace exabricks
{
class Compositor
{
public:
  /// As VolumeRenderer::render().
  using Render = std::function<std::string(const View&, Pixels&)>;

  /// Draws the volume into the window of `ren`, by `render`. `makeView` is called with the size of
  /// the picture in pixels; where its view has fewer, the picture is filled in between them.
  /// `colors` is applied to it. Returns an empty string, or what went wrong. Returns nothing where
  /// nothing is drawn for a good reason: the picture was given up, or it is a peel after the first
  /// one that has no use for the volume.
  std::optional<std::string> draw(vtkAbstractVolumeMapper* mapper, vtkRenderer* ren, vtkVolume* vol,
    const std::function<View(int width, int height)>& makeView, const ColorWindow& colors,
    const Render& render);

  /// Whether the volume is drawn in passes, one for each layer of translucent geometry, and whether
  /// this pass is the first one of a picture. Known when draw() calls `makeView`, and after it.
  bool isPeeling() const { return this->Peeling; }
  bool isFirstPass() const { return !this->Peeling || this->Peel.isFirst(); }

  /// Draws, in a selector's passes, the numbers that it asks for (SelectionPasses). Returns as
  /// draw() does.
  std::optional<std::string> drawSelection(vtkRenderer* ren,
    const std::function<View(int width, int height)>& makeView, VolumeRenderer& renderer,
    vtkOverlappingAMR* amr, const BrickedVolume& bricked);

  /// May be called twice, and with a window that is going away.
  void release(vtkWindow* window);

private:
  std::optional<std::string> DrawPeel(vtkOpenGLRenderWindow* window, const Viewport& viewport,
    const std::function<View(int width, int height)>& makeView, const ColorWindow& colors,
    const Render& render);

  OpenGLPicture Picture;
  DepthPeel Peel;
  bool Peeling = false;
  SelectionPasses Selection;
  Pixels Back;  // the picture; of a peel, the part behind what is peeled
  Pixels Front; // of a peel, the part before it
  std::vector<float> Depth;
  std::vector<float> SparseDepth; // at the rays of a picture that has fewer of them than pixels
};
}

#endif
