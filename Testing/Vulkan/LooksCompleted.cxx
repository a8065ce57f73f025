// SPDX-License-Identifier: BSD-3-Clause
// What is drawn of completed levels, but for plain pictures (CompletesLevels), beside brute force
// in double precision: shaded, with opacity by gradients, projected, and of all blend modes.
#include "SceneRenderer.h"
#include "Traversals.h"

#include "Accuracy/Candidates.h"
#include "Reference/Projection.h"
#include "Reference/Shaded.h"
#include "Reference/Surfaces.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
constexpr int Pixels = 40;

TransferFunction slopes()
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.05 } }, { 0.4, { 0.2, 0.9, 0.3, 0.2 } },
    { 0.7, { 0.9, 0.8, 0.1, 0.5 } }, { 1.0, { 1.0, 0.1, 0.0, 0.9 } } });
}

// Noise: all that a reconstruction does to cells shows.
std::vector<reference::Scene> scenes()
{
  return { reference::twoLevels(), reference::ratio4(), reference::anisotropic(),
    reference::mixedRatios() };
}

struct Case
{
  SceneRenderer subject;
  reference::Field leaves;
  accuracy::Candidates candidates;
  reference::View view;

  explicit Case(const reference::Scene& scene)
    : subject(scene)
    , leaves(scene.hierarchy, findLeafBoxes(scene.hierarchy), scene.cells, std::nullopt)
    , candidates(scene.hierarchy, findLeafBoxes(scene.hierarchy),
        [&](int level, const Int3& cell) { return *this->leaves.find(level, cell); })
    , view(subject.lookInside(Pixels))
  {
    this->subject.complete();
    this->subject.opacityUnitDistance = 6.0;
    this->subject.stepScale = 0.125;
    this->subject.setTransfer(slopes());
  }

  const Box& bounds() const { return this->subject.structure.tree.bounds; }

  reference::FieldFunction field() const
  {
    return [this](const glm::dvec3& logical) -> std::optional<double>
    {
      return this->leaves.sample(logical, reference::Reconstruction::Nearest)
        ? std::optional(this->candidates.completed(logical))
        : std::nullopt;
    };
  }

  reference::Image shade(const reference::ShadedSettings& settings) const
  {
    return reference::renderShaded(this->field(), this->bounds(), this->view,
      reference::logicalToWorld(this->subject.scene.hierarchy), this->subject.transfer, settings);
  }

  void expect(const std::string& what, const reference::Image& truth, double leastDecibel)
  {
    // By one traversal, as a pipeline for each takes longer than its pictures.
    this->subject.renderer.selectTraversal(traversalsOfDevice().front());
    const double quality = reference::psnrOfDrawn(this->subject.render(this->view), truth);
    std::cout << this->subject.scene.name << ", " << what << ": " << quality << " dB, coverage "
              << coverage(truth) << "\n";
    EXPECT_GE(quality, leastDecibel) << this->subject.scene.name << ", " << what;
    EXPECT_GT(coverage(truth), 0.05) << this->subject.scene.name << ", " << what;
  }
};
}

TEST(LooksCompleted, Shaded)
{
  for (const reference::Scene& scene : scenes())
  {
    Case test(scene);
    reference::ShadedSettings settings;
    settings.opacityUnitDistance = test.subject.opacityUnitDistance;
    const reference::Image unlit = test.shade(settings);
    settings.lighting = Lighting();
    settings.lighting->lights.emplace_back();
    settings.lighting->lights.back().direction = glm::normalize(glm::dvec3(-0.6, 0.5, -0.4));
    test.subject.lighting = settings.lighting;
    const reference::Image lit = test.shade(settings);
    EXPECT_LT(reference::psnrOfDrawn(unlit, lit), 25.0);
    test.expect("shaded", lit, 48.0);
  }
}

TEST(LooksCompleted, WithOpacityByGradients)
{
  for (const reference::Scene& scene : scenes())
  {
    Case test(scene);
    reference::ShadedSettings settings;
    settings.opacityUnitDistance = test.subject.opacityUnitDistance;
    const reference::Image plain = test.shade(settings);
    settings.gradientOpacity = [](double magnitude)
    { return std::clamp((magnitude - 0.03) / 0.05, 0.0, 1.0); };
    test.subject.renderer.setGradientOpacity(tabulateGradients(settings.gradientOpacity));
    const reference::Image truth = test.shade(settings);
    EXPECT_LT(reference::psnrOfDrawn(plain, truth), 35.0);
    test.expect("opacity by gradients", truth, 46.0);
  }
}

TEST(LooksCompleted, Surfaces)
{
  for (const reference::Scene& scene : scenes())
  {
    Case test(scene);
    test.subject.blending = Blending::Isosurface;
    test.subject.isoValues = { 0.3, 0.6 };
    test.expect("surfaces",
      reference::drawSurfaces(test.field(), test.bounds(), test.view, test.subject.transfer,
        test.subject.isoValues, 1.0 / 256.0),
      55.0);
  }
}

TEST(LooksCompleted, Projected)
{
  const struct
  {
    const char* name;
    Blending blending;
    double leastDecibel;
  } modes[] = { { "maximum", Blending::Maximum, 52.0 }, { "minimum", Blending::Minimum, 70.0 },
    { "average", Blending::Average, 80.0 }, { "additive", Blending::Additive, 80.0 } };
  for (const reference::Scene& scene : scenes())
  {
    for (const auto& mode : modes)
    {
      Case test(scene);
      test.subject.blending = mode.blending;
      test.subject.opacityUnitDistance = 24.0;
      reference::ProjectionSettings settings;
      settings.blending = mode.blending;
      settings.opacityUnitDistance = test.subject.opacityUnitDistance;
      const reference::Image truth =
        reference::project(test.field(), test.bounds(), test.view, test.subject.transfer, settings);
      test.expect(mode.name, truth, mode.leastDecibel);
    }
  }
}
