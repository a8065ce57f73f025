// SPDX-License-Identifier: BSD-3-Clause
// Shading and opacity by gradients beside brute force in double precision, on one level and across
// levels, with every kind of light. The scenes are noise, whose gradient jumps at each face between
// cells: errors fall with the step, not with its square.
#include "ShadedCase.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
constexpr int Pixels = 30;

TransferFunction fog()
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.0 } }, { 0.35, { 0.2, 0.8, 0.3, 0.1 } },
    { 0.7, { 0.9, 0.8, 0.1, 0.5 } }, { 1.0, { 1.0, 0.1, 0.0, 0.9 } } });
}

Lighting oneLight()
{
  Lighting lighting;
  lighting.lights.emplace_back();
  lighting.lights.back().direction = glm::normalize(glm::dvec3(-0.6, 0.5, -0.4));
  return lighting;
}

// A coloured light from the side, one in the middle of the volume, and a spot on a corner of it.
Lighting threeLights(const glm::dvec3& size)
{
  Lighting lighting = oneLight();
  lighting.materials[0].ambient = 0.2;
  lighting.materials[0].specular = 0.5;
  lighting.materials[0].specularPower = 20.0;
  lighting.lights[0].direction = { 1.0, 0.0, 0.0 };
  lighting.lights[0].diffuse = { 1.0, 0.5, 0.1 };
  Light lamp;
  lamp.positional = true;
  lamp.position = 0.5 * size;
  lamp.coneAngle = 180.0;
  lamp.attenuation = { 1.0, 0.01, 0.001 };
  lamp.diffuse = { 0.1, 0.7, 0.9 };
  lighting.lights.push_back(lamp);
  Light spot;
  spot.positional = true;
  spot.position = 2.0 * size;
  spot.direction = glm::normalize(-size);
  spot.coneAngle = 15.0;
  spot.exponent = 3.0;
  lighting.lights.push_back(spot);
  return lighting;
}

struct Case : ShadedCase
{
  explicit Case(const reference::Scene& scene)
    : ShadedCase(scene, fog(), Pixels)
  {
    this->subject.stepScale = 0.125;
  }
};

std::vector<reference::Scene> scenes()
{
  return { reference::uniform(), reference::twoLevels(), reference::ratio4(),
    reference::anisotropic(), reference::holes() };
}
}

TEST(ShadesByGradient, AHeadlight)
{
  for (const reference::Scene& scene : scenes())
  {
    Case test(scene);
    const reference::Image unshaded = test.truth();
    test.settings.lighting = oneLight();
    const reference::Image truth = test.truth();
    const double quality = test.compare(truth);
    std::cout << scene.name << ": " << quality << " dB, coverage " << coverage(truth)
              << ", beside unshaded " << reference::psnrOfDrawn(unshaded, truth) << " dB\n";
    EXPECT_GE(quality, 48.0) << scene.name;
    EXPECT_LT(reference::psnrOfDrawn(unshaded, truth), 25.0) << scene.name;
  }
}

TEST(ShadesByGradient, LightsOfEveryKind)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::anisotropic() })
  {
    for (const bool twoSided : { false, true })
    {
      Case test(scene);
      test.settings.lighting = threeLights(test.worldSize());
      test.settings.lighting->twoSided = twoSided;
      const double quality = test.compare(test.truth());
      std::cout << scene.name << (twoSided ? ", two-sided: " : ", one-sided: ") << quality
                << " dB\n";
      EXPECT_GE(quality, 48.0) << scene.name;
    }
  }
}

TEST(ShadesByGradient, OpacityByTheGradientsMagnitude)
{
  for (const reference::Scene& scene : scenes())
  {
    Case test(scene);
    test.view = test.subject.lookInside(Pixels / 2);
    const reference::Image plain = test.truth();
    test.settings.gradientOpacity = [](double magnitude)
    { return std::clamp((magnitude - 0.03) / 0.05, 0.0, 1.0); };
    test.subject.renderer.setGradientOpacity(tabulateGradients(test.settings.gradientOpacity));
    const reference::Image truth = test.truth();
    const double quality = test.compare(truth);
    std::cout << scene.name << ": " << quality << " dB, coverage " << coverage(truth)
              << ", beside plain " << reference::psnrOfDrawn(plain, truth) << " dB\n";
    EXPECT_GE(quality, 46.0) << scene.name;
    EXPECT_LT(reference::psnrOfDrawn(plain, truth), 35.0) << scene.name;
  }
}

TEST(ShadesByGradient, OfOpacityWhereThatIsAskedFor)
{
  // Opacity rises, is level and falls: normals lie one way, nowhere, and the other way.
  const TransferFunction hill({ { 0.0, { 0.1, 0.2, 0.9, 0.0 } }, { 0.3, { 0.2, 0.8, 0.3, 0.5 } },
    { 0.6, { 0.9, 0.8, 0.1, 0.5 } }, { 1.0, { 1.0, 0.1, 0.0, 0.0 } } });
  for (const reference::Scene& scene : { reference::twoLevels(), reference::anisotropic() })
  {
    Case test(scene);
    test.subject.setTransfer(hill);
    test.settings.lighting = oneLight();
    test.settings.lighting->twoSided = false;
    const reference::Image ofValues = test.truth();
    test.settings.lighting->normalsOfOpacity = true;
    const reference::Image truth = test.truth();
    const double quality = test.compare(truth);
    std::cout << scene.name << ": " << quality << " dB, beside normals of values "
              << reference::psnrOfDrawn(ofValues, truth) << " dB\n";
    EXPECT_GE(quality, 45.0) << scene.name; // an interval has one normal, whatever it passes
    EXPECT_LT(reference::psnrOfDrawn(ofValues, truth), 25.0) << scene.name;
  }
}
