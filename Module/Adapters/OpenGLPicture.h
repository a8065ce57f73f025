// SPDX-License-Identifier: BSD-3-Clause
// Between the picture of the Vulkan pass and the framebuffer that VTK renders into: opaque depth
// in, premultiplied picture out.
#ifndef ExaBricksAdaptersOpenGLPicture_h
#define ExaBricksAdaptersOpenGLPicture_h

#include <glm/vec4.hpp>
#include <vector>

#include "vtkSmartPointer.h"

class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace exabricks
{
class OpenGLPicture
{
public:
  OpenGLPicture();
  ~OpenGLPicture();

  /// Lower left corner and size, in pixels, of what `ren` renders into at this moment.
  struct Viewport
  {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
  };
  static Viewport findViewport(vtkRenderer* ren);

  /// Window depth in [0, 1] of all that is drawn so far, row 0 at the bottom; false if nothing is.
  static bool readDepth(vtkRenderer* ren, const Viewport& viewport, std::vector<float>& depth);

  /// Blends a premultiplied picture of the viewport's size over what is drawn so far.
  bool draw(vtkRenderer* ren, const Viewport& viewport, std::vector<glm::vec4>& picture);

  /// May be called twice, and with a window that is going away.
  void release(vtkWindow* window);

private:
  vtkSmartPointer<vtkTextureObject> Texture;
};
}

#endif
