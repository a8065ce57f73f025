// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/OpenGLPicture.h"

#include "vtkOpenGLRenderUtilities.h" // brings the OpenGL loader of this VTK
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace exabricks
{
OpenGLPicture::OpenGLPicture() = default;
OpenGLPicture::~OpenGLPicture() = default;

OpenGLPicture::Viewport OpenGLPicture::findViewport(vtkRenderer* ren)
{
  // Not the renderer's size in the window: passes render into framebuffers of their own.
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  int viewport[4] = { 0, 0, 0, 0 };
  if (window)
  {
    window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  }
  return { viewport[0], viewport[1], viewport[2], viewport[3] };
}

bool OpenGLPicture::readDepth(vtkRenderer* ren, const Viewport& viewport, std::vector<float>& depth)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  depth.assign(static_cast<std::size_t>(viewport.width) * viewport.height, 1.0f);
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples > 0)
  {
    // Samples have to be resolved first, which VTK knows how to do.
    window->GetZbufferData(viewport.x, viewport.y, viewport.x + viewport.width - 1,
      viewport.y + viewport.height - 1, depth.data());
  }
  else
  {
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    GLint alignment = 4;
    glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
    state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(viewport.x, viewport.y, viewport.width, viewport.height, GL_DEPTH_COMPONENT,
      GL_FLOAT, depth.data());
    state->vtkglPixelStorei(GL_PACK_ALIGNMENT, alignment);
  }
  return std::any_of(depth.begin(), depth.end(), [](float z) { return z < 1.0f; });
}

bool OpenGLPicture::draw(
  vtkRenderer* ren, const Viewport& viewport, std::vector<glm::vec4>& picture)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  if (!this->Texture || this->Texture->GetContext() != window)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
  }
  if (!this->Texture->Create2DFromRaw(static_cast<unsigned int>(viewport.width),
        static_cast<unsigned int>(viewport.height), 4, VTK_FLOAT, picture.data()))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->Texture->Activate();
  vtkOpenGLState::ScopedglViewport savedViewport(state);
  // It sets a viewport from (0, 0) to the size it is given, and places the picture in it.
  this->Texture->CopyToFrameBuffer(0, 0, viewport.width - 1, viewport.height - 1, viewport.x,
    viewport.y, viewport.x + viewport.width, viewport.y + viewport.height, nullptr, nullptr);
  this->Texture->Deactivate();
  return true;
}

void OpenGLPicture::release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}
}
