// SPDX-License-Identifier: BSD-3-Clause
// Shadows through components that have opacities of their own, and of as many lights as there may
// be.
#include "ShadedCase.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
constexpr int Pixels = 20;

TransferFunction fog()
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.05 } }, { 0.5, { 0.2, 0.8, 0.3, 0.3 } },
    { 1.0, { 1.0, 0.1, 0.0, 0.8 } } });
}

Lighting eightLights()
{
  Lighting lighting;
  lighting.scattering = Scattering{ 2.0, 0.0, 1.0 };
  for (int i = 0; i < 8; ++i)
  {
    lighting.lights.emplace_back();
    lighting.lights.back().direction =
      glm::normalize(glm::dvec3(std::sin(i), std::cos(i), std::sin(3.0 * i) + 0.5));
    lighting.lights.back().diffuse = glm::dvec3(0.15);
  }
  return lighting;
}
}

TEST(ShadowsOfComponents, AreThoseOfTheMediumThatTheyMake)
{
  ShadedCase test(reference::twoLevels(), fog(), Pixels);
  SceneRenderer& subject = test.subject;
  test.settings.lighting = eightLights();
  test.settings.step = 1.0 / 8.0;
  const reference::Image one = test.draw();
  const double quality = reference::psnrOfDrawn(one, test.truth());
  EXPECT_GE(quality, 55.0);

  // Twice the same component, each of half the weight, is that component.
  Medium medium;
  medium.functions = { fog(), fog() };
  medium.weights = glm::dvec4(0.5, 0.5, 0.0, 0.0);
  const Volume& alone = subject.plain;
  subject.renderer.setVolume({ alone.structure, alone.values, { alone.values } });
  subject.renderer.setMedium(medium);
  const double same = reference::psnrOfDrawn(test.draw(), one);
  std::cout << "eight lights: " << quality << " dB; through two halves: " << same << " dB\n";
  EXPECT_GE(same, 60.0);
}
