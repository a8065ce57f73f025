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

  state->PushFramebufferBindings();
  for (const GLenum which : { GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE })
  {
    this->Switch(which, false);
  }
  for (const GLenum which : Storage)
  {
    glPixelStorei(which, 0);
  }
  this->SetDepthMask(GL_FALSE);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
}

OpenGLStateKeeper::~OpenGLStateKeeper()
{
  this->State->PopFramebufferBindings();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, this->ReadFramebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->DrawFramebuffer);
  for (std::size_t i = 0; i < Switches.size(); ++i)
  {
    this->Switch(Switches[i], this->On[i]);
  }
  for (std::size_t i = 0; i < Storage.size(); ++i)
  {
    glPixelStorei(Storage[i], this->Stored[i]);
  }
  this->SetDepthMask(this->DepthMask);
  this->SetBlending(this->BlendEquationColor, this->BlendEquationAlpha, this->BlendSourceColor,
    this->BlendTargetColor, this->BlendSourceAlpha, this->BlendTargetAlpha);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->PackBuffer);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, this->UnpackBuffer);
  // VTK's textures change these, through its record.
  this->State->vtkglPixelStorei(GL_PACK_ALIGNMENT, this->PackAlignment);
  this->State->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, this->UnpackAlignment);
  this->State->vtkglActiveTexture(this->ActiveTexture);
}

void OpenGLStateKeeper::blendOver() const
{
  this->Switch(GL_BLEND, true);
  this->SetBlending(
    GL_FUNC_ADD, GL_FUNC_ADD, GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void OpenGLStateKeeper::ignoreMasks() const
{
  this->Switch(GL_SCISSOR_TEST, false);
  this->Switch(GL_STENCIL_TEST, false);
}

// VTK makes no call where its record says that nothing changes: the calls to OpenGL are for where
// the record is wrong.
void OpenGLStateKeeper::Switch(GLenum which, bool on) const
{
  this->State->SetEnumState(which, on);
  on ? glEnable(which) : glDisable(which);
}

void OpenGLStateKeeper::SetDepthMask(GLboolean mask) const
{
  this->State->vtkglDepthMask(mask);
  glDepthMask(mask);
}

void OpenGLStateKeeper::SetBlending(GLenum equationColor, GLenum equationAlpha, GLenum sourceColor,
  GLenum targetColor, GLenum sourceAlpha, GLenum targetAlpha) const
{
  this->State->vtkglBlendEquationSeparate(equationColor, equationAlpha);
  this->State->vtkglBlendFuncSeparate(sourceColor, targetColor, sourceAlpha, targetAlpha);
  glBlendEquationSeparate(equationColor, equationAlpha);
  glBlendFuncSeparate(sourceColor, targetColor, sourceAlpha, targetAlpha);
}

bool noError()
{
  // A lost context may have an error for ever.
  bool none = true;
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    none = false;
  }
  return none;
}
}
