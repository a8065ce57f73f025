// SPDX-License-Identifier: BSD-3-Clause
// Several components of one volume, beside brute force in double precision.
#include "Components.h"

using namespace exabricks;
using namespace exabricks::components;

namespace
{
class MixesComponents : public WithComponents
{
};
}

TEST_P(MixesComponents, AsBruteForceDoes)
{
  if (this->GetParam().mixing == Mixing::Planar && this->GetParam().components == 1)
  {
    for (const reference::Scene& scene :
      { reference::twoLevels(), reference::ratio4(), reference::anisotropic() })
    {
      this->Expect(scene, Reconstruction::Basis,
        { "by gradients", Blending::Composite, false, false, 52.0, 0.05, true });
    }
    return;
  }
  for (const reference::Scene& scene :
    { reference::twoLevels(), reference::ratio4(), reference::anisotropic(), reference::holes() })
  {
    this->Expect(scene, Reconstruction::Basis);
    // Of others cells are found the same way; drivers take long to compile each.
    if (this->GetParam().mixing != Mixing::ColorAndOpacity && this->GetParam().components == 2)
    {
      this->Expect(scene, Reconstruction::Nearest);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, MixesComponents,
  testing::Values(Case{ "two independent", Mixing::Independent, 2 },
    Case{ "four independent", Mixing::Independent, 4 },
    Case{ "colour and opacity", Mixing::ColorAndOpacity, 2 }, Case{ "RGBA", Mixing::RGBA, 4 },
    Case{ "value and gradient", Mixing::Planar, 1 }, Case{ "two values", Mixing::Planar, 2 }));

// One component twice, each half as dense, is that component.
TEST(MixesComponents, TwoHalvesAreOneWhole)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Pixels);
  const reference::Image whole = subject.render(view);
  Volume volume = subject.plain;
  volume.furtherValues.push_back(volume.values);
  Medium medium;
  medium.functions = { subject.transfer, subject.transfer };
  medium.weights = glm::dvec4(0.5);
  subject.renderer.setVolume(volume);
  subject.renderer.setMedium(medium);
  EXPECT_GE(reference::psnrOfDrawn(subject.render(view), whole), 90.0);
  EXPECT_GT(coverage(whole), 0.05);
  // and one component alone again
  subject.renderer.setVolume(subject.plain);
  EXPECT_EQ(largestDifference(subject.render(view), whole), 0.0);
}

// What is opaque hides what is behind it, whatever the other component is.
TEST(MixesComponents, OpaqueValuesAreOpaqueAtAnyLength)
{
  SceneRenderer subject(reference::twoLevels());
  Volume volume = subject.plain;
  volume.furtherValues.push_back(volume.values);
  Medium medium;
  medium.functions = { TransferFunction(
                         { { 0.0, { 1.0, 0.0, 0.0, 0.0 } }, { 0.5, { 1.0, 0.0, 0.0, 0.0 } },
                           { 0.5, { 1.0, 0.0, 0.0, 1.0 } }, { 1.0, { 1.0, 0.0, 0.0, 1.0 } } }),
    TransferFunction({ { 0.0, { 0.0, 1.0, 0.0, 0.01 } } }) };
  subject.renderer.setVolume(volume);
  subject.renderer.setMedium(medium);
  subject.opacityUnitDistance = 1e3; // so that the other one hardly shows
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Pixels);
  int opaque = 0;
  for (const glm::dvec4& pixel : subject.render(view).pixels)
  {
    if (pixel.a > 0.5)
    {
      ++opaque;
      EXPECT_NEAR(pixel.r, 1.0, 0.01);
      EXPECT_NEAR(pixel.a, 1.0, 1e-6);
    }
  }
  EXPECT_GT(opaque, Pixels * Pixels / 20);
}

TEST(MixesComponents, SaysWhatItCannotDraw)
{
  SceneRenderer subject(reference::uniform());
  View view = subject.toView(subject.look({ -0.6, 0.5, -0.4 }, 30.0, 8));
  Volume volume = subject.plain;
  volume.furtherValues.push_back(volume.values);
  subject.renderer.setVolume(volume);
  std::vector<glm::vec4> picture;
  EXPECT_NE(subject.renderer.render(view, picture).find("2 components"), std::string::npos);
  Medium medium;
  medium.functions = { subject.transfer, subject.transfer };
  subject.renderer.setMedium(medium);
  EXPECT_EQ(subject.renderer.render(view, picture), "");
  view.blending = Blending::Isosurface;
  EXPECT_NE(
    subject.renderer.render(view, picture).find("no iso-surfaces together"), std::string::npos);
}
