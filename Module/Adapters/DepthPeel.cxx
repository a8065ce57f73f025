// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/DepthPeel.h"

#include "Adapters/OpenGLStateKeeper.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>

namespace exabricks
{
namespace
{
// VTK's code for a peel uses names of VTK's shader for volumes, which are defined here. castRay
// returns an opacity of 0, so that the code asks for the pieces behind too.
constexpr const char* PiecesShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform vec2 in_inverseWindowSize;
const float g_opacityThreshold = 1.0;
//VTK::DepthPeeling::Dec
void initializeRayCast()
{
}
vec4 castRay(const float zStart, const float zEnd)
{
  return vec4(zStart, zEnd, min(texCoord, vec2(0.0))); // VTK expects some use of texCoord
}
void main()
{
  gl_FragData[0] = vec4(0.0);
  gl_FragData[1] = vec4(0.0);
  //VTK::CallWorker::Impl
}
)";

void allocate(vtkSmartPointer<vtkTextureObject>& texture, vtkOpenGLRenderWindow* window,
  const Viewport& viewport)
{
  const auto width = static_cast<unsigned int>(viewport.width);
  const auto height = static_cast<unsigned int>(viewport.height);
  if (!texture || texture->GetWidth() != width || texture->GetHeight() != height)
  {
    texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetFormat(GL_RG);
    texture->SetInternalFormat(GL_RG32F);
    texture->Allocate2D(width, height, 2, VTK_FLOAT);
  }
}

using Depths = std::vector<std::array<float, 2>>; // where the piece of each ray begins and ends

void setPieces(const Depths& depths, RayPieces& pieces)
{
  pieces.begin.resize(depths.size());
  pieces.end.resize(depths.size());
  pieces.any = false;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    pieces.begin[i] = std::clamp(depths[i][0], 0.0f, 1.0f);
    pieces.end[i] = std::clamp(depths[i][1], 0.0f, 1.0f);
    pieces.any = pieces.any || pieces.begin[i] < pieces.end[i];
  }
}
}

DepthPeel::DepthPeel() = default;
DepthPeel::~DepthPeel() = default;

bool DepthPeel::begin(vtkAbstractVolumeMapper* mapper, vtkVolume* volume)
{
  this->Pass = nullptr;
  this->Mapper = mapper;
  this->Volume = volume;
  vtkInformation* keys = volume->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; keys && keys->Has(passes) && i < keys->Length(passes); ++i)
  {
    if (auto* pass = vtkDualDepthPeelingPass::SafeDownCast(keys->Get(passes, i)))
    {
      this->Pass = pass;
    }
  }
  return this->Pass != nullptr;
}

vtkOpenGLQuadHelper* DepthPeel::MakeShader(vtkOpenGLRenderWindow* window)
{
  std::string vertex;
  std::string geometry;
  std::string fragment = PiecesShader;
  this->Pass->PreReplaceShaderValues(vertex, geometry, fragment, this->Mapper, this->Volume);
  std::unique_ptr<vtkOpenGLQuadHelper>& shader = this->Shaders[fragment];
  if (!shader)
  {
    shader = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment.c_str(), nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(shader->Program);
  }
  return shader.get();
}

bool DepthPeel::readPieces(
  vtkOpenGLRenderWindow* window, const Viewport& viewport, RayPieces& back, RayPieces& front)
{
  vtkOpenGLState* state = window->GetState();
  const OpenGLStateKeeper keeper(state);
  keeper.ignoreMasks();
  // Without the mapper's knowledge a window may give back all that is made for it.
  if (window != this->Window || (this->Nothing && this->Nothing->GetHandle() == 0))
  {
    this->release(window);
    this->Window = window;
  }
  vtkOpenGLQuadHelper* shader = this->MakeShader(window);
  vtkShaderProgram* program = shader->Program;
  if (!program)
  {
    return false;
  }
  allocate(this->Targets[0], window, viewport);
  allocate(this->Targets[1], window, viewport);
  if (!this->Nothing)
  {
    std::array<unsigned char, 4> black{};
    this->Nothing = vtkSmartPointer<vtkTextureObject>::New();
    this->Nothing->SetContext(window);
    this->Nothing->Create2DFromRaw(1, 1, 4, VTK_UNSIGNED_CHAR, black.data());
  }

  const std::size_t pixels = static_cast<std::size_t>(viewport.width) * viewport.height;
  std::array<Depths, 2> depths{ Depths(pixels), Depths(pixels) };
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const std::array<GLenum, 2> buffers{ GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
  for (int i = 0; i < 2; ++i)
  {
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, buffers[i], GL_TEXTURE_2D, this->Targets[i]->GetHandle(), 0);
  }
  glDrawBuffers(2, buffers.data()); // VTK would take those of another framebuffer for these
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (complete)
  {
    const std::array<GLfloat, 4> nothing{}; // for the pixels to which the code writes nothing
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_COLOR, 1, nothing.data());
    this->setParameters(program);
    this->Continues = program->IsUniformUsed("lastFrontColorTex");
    this->First = !this->Continues && program->IsUniformUsed("outerDepthTex");
    if (this->Continues)
    {
      // The code puts what it is given under the last peel's colours: here there are none.
      this->Nothing->Activate();
      program->SetUniformi("lastFrontColorTex", this->Nothing->GetTextureUnit());
    }
    const float inverse[2] = { 1.0f / static_cast<float>(viewport.width),
      1.0f / static_cast<float>(viewport.height) };
    program->SetUniform2f("in_inverseWindowSize", inverse);
    shader->Render();
    for (int i = 0; i < 2; ++i)
    {
      glReadBuffer(buffers[i]);
      glReadPixels(0, 0, viewport.width, viewport.height, GL_RG, GL_FLOAT, depths[i].data());
    }
    this->Nothing->Deactivate();
  }
  glDeleteFramebuffers(1, &framebuffer);
  setPieces(depths[0], back);
  setPieces(depths[1], front);
  return complete;
}

void DepthPeel::setParameters(vtkShaderProgram* program) const
{
  this->Pass->SetShaderParameters(program, this->Mapper, this->Volume, nullptr);
}

void DepthPeel::release(vtkWindow* window)
{
  for (vtkSmartPointer<vtkTextureObject>* texture :
    { &this->Targets[0], &this->Targets[1], &this->Nothing })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
  this->Shaders.clear();
  this->Window = nullptr;
}
}
