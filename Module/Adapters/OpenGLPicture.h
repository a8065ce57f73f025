// SPDX-License-Identifier: BSD-3-Clause
// The picture of the Vulkan pass, blended into the framebuffer that VTK renders into.
#ifndef ExaBricksAdaptersOpenGLPicture_h
#define ExaBricksAdaptersOpenGLPicture_h

#include "Adapters/DepthPeel.h"

#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkOpenGLQuadHelper;
class vtkTextureObject;

namespace exabricks
{
/// Premultiplied red, green, blue, opacity, [height][width], row 0 at the bottom.
using Pixels = std::vector<glm::vec4>;

struct PixelGrid
{
  int width;
  int height;
};

class OpenGLPicture
{
public:
  OpenGLPicture();
  ~OpenGLPicture();

  /// Blends a picture over what is drawn so far, in all of the viewport: where it has fewer pixels
  /// than that, it goes evenly between their middles. False if OpenGL refuses one so large.
  bool draw(vtkOpenGLRenderWindow* window, const PixelGrid& size, Pixels& picture);
  /// The same of a picture with fewer pixels than the viewport, in front of geometry: those of a
  /// picture's pixels count whose rays end at a depth like that of the viewport's pixel.
  bool draw(vtkOpenGLRenderWindow* window, const Viewport& viewport, const PixelGrid& size,
    Pixels& picture, std::vector<float>& sparseDepth, std::vector<float>& depth);
  /// The first into the targets of a peel: the pieces of rays behind what is peeled, and those
  /// before it, which may be empty.
  bool draw(vtkOpenGLRenderWindow* window, const PixelGrid& size, DepthPeel& peel, Pixels& back,
    Pixels& front);

  /// May be called twice, and with a window that is going away.
  void release(vtkWindow* window);

private:
  using Texture = vtkSmartPointer<vtkTextureObject>;

  void SetWindow(vtkOpenGLRenderWindow* window);
  bool Upload(Texture& texture, const PixelGrid& size, int components, void* pixels);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // the one that the rest was made for
  Texture Back;
  Texture Front;
  Texture SparseDepth;
  Texture Depth;
  std::unique_ptr<vtkOpenGLQuadHelper> Over;
  std::unique_ptr<vtkOpenGLQuadHelper> OverGeometry;
  std::unique_ptr<vtkOpenGLQuadHelper> Peel;
};
}

#endif
