// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/OpenGLPicture.h"

#include "Adapters/OpenGLStateKeeper.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace exabricks
{
namespace
{
constexpr const char* OverShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D back;
void main()
{
  gl_FragData[0] = texture2D(back, texCoord);
}
)";

// A peel has two targets: colours behind what is peeled, and those before it. The second holds what
// the layers before have gathered, `last` (lastFrontColorTex, by VTK's name), and is to hold
// last + (1 - last.a) f with this picture f under them. It is blended "over", src + (1 - src.a)
// dst, with src = (f.a last.rgb + (1 - last.a) f.rgb, f.a): on dst = last that gives the sum, and
// on what another volume, farther away, has made of it already, the sum with both in their order.
constexpr const char* PeelShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D back;
uniform sampler2D front;
uniform int hasFront;
uniform int continuesFront;
uniform sampler2D lastFrontColorTex;
void main()
{
  gl_FragData[0] = texture2D(back, texCoord);
  vec4 f = vec4(0.0);
  if (hasFront != 0)
  {
    f = texture2D(front, texCoord);
    if (continuesFront != 0)
    {
      vec4 last = texture2D(lastFrontColorTex, texCoord);
      f.rgb = f.a * last.rgb + (1.0 - last.a) * f.rgb;
    }
  }
  gl_FragData[1] = f;
}
)";

void prepare(
  std::unique_ptr<vtkOpenGLQuadHelper>& helper, vtkOpenGLRenderWindow* window, const char* shader)
{
  if (!helper)
  {
    helper = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, shader, nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(helper->Program);
  }
}
}

OpenGLPicture::OpenGLPicture() = default;
OpenGLPicture::~OpenGLPicture() = default;

void OpenGLPicture::SetWindow(vtkOpenGLRenderWindow* window)
{
  // Without the mapper's knowledge a window may give back all that is made for it.
  if (window != this->Window || (this->Back && this->Back->GetHandle() == 0))
  {
    this->release(window);
    this->Window = window;
  }
}

bool OpenGLPicture::Upload(Texture& texture, const Viewport& viewport, Pixels& picture)
{
  if (!texture)
  {
    texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(this->Window);
  }
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (viewport.width > largest || viewport.height > largest)
  {
    return false;
  }
  noError(); // forgets the errors of calls before
  return texture->Create2DFromRaw(static_cast<unsigned int>(viewport.width),
           static_cast<unsigned int>(viewport.height), 4, VTK_FLOAT, picture.data()) &&
    noError();
}

bool OpenGLPicture::draw(vtkOpenGLRenderWindow* window, const Viewport& viewport, Pixels& picture)
{
  const OpenGLStateKeeper keeper(window->GetState());
  this->SetWindow(window);
  if (!this->Upload(this->Back, viewport, picture))
  {
    return false;
  }
  keeper.blendOver();
  prepare(this->Over, window, OverShader);
  this->Back->Activate();
  this->Over->Program->SetUniformi("back", this->Back->GetTextureUnit());
  this->Over->Render();
  this->Back->Deactivate();
  return true;
}

bool OpenGLPicture::draw(vtkOpenGLRenderWindow* window, const Viewport& viewport, DepthPeel& peel,
  Pixels& back, Pixels& front)
{
  const OpenGLStateKeeper keeper(window->GetState());
  this->SetWindow(window);
  if (!this->Upload(this->Back, viewport, back) ||
    (!front.empty() && !this->Upload(this->Front, viewport, front)))
  {
    return false;
  }
  keeper.blendOver();
  prepare(this->Peel, window, PeelShader);
  vtkShaderProgram* program = this->Peel->Program;
  peel.setParameters(program);
  program->SetUniformi("hasFront", !front.empty());
  program->SetUniformi("continuesFront", peel.continuesFront());
  this->Back->Activate();
  program->SetUniformi("back", this->Back->GetTextureUnit());
  if (!front.empty())
  {
    this->Front->Activate();
    program->SetUniformi("front", this->Front->GetTextureUnit());
  }
  this->Peel->Render();
  this->Back->Deactivate();
  if (!front.empty())
  {
    this->Front->Deactivate();
  }
  return true;
}

void OpenGLPicture::release(vtkWindow* window)
{
  for (Texture* texture : { &this->Back, &this->Front })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
  this->Over.reset();
  this->Peel.reset();
  this->Window = nullptr;
}
}
