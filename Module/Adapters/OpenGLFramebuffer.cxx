// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/OpenGLFramebuffer.h"

#include "Adapters/OpenGLStateKeeper.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace exabricks
{
namespace
{
void readPixels(int x, int y, const Viewport& viewport, std::vector<float>& depth)
{
  glReadPixels(x, y, viewport.width, viewport.height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
}

// Reads from the framebuffer that is bound for reading, by way of one with one sample a pixel.
// OpenGL copies depth between equal formats alone, and does not tell the format: all are tried.
bool readSamples(const Viewport& viewport, std::vector<float>& depth)
{
  GLuint single = 0;
  GLuint storage = 0;
  glGenFramebuffers(1, &single);
  glGenRenderbuffers(1, &storage);
  GLint boundStorage = 0;
  GLint from = 0;
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &boundStorage);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &from);
  glBindRenderbuffer(GL_RENDERBUFFER, storage);
  const GLenum noColors = GL_NONE;
  const GLfloat farthest = 1.0f;
  glDepthMask(GL_TRUE);
  bool done = false;
  for (const GLenum format : { GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F,
         GL_DEPTH32F_STENCIL8, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT32 })
  {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single);
    glRenderbufferStorage(GL_RENDERBUFFER, format, viewport.width, viewport.height);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, storage);
    glDrawBuffers(1, &noColors);
    // Where there is no depth to copy, OpenGL copies nothing, without an error.
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glBlitFramebuffer(viewport.x, viewport.y, viewport.x + viewport.width,
      viewport.y + viewport.height, 0, 0, viewport.width, viewport.height, GL_DEPTH_BUFFER_BIT,
      GL_NEAREST);
    if (noError())
    {
      glBindFramebuffer(GL_READ_FRAMEBUFFER, single);
      glReadBuffer(GL_NONE);
      readPixels(0, 0, viewport, depth);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
      done = noError();
      break;
    }
  }
  glBindRenderbuffer(GL_RENDERBUFFER, boundStorage);
  glDeleteRenderbuffers(1, &storage);
  glDeleteFramebuffers(1, &single);
  return done;
}
}

Viewport findViewport()
{
  // Not the renderer's size in the window: passes render into framebuffers of their own.
  GLint viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  return { viewport[0], viewport[1], viewport[2], viewport[3] };
}

OpaqueDepth readDepth(
  vtkOpenGLRenderWindow* window, const Viewport& viewport, std::vector<float>& depth)
{
  const OpenGLStateKeeper keeper(window->GetState());
  keeper.ignoreMasks();
  noError(); // forgets the errors of calls before
  depth.assign(static_cast<std::size_t>(viewport.width) * viewport.height, 1.0f);
  GLint samples = 0;
  GLint target = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target);
  bool read = true;
  if (samples > 0)
  {
    read = readSamples(viewport, depth);
  }
  else
  {
    readPixels(viewport.x, viewport.y, viewport, depth);
    // A framebuffer without depth has nothing opaque to hide anything.
    if (!noError())
    {
      std::fill(depth.begin(), depth.end(), 1.0f);
    }
  }
  if (!read)
  {
    return OpaqueDepth::Refused;
  }
  return std::any_of(depth.begin(), depth.end(), [](float z) { return z < 1.0f; })
    ? OpaqueDepth::Read
    : OpaqueDepth::None;
}
}
