// SPDX-License-Identifier: BSD-3-Clause
// The framebuffer that VTK renders into at this moment: where in it, and the depth of what is drawn
// so far.
#ifndef ExaBricksAdaptersOpenGLFramebuffer_h
#define ExaBricksAdaptersOpenGLFramebuffer_h

#include <vector>

class vtkOpenGLRenderWindow;

namespace exabricks
{
/// Lower left corner and size, in pixels.
struct Viewport
{
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};
/// The one that OpenGL draws into at this moment.
Viewport findViewport();

enum class OpaqueDepth
{
  None,   // nothing opaque is drawn so far
  Read,   // it is in the vector
  Refused // OpenGL does not give it
};

/// Window depth in [0, 1] in the framebuffer that is bound for drawing, [height][width], row 0 at
/// the bottom. Of several samples of a pixel OpenGL chooses one.
OpaqueDepth readDepth(
  vtkOpenGLRenderWindow* window, const Viewport& viewport, std::vector<float>& depth);
}

#endif
