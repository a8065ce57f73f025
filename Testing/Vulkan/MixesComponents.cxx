// SPDX-License-Identifier: BSD-3-Clause
// Several components of one volume, beside brute force in double precision.
#include "SceneRenderer.h"
#include "Traversals.h"

#include "Reference/Mixture.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
constexpr int Pixels = 28;
constexpr double UnitDistance = 12.0;

// A component: the scene's cells and holes, with other values.
reference::Scene makeComponent(reference::Scene scene, int component)
{
  for (std::vector<double>& block : scene.cells.values)
  {
    for (double& value : block)
    {
      // a wave of its own for each, over the range of the scene's values
      value = component == 0
        ? value
        : 3.0 * component + 2.0 * std::sin((2.0 + component) * value + 0.7 * component);
    }
  }
  return scene;
}

// Red, green, blue and grey, each of some values of its own, of which none is opaque.
TransferFunction makeFunction(int component)
{
  const glm::dvec3 colors[4] = { { 0.9, 0.1, 0.1 }, { 0.1, 0.9, 0.2 }, { 0.2, 0.3, 1.0 },
    { 0.8, 0.8, 0.8 } };
  const glm::dvec4 hidden(colors[component], 0.0);
  const glm::dvec4 shown(colors[component], 0.7);
  const double first = 0.15 * component;
  return TransferFunction({ { first, hidden }, { first + 0.2, shown }, { first + 0.35, hidden },
    { 0.8, hidden }, { 1.0, shown } });
}

Medium makeMedium(Mixing mixing, int components)
{
  Medium medium;
  medium.mixing = mixing;
  if (mixing == Mixing::Independent)
  {
    for (int k = 0; k < components; ++k)
    {
      medium.functions.push_back(makeFunction(k));
    }
    medium.weights = { 1.0, 0.4, 2.0, 0.0 };
    return medium;
  }
  if (mixing == Mixing::ColorAndOpacity)
  {
    medium.functions.push_back(TransferFunction({ { 0.0, { 1.0, 0.2, 0.0, 1.0 } },
      { 0.5, { 0.1, 1.0, 0.3, 1.0 } }, { 1.0, { 0.0, 0.1, 1.0, 1.0 } } }));
  }
  std::vector<TransferFunction::Point> opacities = makeFunction(2).points();
  for (TransferFunction::Point& point : opacities)
  {
    point.color = glm::dvec4(1.0, 1.0, 1.0, point.color.a);
  }
  medium.functions.push_back(TransferFunction(opacities));
  medium.colorScale = { 0.6, 0.9, 1.0, 1.0 };
  medium.colorOffset = { 0.3, 0.05, 0.0, 0.0 };
  return medium;
}

struct Case
{
  const char* name;
  Mixing mixing;
  int components;
};

void PrintTo(const Case& given, std::ostream* out) { *out << given.name; }

class MixesComponents : public testing::TestWithParam<Case>
{
protected:
  // The truth is that of the renderer's scenes, each with one component.
  void Expect(const reference::Scene& scene, Reconstruction reconstruction) const
  {
    const Case& given = this->GetParam();
    std::vector<reference::Scene> parts;
    for (int k = 0; k < given.components; ++k)
    {
      parts.push_back(makeComponent(scene, k));
    }
    SceneRenderer subject(parts[0]);
    Volume volume = subject.plain;
    std::vector<std::unique_ptr<reference::Oracle>> oracles;
    std::vector<const reference::Oracle*> truths;
    for (int k = 0; k < given.components; ++k)
    {
      if (k > 0)
      {
        volume.furtherValues.push_back(makeValues(subject.structure, parts[k].cells));
      }
      oracles.push_back(std::make_unique<reference::Oracle>(
        parts[k].hierarchy, findLeafBoxes(parts[k].hierarchy), parts[k].cells));
      truths.push_back(oracles.back().get());
    }
    const Medium medium = makeMedium(given.mixing, given.components);
    subject.renderer.setVolume(volume);
    subject.renderer.setMedium(medium);
    subject.opacityUnitDistance = UnitDistance;
    subject.reconstruction = reconstruction;
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Pixels);
    reference::MixtureSettings settings;
    settings.reconstruction = reconstruction == Reconstruction::Nearest
      ? reference::Reconstruction::Nearest
      : reference::Reconstruction::Basis;
    settings.step = reconstruction == Reconstruction::Nearest ? 1.0 / 128 : 1.0 / 32;
    settings.opacityUnitDistance = UnitDistance;
    const reference::Image truth =
      reference::drawMixture(truths, subject.structure.tree.bounds, view, medium, settings);
    for (const Traversal traversal : traversalsOfDevice())
    {
      subject.renderer.selectTraversal(traversal);
      const double quality = reference::psnrOfDrawn(subject.render(view), truth);
      std::cout << given.name << ", " << scene.name
                << (reconstruction == Reconstruction::Nearest ? ", nearest: " : ", basis: ")
                << quality << " dB, coverage " << coverage(truth) << "\n";
      EXPECT_GE(quality, 60.0);
      EXPECT_GT(coverage(truth), 0.05);
    }
  }
};
}

TEST_P(MixesComponents, AsBruteForceDoes)
{
  for (const reference::Scene& scene :
    { reference::twoLevels(), reference::ratio4(), reference::anisotropic(), reference::holes() })
  {
    this->Expect(scene, Reconstruction::Basis);
    this->Expect(scene, Reconstruction::Nearest);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MixesComponents,
  testing::Values(Case{ "two independent", Mixing::Independent, 2 },
    Case{ "four independent", Mixing::Independent, 4 },
    Case{ "colour and opacity", Mixing::ColorAndOpacity, 2 }, Case{ "RGBA", Mixing::RGBA, 4 }));

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
  view.blending = Blending::Maximum;
  EXPECT_NE(subject.renderer.render(view, picture).find("absorption alone"), std::string::npos);
}
