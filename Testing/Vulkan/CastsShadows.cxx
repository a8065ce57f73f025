// SPDX-License-Identifier: BSD-3-Clause
// Light that the medium scatters and keeps from what is behind, beside brute force in double
// precision, which looks for shadows at each sample. Ours are found at cells and reconstructed
// between them, so that they are right where they change little over a cell: fog of smooth fields,
// on one level and across levels.
#include "ShadedCase.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
constexpr int Pixels = 24;

// Thin enough that light comes through many cells.
TransferFunction fog()
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.05 } }, { 0.5, { 0.2, 0.8, 0.3, 0.3 } },
    { 1.0, { 1.0, 0.1, 0.0, 0.8 } } });
}

Lighting lightFrom(const glm::dvec3& direction, const Scattering& scattering)
{
  Lighting lighting;
  lighting.lights.emplace_back();
  lighting.lights.back().direction = glm::normalize(direction);
  lighting.scattering = scattering;
  return lighting;
}

struct Case : ShadedCase
{
  explicit Case(const reference::Scene& scene)
    : ShadedCase(scene, fog(), Pixels)
  {
    this->subject.stepScale = 0.25;
    this->settings.step = 1.0 / 8.0;
  }
};
}

TEST(CastsShadows, OfOneLightThroughAllOfTheVolume)
{
  for (const reference::Scene& scene : { reference::uniform(), reference::twoLevels(),
         reference::ratio4(), reference::anisotropic(), reference::holes() })
  {
    Case test(scene);
    test.settings.lighting = lightFrom({ 0.7, 0.5, 0.2 }, { 2.0, 0.0, 0.0 });
    const reference::Image unshadowed = test.truth();
    const double scattered = test.compare(unshadowed);
    test.settings.lighting->scattering->reach = 1.0;
    const reference::Image truth = test.truth();
    const double shadowed = test.compare(truth);
    const double effect = reference::psnrOfDrawn(unshadowed, truth);
    std::cout << scene.name << ": without shadows " << scattered << " dB, with them " << shadowed
              << " dB, one beside the other " << effect << " dB\n";
    EXPECT_GE(scattered, 48.0) << scene.name;
    EXPECT_GE(shadowed, 38.0) << scene.name;
    EXPECT_LT(effect, 25.0) << scene.name;
  }
}

TEST(CastsShadows, OfLampsThatSurfacesReflectToo)
{
  for (const double blending : { 0.6, 1.4 })
  {
    Case test(reference::twoLevels());
    test.settings.lighting = lightFrom({ 0.0, 0.3, -1.0 }, { blending, 0.5, 0.3 });
    Light lamp; // beyond a corner
    lamp.positional = true;
    lamp.position = 1.2 * test.worldSize();
    lamp.coneAngle = 180.0;
    lamp.diffuse = { 1.0, 0.7, 0.4 };
    test.settings.lighting->lights.push_back(lamp);
    const reference::Image truth = test.truth();
    const double quality = test.compare(truth);
    test.settings.lighting->scattering->reach = 1.0;
    const double farther = reference::psnrOfDrawn(test.truth(), truth);
    test.settings.lighting->scattering->reach = 0.3;
    test.settings.lighting->scattering->anisotropy = 0.0;
    const double isotropic = reference::psnrOfDrawn(test.truth(), truth);
    std::cout << "blending " << blending << ": " << quality << " dB; beside shadows of any length "
              << farther << " dB, and of isotropic scattering " << isotropic << " dB\n";
    EXPECT_GE(quality, 48.0) << blending; // the gradients of noise jump
    EXPECT_LT(farther, quality - 5.0) << blending;
    EXPECT_LT(isotropic, 30.0) << blending;
  }
}

// What is cut away casts none.
TEST(CastsShadows, OfWhatIsDrawnAlone)
{
  Case test(reference::uniform());
  test.settings.lighting = lightFrom({ 0.0, 1.0, 0.0 }, { 2.0, 0.0, 1.0 });
  const glm::dvec3 middle =
    0.5 * glm::dvec3(test.subject.structure.tree.bounds.lo + test.subject.structure.tree.bounds.hi);
  test.view.cut.planes = { glm::dvec4(0.0, 1.0, 0.0, -middle.y) };
  const reference::Image clipped = test.draw();
  // The lower half is not there at all.
  const reference::FieldFunction field = reference::fieldOf(test.oracle);
  const reference::Image truth = test.truthOf([&](const glm::dvec3& place) -> std::optional<double>
    { return place.y < middle.y ? std::nullopt : field(place); });
  const double quality = reference::psnrOfDrawn(clipped, truth);
  std::cout << "clipped: " << quality << " dB\n";
  EXPECT_GE(quality, 40.0); // the reference's steps meet the plane anywhere
}

TEST(CastsShadows, OfCompletedLevelsAndOfNearestCells)
{
  for (const bool completed : { true, false })
  {
    Case test(reference::twoLevels());
    test.settings.lighting = lightFrom({ 0.7, 0.5, 0.2 }, { 2.0, 0.0, 1.0 });
    const reference::Image basis = test.draw();
    if (completed)
    {
      test.subject.complete();
    }
    else
    {
      test.subject.reconstruction = Reconstruction::Nearest;
    }
    const std::size_t searches = test.subject.renderer.statistics().shadowSearches;
    const reference::Image other = test.draw();
    EXPECT_EQ(test.subject.renderer.statistics().shadowSearches, searches + 1);
    test.settings.lighting->scattering->reach = 0.0;
    const double unshadowed = reference::psnrOfDrawn(test.draw(), other);
    const double same = reference::psnrOfDrawn(basis, other);
    std::cout << (completed ? "completed" : "nearest") << ": beside the basis " << same
              << " dB, beside none " << unshadowed << " dB\n";
    EXPECT_GE(same, 42.0); // other fields
    EXPECT_LT(unshadowed, 25.0);
  }
}

// Lights that stay are sought once, wherever the eye is; while something moves, others may lag.
TEST(CastsShadows, AsOftenAsLightsOrOpacitiesChange)
{
  Case test(reference::twoLevels());
  test.settings.lighting = lightFrom({ 0.7, 0.5, 0.2 }, { 2.0, 0.0, 1.0 });
  const auto searches = [&] { return test.subject.renderer.statistics().shadowSearches; };
  const auto draw = [&](const reference::View& from, bool moving)
  {
    View view = test.subject.toView(from);
    view.quality.keepsSampling = view.quality.lagsShadows = moving;
    std::vector<glm::vec4> picture;
    EXPECT_EQ(test.subject.renderer.render(view, picture), "");
    return picture;
  };
  test.subject.lighting = test.settings.lighting;
  const std::vector<glm::vec4> first = draw(test.view, false);
  EXPECT_EQ(searches(), 1u);
  draw(test.subject.look({ 1.0, 0.1, 0.3 }, 30.0, Pixels), false);
  EXPECT_EQ(searches(), 1u) << "another eye";
  test.subject.lighting->lights[0].direction = { 0.0, 0.0, 1.0 };
  draw(test.view, true);
  EXPECT_EQ(searches(), 1u) << "another light, while something moves";
  EXPECT_NE(draw(test.view, false), first);
  EXPECT_EQ(searches(), 2u) << "another light";
  test.subject.lighting->lights[0].diffuse = { 0.1, 0.2, 0.3 };
  test.subject.setTransfer(TransferFunction({ { 0.0, { 0.0, 1.0, 0.0, 0.05 } },
    { 0.5, { 0.0, 0.8, 0.0, 0.3 } }, { 1.0, { 0.0, 0.1, 0.0, 0.8 } } }));
  draw(test.view, false);
  EXPECT_EQ(searches(), 2u) << "other colors of the light and of the volume";
  test.subject.opacityUnitDistance = 2.0;
  draw(test.view, false);
  EXPECT_EQ(searches(), 3u) << "another unit distance";
  test.subject.opacityUnitDistance = 3.0;
  draw(test.view, false);
  test.subject.setTransfer(
    TransferFunction({ { 0.0, { 1.0, 1.0, 1.0, 0.3 } }, { 1.0, { 1.0, 1.0, 1.0, 0.6 } } }));
  draw(test.view, false);
  EXPECT_EQ(searches(), 5u) << "other opacities";
  test.subject.lighting->lights.push_back(test.subject.lighting->lights[0]);
  draw(test.view, false);
  EXPECT_EQ(searches(), 6u) << "one light more";
  test.subject.setTransfer(fog());
  test.subject.lighting = test.settings.lighting;
  EXPECT_EQ(draw(test.view, false), first) << "whatever was drawn before";
}

// A picture may be given up while shadows are sought, and the next one has them.
TEST(CastsShadows, OrIsGivenUp)
{
  Case test(reference::twoLevels());
  test.settings.lighting = lightFrom({ 0.7, 0.5, 0.2 }, { 2.0, 0.0, 1.0 });
  const reference::Image whole = test.draw();
  test.subject.setTransfer(fog());
  test.subject.lighting->scattering->reach = 0.4;
  std::vector<glm::vec4> picture(1);
  EXPECT_EQ(test.subject.renderer.render(
              test.subject.toView(test.view), picture, [](double) { return false; }),
    "");
  EXPECT_TRUE(picture.empty());
  const std::size_t searches = test.subject.renderer.statistics().shadowSearches;
  const reference::Image other = test.subject.render(test.view); // what was given up
  EXPECT_EQ(test.subject.renderer.statistics().shadowSearches, searches + 1);
  EXPECT_EQ(test.draw().pixels, whole.pixels);
  EXPECT_NE(other.pixels, whole.pixels);
}
