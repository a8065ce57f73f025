// SPDX-License-Identifier: BSD-3-Clause
// Translucent geometry before, in and behind the volume, where the renderer peels depth for volumes
// too, which is ParaView's default: each layer shows in its order, and the same in every picture.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkCullerCollection.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkSphereSource.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

namespace
{
constexpr int Size = 60;   // of the window
constexpr int Behind = 15; // columns of pixels: behind the sheets, and beside them
constexpr int Beside = 45;
constexpr double Unit = 8.0; // all through the cube: opacity 0.5
constexpr double Opacity = 0.5;
// Of 8 bits a colour; the two buffers of a peel are rounded to them, each time they are blended.
constexpr double Rounding = 2.5 * test::OneStep;

// A square of one colour across the left half of the view, at height z.
struct Sheet
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  Sheet(vtkRenderer* renderer, const test::Picture::Color& color, double opacity)
  {
    this->mapper->SetInputConnection(this->plane->GetOutputPort());
    this->actor->SetMapper(this->mapper);
    this->actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    this->actor->GetProperty()->SetOpacity(opacity);
    this->actor->GetProperty()->LightingOff();
    renderer->AddActor(this->actor);
  }

  void MoveTo(double z)
  {
    this->plane->SetOrigin(-1.0, -1.0, z);
    this->plane->SetPoint1(4.0, -1.0, z);
    this->plane->SetPoint2(-1.0, 9.0, z);
  }
};

// What is seen of layers, the nearest first: premultiplied colour and opacity.
struct Layers
{
  test::Picture::Color color{ 0.0, 0.0, 0.0 };
  double opacity = 0.0;

  void Add(const test::Picture::Color& ofLayer, double opacityOfLayer)
  {
    const double seen = (1.0 - this->opacity) * opacityOfLayer;
    for (int c = 0; c < 3; ++c)
    {
      this->color[c] += seen * ofLayer[c];
    }
    this->opacity += seen;
  }
};

const test::Picture::Color Red{ 1.0, 0.0, 0.0 };
const test::Picture::Color Green{ 0.0, 1.0, 0.0 };
const test::Picture::Color Blue{ 0.0, 0.0, 1.0 };

void peelDepth(vtkRenderer* renderer)
{
  renderer->SetUseDepthPeeling(true);
  renderer->SetUseDepthPeelingForVolumes(true);
  renderer->SetMaximumNumberOfPeels(20);
  renderer->SetOcclusionRatio(0.0);
}

// The same by passes of one's own.
void peelDepthByPasses(vtkRenderer* renderer)
{
  vtkNew<vtkDualDepthPeelingPass> peeling;
  peeling->SetMaximumNumberOfPeels(20);
  peeling->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  peeling->SetVolumetricPass(vtkNew<vtkVolumetricPass>());
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(peeling);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  renderer->SetPass(camera);
}
}

int TestTranslucentGeometry(int argc, char* argv[])
{
  test::Checks checks;
  auto amr = test::makeAMR(test::cornerRefined(), test::constant(3.0));
  test::Stage stage(amr, Size);
  test::setConstantColor(stage.Property(), Opacity, Green);
  stage.Property()->SetScalarOpacityUnitDistance(Unit);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  const auto expect =
    [&](const test::Picture& picture, int x, const Layers& layers, const std::string& what)
  {
    for (int c = 0; c < 3; ++c)
    {
      checks.Near(picture.At(x, Size / 2)[c], layers.color[c], Rounding,
        what + ", channel " + std::to_string(c));
    }
  };
  const auto ofVolume = [](double from, double to)
  { return test::opacityOf(Opacity, std::max(to - from, 0.0), Unit); };

  // Without any translucent geometry.
  peelDepth(stage.renderer);
  Layers alone;
  alone.Add(Green, ofVolume(0.0, 8.0));
  expect(test::Picture(stage.window), Behind, alone, "alone");

  // One translucent sheet, and opaque ones at the bottom of the volume or halfway.
  Sheet sheet(stage.renderer, Red, 0.5);
  Sheet opaque(stage.renderer, Blue, 1.0);
  for (const bool byPasses : { false, true })
  {
    if (byPasses)
    {
      stage.renderer->SetUseDepthPeeling(false);
      peelDepthByPasses(stage.renderer);
    }
    for (const double bottom : { -2.0, 3.0 })
    {
      opaque.MoveTo(bottom);
      for (const double z : { -1.0, 0.5, 4.0, 6.5, 9.0 })
      {
        sheet.MoveTo(z);
        stage.renderer->ResetCameraClippingRange();
        const test::Picture picture(stage.window);
        const std::string where = "sheet at " + std::to_string(z) + " over " +
          std::to_string(bottom) + (byPasses ? ", by passes" : "");
        const double below = std::max(bottom, 0.0);
        const double cut = std::min(std::max(z, below), 8.0);
        Layers layers;
        layers.Add(Green, ofVolume(cut, 8.0));
        layers.Add(Red, z > bottom ? 0.5 : 0.0);
        layers.Add(Green, ofVolume(below, cut));
        layers.Add(Blue, 1.0);
        expect(picture, Behind, layers, where);
        expect(picture, Beside, alone, "beside it, " + where);
        checks.Expect(stage.mapper->GetDrawn(), "drawn with the " + where);
        checks.Equal(test::Picture(stage.window).Difference(picture), 0.0, "twice, " + where);
      }
    }
  }
  stage.renderer->SetPass(nullptr);
  peelDepth(stage.renderer);

  // Several layers, peeled from both sides; and fewer peels than layers, where the rest is blended
  // in any order: of one colour, it does not matter.
  opaque.actor->VisibilityOff();
  std::vector<std::unique_ptr<Sheet>> more;
  for (const double z : { 1.0, 2.5, 6.0, 7.5 })
  {
    more.push_back(std::make_unique<Sheet>(stage.renderer, Red, 0.25));
    more.back()->MoveTo(z);
  }
  sheet.MoveTo(4.0);
  stage.renderer->ResetCameraClippingRange();
  Layers several;
  double last = 8.0;
  for (const double z : { 7.5, 6.0, 4.0, 2.5, 1.0 })
  {
    several.Add(Green, ofVolume(z, last));
    several.Add(Red, z == 4.0 ? 0.5 : 0.25);
    last = z;
  }
  several.Add(Green, ofVolume(0.0, last));
  expect(test::Picture(stage.window), Behind, several, "five sheets");
  stage.renderer->SetMaximumNumberOfPeels(1);
  const test::Picture few(stage.window);
  checks.Near(few.At(Behind, Size / 2)[0] + few.At(Behind, Size / 2)[1], several.opacity, 0.02,
    "with one peel");
  expect(few, Beside, alone, "beside them, with one peel");
  stage.renderer->SetMaximumNumberOfPeels(20);

  // With an error tolerance all pieces of a ray have the steps of the whole.
  stage.mapper->SetErrorTolerance(0.01);
  expect(test::Picture(stage.window), Behind, several, "five sheets, with a tolerance");
  stage.mapper->SetErrorTolerance(0.0);
  for (const auto& one : more)
  {
    one->actor->VisibilityOff();
  }

  // Two volumes one before the other, with the sheet between them and in each, or none.
  vtkNew<vtkExaBricksVolumeMapper> otherMapper;
  otherMapper->SetInputData(amr);
  vtkNew<vtkVolume> other;
  other->SetMapper(otherMapper);
  other->SetPosition(0.0, 0.0, -10.0);
  other->GetProperty()->SetInterpolationTypeToLinear();
  test::setConstantColor(other->GetProperty(), Opacity, Blue);
  other->GetProperty()->SetScalarOpacityUnitDistance(Unit);
  stage.renderer->AddVolume(other);
  auto* culler =
    vtkFrustumCoverageCuller::SafeDownCast(stage.renderer->GetCullers()->GetLastItem());
  culler->SetSortingStyleToBackToFront(); // VTK draws volumes in the order of their addition
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 0.0, 8.0);
  for (const double z : { 6.0, -1.0, -6.0 })
  {
    sheet.MoveTo(z);
    stage.renderer->ResetCameraClippingRange();
    const test::Picture two(stage.window);
    const double inFirst = std::min(std::max(z, 0.0), 8.0);
    const double inSecond = std::min(std::max(z, -10.0), -2.0);
    Layers layers;
    layers.Add(Green, ofVolume(inFirst, 8.0));
    layers.Add(Blue, ofVolume(inSecond, -2.0));
    layers.Add(Red, 0.5);
    layers.Add(Green, ofVolume(0.0, inFirst));
    layers.Add(Blue, ofVolume(-10.0, inSecond));
    expect(two, Behind, layers, "two volumes, sheet at " + std::to_string(z));
    Layers both;
    both.Add(Green, ofVolume(0.0, 8.0));
    both.Add(Blue, ofVolume(0.0, 8.0));
    expect(two, Beside, both, "two volumes, beside the sheet");
  }
  stage.renderer->RemoveVolume(other);

  // What cannot be drawn is said once, not in each peel, and not taken for drawn.
  {
    test::Messages messages;
    stage.mapper->SetDevice("abacus");
    for (int i = 0; i < 2; ++i)
    {
      Layers without;
      without.Add(Red, 0.5);
      expect(test::Picture(stage.window), Behind, without, "without a device");
      checks.Expect(!stage.mapper->GetDrawn(), "not drawn without a device");
    }
    checks.Equal(messages.Errors().size(), 1, "errors without a device");
    stage.mapper->SetDevice(nullptr);
  }

  // A translucent ball half in the volume, in perspective.
  stage.window->SetSize(200, 200);
  sheet.actor->VisibilityOff();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(8.0, 2.0, 6.0);
  sphere->SetRadius(3.0);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(sphereMapper);
  ball->GetProperty()->SetColor(1.0, 0.3, 0.2);
  ball->GetProperty()->SetOpacity(0.4);
  stage.renderer->AddActor(ball);
  stage.Property()->SetScalarOpacityUnitDistance(0.5 * Unit);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetFocalPoint(4.0, 4.0, 4.0);
  camera->SetPosition(14.0, -6.0, 26.0);
  stage.renderer->ResetCamera();
  const int image = vtkRegressionTestImage(stage.window);
  return image == vtkTesting::FAILED ? EXIT_FAILURE : checks.Status();
}
