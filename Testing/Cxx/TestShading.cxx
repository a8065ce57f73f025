// SPDX-License-Identifier: BSD-3-Clause
// Shading by the gradient of the field: of values that rise evenly along one axis every normal is
// known, and so is what each light gives. And opacity by gradients, of fields of known slope.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkLight.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
constexpr double Opacity = 0.6; // through the cube
const test::Picture::Color Orange{ 0.8, 0.5, 0.2 };

// Values rise along one axis, on two levels.
vtkSmartPointer<vtkOverlappingAMR> makeSlope(int axis)
{
  return test::makeAMR(test::cornerRefined(),
    [axis](double x, double y, double z) { return axis == 0 ? x
                                             : axis == 1    ? y
                                                            : z; });
}
}

int TestShading(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(50);
  vtkVolumeProperty* property = stage.Property();
  test::setConstantColor(property, Opacity, Orange);
  property->SetScalarOpacityUnitDistance(8.0);
  property->ShadeOn();
  property->SetAmbient(0.2);
  property->SetDiffuse(0.5);
  property->SetSpecular(0.3);
  property->SetSpecularPower(4.0);
  stage.mapper->SetReconstructionToCompleted(); // even slopes across levels too

  // `diffuse` and `specular`: of white light, as far as it reaches.
  const auto shows = [&](double diffuse, double specular, const std::string& what)
  {
    const test::Picture::Color color = test::Picture(stage.window).Center();
    for (int c = 0; c < 3; ++c)
    {
      checks.Near(color[c], Opacity * (Orange[c] * (0.2 + 0.5 * diffuse) + 0.3 * specular),
        1.5 * test::OneStep, what + ", channel " + std::to_string(c));
    }
  };

  // The headlight shines along z. Seen from there, a slope along z is lit in full.
  stage.mapper->SetInputData(makeSlope(2));
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  shows(1.0, 1.0, "headlight, along z");
  stage.mapper->SetInputData(makeSlope(0));
  shows(0.0, 0.0, "headlight, along x");

  // The volume turned, and stretched: the normal of what is turned to the eye.
  vtkNew<vtkTransform> turned;
  turned->Translate(4.0, 4.0, 4.0);
  turned->RotateY(20.0);
  turned->Translate(-4.0, -4.0, -4.0);
  stage.volume->SetUserTransform(turned);
  stage.mapper->SetInputData(makeSlope(2));
  {
    const test::Picture::Color color = test::Picture(stage.window).Center();
    const double cosine = std::cos(20.0 * 3.14159265358979 / 180.0);
    const double lit = 0.2 + 0.5 * cosine;
    // Of the same opacity, the brighter the more it is lit: the ratio of two channels without their
    // common gloss is that of the colours, and the gloss is what is left.
    const double perColor = (color[0] - color[1]) / (Orange[0] - Orange[1]);
    const double gloss = color[0] - Orange[0] * perColor;
    const double reflected = 2.0 * cosine * cosine - 1.0; // of twice the angle
    checks.Near(
      gloss / perColor, 0.3 * std::pow(reflected, 4.0) / lit, 0.03, "turned by 20 degrees");
  }
  stage.volume->SetUserTransform(nullptr);

  // A light from the side, with a colour: one side of the slope is lit, or both.
  vtkNew<vtkLight> side;
  side->SetLightTypeToSceneLight();
  side->SetPosition(-10.0, 4.0, 4.0);
  side->SetFocalPoint(4.0, 4.0, 4.0);
  stage.renderer->AddLight(side);
  stage.renderer->AutomaticLightCreationOff();
  stage.mapper->SetInputData(makeSlope(0));
  shows(1.0, 0.0, "from the side");
  stage.renderer->SetTwoSidedLighting(false);
  shows(1.0, 0.0, "from the side of low values"); // normals point down the slope
  side->SetPosition(18.0, 4.0, 4.0);
  shows(0.0, 0.0, "from the side of high values");
  stage.renderer->SetTwoSidedLighting(true);
  shows(1.0, 0.0, "from that side, two-sided");
  side->SetIntensity(0.5);
  shows(0.5, 0.0, "half as bright");
  // In the outermost half of a cell slopes go on: there is no dull skin on any side of the data.
  for (const int reconstruction :
    { vtkExaBricksVolumeMapper::BASIS, vtkExaBricksVolumeMapper::COMPLETED })
  {
    stage.mapper->SetReconstruction(reconstruction);
    const test::Picture toTheEdges(stage.window);
    for (const int x : { 0, 1, 48, 49 })
    {
      checks.Near(toTheEdges.At(x, 40)[0], toTheEdges.At(25, 40)[0], 1.5 * test::OneStep,
        "at " + std::to_string(x) + " of 50");
    }
  }
  // Half way from the side to the eye, it is reflected to the other side; the headlight too is
  // there.
  stage.mapper->SetInputData(makeSlope(2));
  side->SetPosition(18.0, 4.0, 18.0);
  shows(1.0 + 0.5 * std::sqrt(0.5), 1.0 + 0.5 * 0.25, "between side and eye");
  stage.mapper->SetInputData(makeSlope(0));
  side->SetPosition(18.0, 4.0, 4.0);
  side->SwitchOff();
  shows(0.0, 0.0, "switched off");
  side->SwitchOn();
  side->SetIntensity(1.0);

  // A lamp whose cone misses what the middle of the picture shows.
  side->SetPositional(true);
  side->SetConeAngle(20.0);
  side->SetExponent(0.0);
  side->SetFocalPoint(4.0, 40.0, 4.0);
  shows(0.0, 0.0, "beside the cone");

  // No other blend mode is shaded.
  stage.mapper->SetBlendModeToMaximumIntensity();
  const test::Picture::Color flat = test::Picture(stage.window).Center();
  checks.Near(flat[0], Opacity * Orange[0], test::OneStep, "maximum is not shaded");
  stage.mapper->SetBlendModeToComposite();

  // Opacity by gradients: the slope is 1 over a mean width of a finest cell of 0.5, of which a
  // function of gradients makes a half.
  property->ShadeOff();
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.0, 0.0);
  byGradient->AddPoint(1.0, 1.0);
  property->SetGradientOpacity(byGradient);
  checks.Near(test::Picture(stage.window).Center()[0],
    Orange[0] * (1.0 - std::pow(1.0 - Opacity, 0.5)), test::OneStep, "opacity by gradients");
  property->SetDisableGradientOpacity(1);
  checks.Near(test::Picture(stage.window).Center()[0], Orange[0] * Opacity, test::OneStep,
    "without opacity by gradients");
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");

  // More lights than the shading takes are said.
  property->ShadeOn();
  for (int i = 0; i < 8; ++i)
  {
    stage.renderer->AddLight(vtkSmartPointer<vtkLight>::New());
  }
  test::Picture(stage.window);
  test::Picture(stage.window);
  checks.Equal(messages.Warnings().size(), 1, "warnings of ten lights");
  checks.Says(messages.TakeWarnings(), { "at most 8 lights", "found 10" }, "ten lights");
  return checks.Status();
}
