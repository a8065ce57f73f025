// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/OpenGLPicture.h"

#include "Adapters/OpenGLStateKeeper.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <utility>

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

// The four pixels of the picture around one of the viewport count by how near they are, and by how
// like it their depths are: across an edge of geometry they are of another ray's length.
constexpr const char* OverGeometryShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D back;
uniform sampler2D sparseDepth;
uniform sampler2D depth;
void main()
{
  ivec2 most = textureSize(back, 0) - 1;
  vec2 at = texCoord * vec2(most + 1) - 0.5;
  ivec2 first = ivec2(floor(at));
  vec2 f = at - floor(at);
  float z = texture2D(depth, texCoord).r;
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 off = ivec2(i & 1, i >> 1);
    ivec2 p = clamp(first + off, ivec2(0), most);
    vec2 near = mix(1.0 - f, f, vec2(off));
    float w = (near.x * near.y + 1e-4) / (1e-4 + abs(texelFetch(sparseDepth, p, 0).r - z));
    sum += w * texelFetch(back, p, 0);
    weights += w;
  }
  gl_FragData[0] = sum / weights;
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

bool OpenGLPicture::Upload(Texture& texture, const PixelGrid& size, int components, void* pixels)
{
  if (!texture)
  {
    texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(this->Window);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
  }
  // With a pixel for each of the viewport's, nothing is to be rounded.
  const Viewport viewport = findViewport();
  const bool sparse = size.width != viewport.width || size.height != viewport.height;
  texture->SetMagnificationFilter(sparse ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (size.width > largest || size.height > largest)
  {
    return false;
  }
  noError(); // forgets the errors of calls before
  return texture->Create2DFromRaw(static_cast<unsigned int>(size.width),
           static_cast<unsigned int>(size.height), components, VTK_FLOAT, pixels) &&
    noError();
}

bool OpenGLPicture::draw(vtkOpenGLRenderWindow* window, const Viewport& viewport,
  const PixelGrid& size, Pixels& picture, std::vector<float>& sparseDepth,
  std::vector<float>& depth)
{
  const OpenGLStateKeeper keeper(window->GetState());
  this->SetWindow(window);
  if (!this->Upload(this->Back, size, 4, picture.data()) ||
    !this->Upload(this->SparseDepth, size, 1, sparseDepth.data()) ||
    !this->Upload(this->Depth, { viewport.width, viewport.height }, 1, depth.data()))
  {
    return false;
  }
  keeper.blendOver();
  prepare(this->OverGeometry, window, OverGeometryShader);
  const std::pair<const char*, vtkTextureObject*> textures[] = { { "back", this->Back },
    { "sparseDepth", this->SparseDepth }, { "depth", this->Depth } };
  for (const auto& [name, texture] : textures)
  {
    texture->Activate();
    this->OverGeometry->Program->SetUniformi(name, texture->GetTextureUnit());
  }
  this->OverGeometry->Render();
  for (const auto& [name, texture] : textures)
  {
    texture->Deactivate();
  }
  return true;
}

bool OpenGLPicture::draw(vtkOpenGLRenderWindow* window, const PixelGrid& size, Pixels& picture)
{
  const OpenGLStateKeeper keeper(window->GetState());
  this->SetWindow(window);
  if (!this->Upload(this->Back, size, 4, picture.data()))
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

bool OpenGLPicture::draw(vtkOpenGLRenderWindow* window, const PixelGrid& size, DepthPeel& peel,
  Pixels& back, Pixels& front)
{
  const OpenGLStateKeeper keeper(window->GetState());
  this->SetWindow(window);
  if (!this->Upload(this->Back, size, 4, back.data()) ||
    (!front.empty() && !this->Upload(this->Front, size, 4, front.data())))
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
  for (Texture* texture : { &this->Back, &this->Front, &this->SparseDepth, &this->Depth })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
  this->Over.reset();
  this->OverGeometry.reset();
  this->Peel.reset();
  this->Window = nullptr;
}
}
