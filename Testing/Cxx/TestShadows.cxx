// SPDX-License-Identifier: BSD-3-Clause
// Light that the medium of a volume scatters, and the shadows that the volume casts on itself: a
// fog of one value everywhere, of which it is known how much light comes through to each place.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkLight.h"
#include "vtkVersionMacros.h"

#include <cmath>
#include <functional>

namespace
{
constexpr double Size = 8.0;    // of the cube
constexpr double Opacity = 0.6; // through it
const test::Picture::Color Orange{ 0.8, 0.5, 0.2 };
}

int TestShadows(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  constexpr int pixels = 50;
  test::Stage stage(test::makeAMR(test::cornerRefined(), test::constant(1.0)), pixels);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  vtkVolumeProperty* property = stage.Property();
  test::setConstantColor(property, Opacity, Orange);
  property->SetScalarOpacityUnitDistance(Size);
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.0);
  test::lookAlongZ(stage.renderer, 0.5 * Size, 0.5 * Size, 0.5 * Size, Size);

  checks.Equal(mapper->GetVolumetricScatteringBlending(), 0.0, "off by default");
  checks.Equal(mapper->GetGlobalIlluminationReach(), 0.0, "no shadows by default");

  // `share`: of the light, by the distance from the lower face along x.
  const auto shows = [&](const std::function<double(double)>& share, const std::string& what)
  {
    const test::Picture picture(stage.window);
    for (const int x : { 3, 12, 25, 40, 46 })
    {
      const double at = (x + 0.5) / pixels * Size;
      for (int c = 0; c < 3; ++c)
      {
        checks.Near(picture.At(x, 20)[c], Opacity * Orange[c] * (0.1 + 0.8 * share(at)),
          1.5 * test::OneStep, what + ", at " + std::to_string(at));
      }
    }
  };
  const auto through = [](double length) { return std::pow(1.0 - Opacity, length / Size); };

  // Fog has no surfaces that would reflect light.
  shows([](double) { return 0.0; }, "surfaces alone");
  mapper->SetVolumetricScatteringBlending(2.0);
  shows([](double) { return 1.0; }, "scattered");
  mapper->SetVolumetricScatteringBlending(0.5);
  shows([](double) { return 0.5; }, "where nothing changes, by halves");
  mapper->SetVolumetricScatteringBlending(2.0);

  // A light from the side.
  mapper->SetGlobalIlluminationReach(1.0);
  vtkNew<vtkLight> side;
  side->SetLightTypeToSceneLight();
  side->SetPosition(-1e3, 0.5 * Size, 0.5 * Size);
  side->SetFocalPoint(0.5 * Size, 0.5 * Size, 0.5 * Size);
  stage.renderer->RemoveAllLights(); // the headlight
  stage.renderer->AutomaticLightCreationOff();
  stage.renderer->AddLight(side);
  for (const int reconstruction : { vtkExaBricksVolumeMapper::BASIS,
         vtkExaBricksVolumeMapper::NEAREST, vtkExaBricksVolumeMapper::COMPLETED })
  {
    mapper->SetReconstruction(reconstruction);
    shows(through, std::string("shadowed, ") + mapper->GetReconstructionAsString());
  }
  mapper->SetReconstructionToBasis();
  checks.Expect(mapper->GetShadowTime() > 0.0, "shadows take time");
  side->SetPosition(1e3, 0.5 * Size, 0.5 * Size);
  shows([&](double x) { return through(Size - x); }, "from the other side");

  // Half as far as the cube is large, as VTK's mapper counts.
  const double reach = 1.0 - std::pow(1.0 - 0.5 / std::sqrt(3.0), 1.0 / 0.33);
  mapper->SetGlobalIlluminationReach(static_cast<float>(reach));
  shows([&](double x) { return through(std::min(Size - x, 0.5 * Size)); }, "half as far");
  mapper->SetGlobalIlluminationReach(1.0);

  // A lamp at the middle of a face lights what is beside it alike in each direction.
  side->SetPositional(true);
  side->SetPosition(0.0, 0.5 * Size, 0.5 * Size);
  side->SetConeAngle(180.0);
  {
    const test::Picture picture(stage.window);
    checks.Expect(picture.At(5, 25)[0] > picture.At(25, 25)[0] + 0.02 &&
        picture.At(25, 25)[0] > picture.At(45, 25)[0] + 0.02,
      "farther from a lamp it is darker");
    checks.Near(picture.At(10, 10)[0], picture.At(10, 39)[0], test::OneStep, "above and below");
  }
  side->SetPositional(false);

  // The headlight comes the way of the ray: of what is seen as much is lit as comes there and back.
  stage.renderer->RemoveAllLights();
  stage.renderer->AutomaticLightCreationOn();
  const double there = 1.0 - std::pow(1.0 - Opacity, 2.0);
  shows([&](double) { return 0.5 * there / Opacity; }, "headlight");

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  // Light that goes on in its own direction does not come back to the eye.
  property->SetScatteringAnisotropy(0.5);
  const double back = (1.0 - 0.25) / std::pow(1.0 + 0.25 + 1.0, 1.5);
  shows([&](double) { return back * 0.5 * there / Opacity; }, "onwards");
  property->SetScatteringAnisotropy(0.0);
#endif

  // A tolerance chooses steps with shadows too.
  mapper->SetErrorTolerance(0.002);
  shows([&](double) { return 0.5 * there / Opacity; }, "with a tolerance");
  mapper->SetErrorTolerance(0.0);
  checks.Silent(messages.TakeWarnings(), "no warnings");

  // What does not count is said once.
  const auto says = [&](const std::string& word)
  {
    test::Picture(stage.window);
    test::Picture(stage.window);
    checks.Equal(messages.Warnings().size(), 1, "warnings of " + word);
    checks.Says(messages.TakeWarnings(), { word, "is drawn without" }, word);
  };
  property->ShadeOff();
  says("the property's Shade");
  property->ShadeOn();
  mapper->SetVolumetricScatteringBlending(0.0);
  says("GlobalIlluminationReach");
  checks.Silent(messages.TakeErrors(), "no errors");
  return checks.Status();
}
