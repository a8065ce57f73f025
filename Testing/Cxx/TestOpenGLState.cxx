// SPDX-License-Identifier: BSD-3-Clause
// The mapper leaves OpenGL as it was found, draws the same whatever state it finds, and into the
// framebuffer that is bound, with one sample a pixel or several: its own, or somebody else's.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderUtilities.h" // brings the OpenGL loader of this VTK
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <vector>

namespace
{
constexpr int Size = 60;

const std::vector<GLenum> Switches{ GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST,
  GL_STENCIL_TEST, GL_MULTISAMPLE };
const std::vector<GLenum> Numbers{ GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA, GL_BLEND_SRC_RGB,
  GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA, GL_DRAW_FRAMEBUFFER_BINDING,
  GL_READ_FRAMEBUFFER_BINDING, GL_RENDERBUFFER_BINDING, GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT,
  GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, GL_PIXEL_PACK_BUFFER_BINDING,
  GL_PIXEL_UNPACK_BUFFER_BINDING, GL_ACTIVE_TEXTURE, GL_DEPTH_FUNC, GL_CULL_FACE_MODE };

std::vector<GLint> recordState()
{
  std::vector<GLint> state;
  for (const GLenum which : Switches)
  {
    state.push_back(glIsEnabled(which));
  }
  for (const GLenum which : Numbers)
  {
    GLint value = 0;
    glGetIntegerv(which, &value);
    state.push_back(value);
  }
  GLboolean mask = GL_FALSE;
  glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
  state.push_back(mask);
  for (const GLenum which : { GL_VIEWPORT, GL_SCISSOR_BOX })
  {
    GLint box[4];
    glGetIntegerv(which, box);
    state.insert(state.end(), box, box + 4);
  }
  return state;
}

const GLenum NoDepth = GL_NONE;

// A framebuffer of one's own, cleared to black and a depth, if it has one.
struct Target
{
  GLuint framebuffer = 0;
  GLuint buffers[2] = { 0, 0 };

  Target(int samples, GLenum depthFormat, double depth)
  {
    glGenFramebuffers(1, &this->framebuffer);
    glGenRenderbuffers(2, this->buffers);
    glBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
    const GLenum formats[2] = { GL_RGBA8, depthFormat };
    const GLenum attachments[2] = { GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT };
    for (int i = 0; i < (depthFormat == NoDepth ? 1 : 2); ++i)
    {
      glBindRenderbuffer(GL_RENDERBUFFER, this->buffers[i]);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], Size, Size);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, this->buffers[i]);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepth(depth);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glClearDepth(1.0);
  }

  ~Target()
  {
    glDeleteFramebuffers(1, &this->framebuffer);
    glDeleteRenderbuffers(2, this->buffers);
  }

  // Green of the middle or of another pixel, in [0, 1].
  double ReadGreen(int x = Size / 2, int y = Size / 2)
  {
    const Target single(0, GL_DEPTH_COMPONENT24, 1.0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, this->framebuffer);
    glBlitFramebuffer(0, 0, Size, Size, 0, 0, Size, Size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, single.framebuffer);
    unsigned char pixel[4];
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    return pixel[1] / 255.0;
  }
};
}

int TestOpenGLState(int, char*[])
{
  test::Checks checks;
  test::Stage stage(test::makeAMR(test::cornerRefined(), test::constant(1.0)), Size);
  test::setConstantColor(stage.Property(), 0.5, { 0.0, 1.0, 0.0 });
  stage.Property()->SetScalarOpacityUnitDistance(8.0);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  // From 20 to 0 along z: half of the volume lies before a window depth of 0.8.
  stage.renderer->GetActiveCamera()->SetPosition(4.0, 4.0, 21.0);
  stage.renderer->GetActiveCamera()->SetClippingRange(1.0, 21.0);
  constexpr double halfway = 0.8;
  const double whole = test::opacityOf(0.5, 8.0, 8.0);
  const double half = test::opacityOf(0.5, 4.0, 8.0);
  checks.Near(test::Picture(stage.window).Center()[1], whole, test::OneStep, "in the window");

  auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.window);
  window->MakeCurrent();
  const auto render = [&](const std::string& what)
  {
    const std::vector<GLint> before = recordState();
    stage.mapper->Render(stage.renderer, stage.volume);
    const std::vector<GLint> after = recordState();
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      checks.Equal(after[i], before[i], "state " + std::to_string(i) + ", " + what);
    }
    checks.Equal(glGetError(), GL_NO_ERROR, "OpenGL's error, " + what);
    checks.Expect(stage.mapper->GetDrawn(), "drawn " + what);
  };

  // Framebuffers of others, with depth in all formats, and samples.
  for (const int samples : { 0, 4 })
  {
    for (const GLenum format : std::vector<GLenum>{ GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24,
           GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT32F, GL_DEPTH32F_STENCIL8, NoDepth })
    {
      const std::string what =
        std::to_string(samples) + " samples, depth format " + std::to_string(format);
      for (const bool cut : { false, true })
      {
        Target target(samples, format, cut ? halfway : 1.0);
        glViewport(0, 0, Size, Size);
        render(what);
        checks.Near(target.ReadGreen(), cut && format != NoDepth ? half : whole,
          1.5 * test::OneStep, "green, " + what);
      }
    }
  }

  // Strange states; the depth to read is that of the framebuffer that is drawn into.
  {
    Target other(0, GL_DEPTH_COMPONENT24, 0.0);
    GLuint packed = 0;
    glGenBuffers(1, &packed);
    Target target(0, GL_DEPTH_COMPONENT24, halfway);
    glViewport(0, 0, Size, Size);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, other.framebuffer);
    glEnable(GL_BLEND);
    glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MIN);
    glBlendFuncSeparate(GL_ZERO, GL_ONE, GL_DST_COLOR, GL_SRC_ALPHA);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT_AND_BACK);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 20, 25, 30);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    glPixelStorei(GL_PACK_ROW_LENGTH, 77);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 99);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, packed);
    glActiveTexture(GL_TEXTURE7);
    render("in a strange state");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glDeleteBuffers(1, &packed);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glDisable(GL_STENCIL_TEST);
    glCullFace(GL_BACK);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_SCISSOR_TEST);
    checks.Near(target.ReadGreen(), half, 1.5 * test::OneStep, "green, in a strange state");
    // The scissor rectangle is obeyed.
    checks.Near(target.ReadGreen(10, 20), half, 1.5 * test::OneStep, "inside the rectangle");
    checks.Near(target.ReadGreen(34, 49), half, 1.5 * test::OneStep, "inside the rectangle");
    checks.Equal(target.ReadGreen(9, 30), 0.0, "left of the rectangle");
    checks.Equal(target.ReadGreen(35, 30), 0.0, "right of the rectangle");
    checks.Equal(target.ReadGreen(20, 50), 0.0, "above the rectangle");
  }
  window->GetState()->Reset();

  // A window with samples, and opaque geometry halfway.
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, 4.0);
  plane->SetPoint1(9.0, -1.0, 4.0);
  plane->SetPoint2(-1.0, 9.0, 4.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  test::Stage smooth(Size);
  smooth.window->SetMultiSamples(4);
  smooth.renderer->RemoveVolume(smooth.volume);
  smooth.renderer->AddVolume(stage.volume);
  smooth.renderer->AddActor(actor);
  test::lookAlongZ(smooth.renderer, 4.0, 4.0, 4.0, 8.0);
  checks.Near(test::Picture(smooth.window).Center()[1], half, 1.5 * test::OneStep, "with samples");
  return checks.Status();
}
