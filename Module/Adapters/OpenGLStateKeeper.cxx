// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/OpenGLStateKeeper.h"

#include "vtkOpenGLState.h"

namespace exabricks
{
OpenGLStateKeeper::OpenGLStateKeeper(vtkOpenGLState* state)
  : State(state)
{
  for (std::size_t i = 0; i < Switches.size(); ++i)
  {
    this->On[i] = glIsEnabled(Switches[i]);
  }
  for (std::size_t i = 0; i < Storage.size(); ++i)
  {
    glGetIntegerv(Storage[i], &this->Stored[i]);
  }
  glGetBooleanv(GL_DEPTH_WRITEMASK, &this->DepthMask);
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->BlendEquationColor);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->BlendEquationAlpha);
  glGetIntegerv(GL_BLEND_SRC_RGB, &this->BlendSourceColor);
  glGetIntegerv(GL_BLEND_DST_RGB, &this->BlendTargetColor);
  glGetIntegerv(GL_BLEND_SRC_ALPHA, &this->BlendSourceAlpha);
  glGetIntegerv(GL_BLEND_DST_ALPHA, &this->BlendTargetAlpha);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &this->ReadFramebuffer);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->DrawFramebuffer);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &this->ActiveTexture);
  glGetIntegerv(GL_PACK_ALIGNMENT, &this->PackAlignment);
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &this->UnpackAlignment);
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &this->PackBuffer);
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &this->UnpackBuffer);

  for (const GLenum which : Switches)
  {
    glDisable(which);
  }
  for (const GLenum which : Storage)
  {
    glPixelStorei(which, 0);
  }
  glDepthMask(GL_FALSE);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
}

OpenGLStateKeeper::~OpenGLStateKeeper()
{
  for (std::size_t i = 0; i < Switches.size(); ++i)
  {
    this->On[i] ? glEnable(Switches[i]) : glDisable(Switches[i]);
  }
  for (std::size_t i = 0; i < Storage.size(); ++i)
  {
    glPixelStorei(Storage[i], this->Stored[i]);
  }
  glDepthMask(this->DepthMask);
  glBlendEquationSeparate(this->BlendEquationColor, this->BlendEquationAlpha);
  glBlendFuncSeparate(
    this->BlendSourceColor, this->BlendTargetColor, this->BlendSourceAlpha, this->BlendTargetAlpha);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, this->ReadFramebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->DrawFramebuffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->PackBuffer);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, this->UnpackBuffer);
  // VTK's textures change these through its record, which has to know what they are now.
  this->State->vtkglPixelStorei(GL_PACK_ALIGNMENT, this->PackAlignment);
  this->State->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, this->UnpackAlignment);
  this->State->vtkglActiveTexture(this->ActiveTexture);
}
}
