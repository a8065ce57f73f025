// SPDX-License-Identifier: BSD-3-Clause
// Leaves the state of OpenGL that drawing and reading change as it was found, and sets it to what
// both begin with: no depth is tested or written, nothing is culled or blended, and pixels are rows
// of memory. It asks OpenGL itself, and not VTK's record of the state, which does not know of calls
// around VTK; what it sets, it tells both.
#ifndef ExaBricksAdaptersOpenGLStateKeeper_h
#define ExaBricksAdaptersOpenGLStateKeeper_h

#include "vtkOpenGLRenderUtilities.h" // brings the OpenGL loader of this VTK

#include <array>

class vtkOpenGLState;

namespace exabricks
{
class OpenGLStateKeeper
{
public:
  explicit OpenGLStateKeeper(vtkOpenGLState* state);
  ~OpenGLStateKeeper();
  OpenGLStateKeeper(const OpenGLStateKeeper&) = delete;
  void operator=(const OpenGLStateKeeper&) = delete;

  /// Sets blending to "over", of premultiplied colours.
  void blendOver() const;
  /// Switches scissor rectangle and stencil off, for framebuffers of our own: they concern VTK's.
  void ignoreMasks() const;

private:
  void Switch(GLenum which, bool on) const;
  void SetDepthMask(GLboolean mask) const;
  void SetBlending(GLenum equationColor, GLenum equationAlpha, GLenum sourceColor,
    GLenum targetColor, GLenum sourceAlpha, GLenum targetAlpha) const;

  static constexpr std::array<GLenum, 5> Switches{ GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE,
    GL_SCISSOR_TEST, GL_STENCIL_TEST };
  static constexpr std::array<GLenum, 6> Storage{ GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
    GL_PACK_SKIP_PIXELS, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS };

  vtkOpenGLState* State;
  std::array<GLboolean, Switches.size()> On;
  std::array<GLint, Storage.size()> Stored;
  GLboolean DepthMask;
  GLint BlendEquationColor;
  GLint BlendEquationAlpha;
  GLint BlendSourceColor;
  GLint BlendTargetColor;
  GLint BlendSourceAlpha;
  GLint BlendTargetAlpha;
  GLint ReadFramebuffer;
  GLint DrawFramebuffer;
  GLint ActiveTexture;
  GLint PackAlignment;
  GLint UnpackAlignment;
  GLint PackBuffer;
  GLint UnpackBuffer;
};

/// Whether OpenGL has had no error since this was called last.
bool noError();
}

#endif
