// SPDX-License-Identifier: BSD-3-Clause
// Volumes of one renderer that overlap are drawn as one medium: what each absorbs and emits adds
// up.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace
{
const test::Picture::Color Red{ 1.0, 0.0, 0.0 };
const test::Picture::Color Green{ 0.0, 1.0, 0.0 };

// A volume beside that of the stage.
struct Other
{
  vtkNew<vtkExaBricksVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;

  explicit Other(vtkOverlappingAMR* amr)
  {
    this->mapper->SetInputData(amr);
    this->volume->SetMapper(this->mapper);
    this->volume->GetProperty()->SetInterpolationTypeToLinear();
  }
};

// What a ray shows of lengths with an extinction of red and one of green, front to back.
test::Picture::Color expect(const std::vector<std::array<double, 3>>& pieces)
{
  test::Picture::Color color{ 0.0, 0.0, 0.0 };
  double transmittance = 1.0;
  for (const auto& [length, red, green] : pieces)
  {
    const double opacity = 1.0 - std::exp(-length * (red + green));
    color[0] += transmittance * opacity * red / (red + green);
    color[1] += transmittance * opacity * green / (red + green);
    transmittance *= 1.0 - opacity;
  }
  return color;
}

double wave(double x, double y, double z)
{
  return 0.5 + 0.25 * (std::sin(0.9 * x + 0.4 * z) + std::cos(0.7 * y));
}

double otherWave(double x, double y, double z)
{
  return 0.5 + 0.25 * (std::cos(1.1 * y - 0.3 * x) + std::sin(0.8 * z));
}
}

int TestOverlappingVolumes(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  const auto blocks = test::cornerRefined();

  // Two cubes, one from 0 to 8, the other one from 4 to 12: a ray from above is in the one, in
  // both, and in the other.
  test::Stage stage(test::makeAMR(blocks, test::constant(1.0)), 60);
  test::setConstantColor(stage.Property(), 1.0 - std::exp(-0.1), Red);
  Other other(test::makeAMR(blocks, test::constant(1.0)));
  test::setConstantColor(other.volume->GetProperty(), 1.0 - std::exp(-0.2), Green);
  other.volume->SetPosition(0.0, 0.0, 4.0);
  stage.renderer->AddVolume(other.volume);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 6.0, 8.0);
  const auto shows = [&](const test::Picture::Color& color, const std::string& what)
  {
    const test::Picture picture(stage.window);
    for (int c = 0; c < 2; ++c)
    {
      checks.Near(picture.Center()[c], color[c], test::OneStep, what + (c ? ", green" : ", red"));
    }
    checks.Expect(stage.mapper->GetDrawn() && other.mapper->GetDrawn(),
      what + ": both say that they are drawn");
  };
  const auto whole = expect({ { 4.0, 0.0, 0.2 }, { 4.0, 0.1, 0.2 }, { 4.0, 0.1, 0.0 } });
  shows(whole, "apart, together, apart");

  // Geometry within both ends the rays of both.
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 6.0);
  plane->SetPoint1(8.0, 0.0, 6.0);
  plane->SetPoint2(0.0, 8.0, 6.0);
  vtkNew<vtkPolyDataMapper> planeMapper;
  planeMapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(planeMapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  stage.renderer->AddActor(actor);
  shows(expect({ { 4.0, 0.0, 0.2 }, { 2.0, 0.1, 0.2 } }), "in front of geometry");

  // Translucent geometry within both.
  actor->GetProperty()->SetOpacity(0.5);
  stage.renderer->SetUseDepthPeeling(true);
  stage.renderer->SetUseDepthPeelingForVolumes(true);
  {
    const auto front = expect({ { 4.0, 0.0, 0.2 }, { 2.0, 0.1, 0.2 } });
    test::Picture::Color color = front;
    for (int c = 0; c < 2; ++c)
    {
      color[c] += 0.5 * (whole[c] - front[c]); // black and half transparent
    }
    shows(color, "around translucent geometry");
  }
  stage.renderer->SetUseDepthPeeling(false);
  stage.renderer->RemoveActor(actor);

  // One of them alone, and both again.
  other.volume->VisibilityOff();
  checks.Near(test::Picture(stage.window).Center()[0], expect({ { 8.0, 0.1, 0.0 } })[0],
    test::OneStep, "one alone");
  other.volume->VisibilityOn();
  shows(whole, "both again");

  // A volume that cannot be drawn says why, and the other one is drawn.
  other.mapper->SetScalarModeToUseCellFieldData();
  other.mapper->SelectScalarArray("there is none");
  checks.Near(test::Picture(stage.window).Center()[0], expect({ { 8.0, 0.1, 0.0 } })[0],
    test::OneStep, "beside one that cannot be drawn");
  checks.Says(messages.TakeErrors(), { "there is none" }, "one that cannot be drawn");
  checks.Expect(stage.mapper->GetDrawn() && !other.mapper->GetDrawn(), "which of them is drawn");
  other.mapper->SelectScalarArray("value");
  shows(whole, "both once more");

  // One whose device is not there says so, and the other one is drawn.
  other.mapper->SetDevice("abacus");
  checks.Near(test::Picture(stage.window).Center()[0], expect({ { 8.0, 0.1, 0.0 } })[0],
    test::OneStep, "beside one without a device");
  checks.Says(messages.TakeErrors(), { "abacus" }, "one without a device");
  checks.Expect(stage.mapper->GetDrawn() && !other.mapper->GetDrawn(), "drawn without a device");
  other.mapper->SetDevice(nullptr);
  shows(whole, "both with a device");

  // A part of an assembly is where the assembly has it.
  stage.renderer->RemoveVolume(other.volume);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(other.volume);
  assembly->SetPosition(1000.0, 0.0, 0.0);
  stage.renderer->AddActor(assembly);
  checks.Near(test::Picture(stage.window).Center()[0], expect({ { 8.0, 0.1, 0.0 } })[0],
    test::OneStep, "beside a part of an assembly that is elsewhere");
  assembly->SetPosition(0.0, 0.0, 0.0);
  assembly->VisibilityOff();
  checks.Near(test::Picture(stage.window).Center()[0], expect({ { 8.0, 0.1, 0.0 } })[0],
    test::OneStep, "beside a part of a hidden assembly");
  stage.renderer->RemoveActor(assembly);
  stage.renderer->AddVolume(other.volume);
  shows(whole, "the renderer's own again");

  // Volumes that share a mapper are drawn each for itself, wherever they are.
  {
    test::Stage shared(test::makeAMR(blocks, test::constant(1.0)), 60);
    test::setConstantColor(shared.Property(), 1.0 - std::exp(-0.1), Red);
    vtkNew<vtkVolume> second;
    vtkNew<vtkVolume> third;
    for (vtkVolume* volume : { second.Get(), third.Get() })
    {
      volume->SetMapper(shared.mapper);
      volume->SetProperty(shared.Property());
      shared.renderer->AddVolume(volume);
    }
    second->SetPosition(0.0, 0.0, 4.0);
    third->SetPosition(16.0, 0.0, 0.0);
    test::lookAlongZ(shared.renderer, 12.0, 4.0, 6.0, 24.0);
    const test::Picture picture(shared.window);
    checks.Near(picture.At(10, 30)[0], expect({ { 16.0, 0.1, 0.0 } })[0], 1.5 * test::OneStep,
      "two of one mapper");
    checks.Near(
      picture.At(50, 30)[0], expect({ { 8.0, 0.1, 0.0 } })[0], test::OneStep, "a third one apart");
  }

  // Boxes that stand on edge side by side, of which bounds along the axes overlap, but no depths.
  {
    test::Stage opaque(test::makeAMR(blocks, test::constant(1.0)), 60);
    test::setConstantColor(opaque.Property(), 1.0, Red);
    Other behind(test::makeAMR(blocks, test::constant(1.0)));
    test::setConstantColor(behind.volume->GetProperty(), 1.0, Green);
    opaque.volume->RotateZ(45.0);
    behind.volume->RotateZ(45.0);
    behind.volume->SetPosition(-8.8 * std::sqrt(0.5), 8.8 * std::sqrt(0.5), 0.0);
    opaque.renderer->AddVolume(behind.volume);
    vtkCamera* camera = opaque.renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetFocalPoint(0.0, std::sqrt(32.0), 4.0);
    camera->SetPosition(40.0, std::sqrt(32.0) - 40.0, 4.0);
    opaque.renderer->ResetCameraClippingRange();
    const test::Picture::Color color = test::Picture(opaque.window).Center();
    checks.Near(color[0], 1.0, test::OneStep, "red in front");
    checks.Near(color[1], 0.0, test::OneStep, "nothing of the green behind it");
  }

  // Two fields at one place are two independent components of one volume.
  const auto pair = test::makeAMR(blocks, wave);
  const std::vector<test::Field> waves{ wave, otherWave };
  test::forEachGrid(pair, [&](unsigned int, vtkUniformGrid* grid) { test::addCells(grid, waves); });
  test::Stage both(pair, 60);
  test::setRamp(both.Property(), 0.3, 0.9);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.1, 0.9, 0.2);
  colors->AddRGBPoint(1.0, 0.9, 0.9, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.4, 0.3);
  opacity->AddPoint(0.6, 0.0);
  both.Property()->SetColor(1, colors);
  both.Property()->SetScalarOpacity(1, opacity);
  both.Property()->SetScalarOpacityUnitDistance(1, 1.0);
  test::lookAlongZ(both.renderer, 4.0, 4.0, 4.0, 10.0);
  both.renderer->GetActiveCamera()->Azimuth(25.0);
  both.renderer->GetActiveCamera()->Elevation(15.0);
  both.renderer->ResetCameraClippingRange();
  const test::Picture truth(both.window);
  both.mapper->SetInputData(test::makeAMR(blocks, wave));
  Other second(test::makeAMR(blocks, otherWave));
  second.volume->GetProperty()->SetColor(colors);
  second.volume->GetProperty()->SetScalarOpacity(opacity);
  both.renderer->AddVolume(second.volume);
  const double decibel = test::Picture(both.window).Decibel(truth);
  std::cout << "two volumes as two components: " << decibel << " dB\n";
  checks.Expect(decibel > 45.0, "two volumes as two components");

  checks.Silent(messages.TakeErrors(), "nothing to say");
  checks.Silent(messages.TakeWarnings(), "nothing to say");
  return checks.Status();
}
