// SPDX-License-Identifier: BSD-3-Clause
// The error asked for is the error got.
#include "SceneRenderer.h"
#include "Traversals.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

TEST(KeepsTolerance, WithinAFactorOfTwo)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::mixedRatios(),
         reference::anisotropic(), reference::holes() })
  {
    SCOPED_TRACE(scene.name);
    SceneRenderer subject(scene);
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 128);
    const reference::Image truth = subject.renderOracle(view);
    for (const Traversal traversal : traversalsOfDevice())
    {
      subject.renderer.selectTraversal(traversal);
      subject.errorTolerance = 0.02;
      const double greatest = errorOfDrawn(subject.render(view), truth);
      for (const double tolerance : { 0.01, 0.003, 0.001 })
      {
        subject.errorTolerance = tolerance;
        const double error = errorOfDrawn(subject.render(view), truth);
        EXPECT_LE(error, 2.0 * tolerance);
        // or what is allowed more changes little, as regions are short
        EXPECT_TRUE(error >= 0.5 * tolerance || error >= 0.8 * greatest)
          << error << " of " << tolerance << ", at most " << greatest;
      }
    }
  }
}

TEST(KeepsTolerance, WithGeometryInFront)
{
  // Sizes that the pilot's pixels do not divide; all hidden but a strip.
  SceneRenderer subject(reference::twoLevels());
  reference::View view = reference::lookAt(
    subject.scene.hierarchy, subject.structure.tree.bounds, { -0.6, 0.5, -0.4 }, 30.0, 131, 97);
  subject.errorTolerance = 0.003;
  view.depth.assign(131 * 97, 0.0f);
  for (int y = 0; y < 97; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      view.depth[x + 131 * y] = 1.0f;
    }
  }
  const double error = errorOfDrawn(subject.render(view), subject.renderOracle(view));
  EXPECT_LE(error, 0.006);
  EXPECT_GE(error, 0.0015);
  EXPECT_NE(subject.renderer.statistics().stepScale, 0.25); // enough is to be seen to choose it
}

TEST(KeepsTolerance, OfWhatIsSmallInThePicture)
{
  // Too small for the first few pixels to find much of it; and for all of them to tell an error.
  SceneRenderer subject(reference::twoLevels());
  subject.errorTolerance = 0.003;
  const auto errorAt = [&](double timesFurther)
  {
    reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 400);
    const glm::dmat4 away =
      glm::scale(glm::dmat4(1.0), glm::dvec3(timesFurther, timesFurther, 1.0));
    view.ndcToLogical = view.ndcToLogical * away;
    view.ndcToWorld = view.ndcToWorld * away;
    return errorOfDrawn(subject.render(view), subject.renderOracle(view));
  };
  const double error = errorAt(16.0);
  EXPECT_LE(error, 0.006);
  EXPECT_GE(error, 0.0015);
  EXPECT_LE(errorAt(60.0), 0.003);
  EXPECT_EQ(subject.renderer.statistics().stepScale, 0.25); // short for all
}

TEST(KeepsTolerance, WithJitteredSamples)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 128);
  const reference::Image truth = subject.renderOracle(view);
  subject.errorTolerance = 0.003;
  subject.render(view);
  // Steps are not those that were chosen for samples at even distances.
  subject.jittered = true;
  const double error = errorOfDrawn(subject.render(view), truth);
  EXPECT_GT(subject.renderer.statistics().samplingTime, 0.0);
  EXPECT_LE(error, 0.006);
  EXPECT_GE(error, 0.0015);
}

TEST(KeepsTolerance, OfNoConcernToNearest)
{
  SceneRenderer subject(reference::twoLevels());
  subject.reconstruction = Reconstruction::Nearest;
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image exact = subject.render(view);
  subject.errorTolerance = 0.1;
  EXPECT_EQ(largestDifference(exact, subject.render(view)), 0.0);
}

TEST(KeepsTolerance, AndDrawsAsBeforeWithoutOne)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image before = subject.render(view);
  subject.errorTolerance = 0.01;
  EXPECT_GT(largestDifference(before, subject.render(view)), 0.0);
  subject.errorTolerance = 0.0;
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}

namespace
{
// Three levels everywhere, of which a smooth field needs none but the coarsest.
SceneRenderer makeOversampled(const reference::CellField& field)
{
  reference::Scene scene;
  scene.name = "oversampled";
  scene.hierarchy.cellWidth = { 4, 2, 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(24) } }, { 1, { Int3(0), Int3(48) } },
    { 2, { Int3(0), Int3(96) } } };
  scene.cells = reference::fillCells(scene.hierarchy, field);
  return SceneRenderer(scene);
}

double smooth(int, const Int3& cell)
{
  const glm::dvec3 p = (glm::dvec3(cell) + 0.5) / 96.0;
  return 0.5 + 0.5 * std::sin(5.0 * p.x) * std::cos(4.0 * p.y + 3.0 * p.z);
}

double rough(int level, const Int3& cell) { return reference::noise(level, cell, 7); }
}

TEST(KeepsTolerance, WithoutLevelsThatItAllowsToLeaveOut)
{
  SceneRenderer subject = makeOversampled(smooth);
  subject.setTransfer(TransferFunction(
    { { 0.0, { 0.2, 0.3, 1, 0.0 } }, { 0.5, { 1, 1, 1, 0.02 } }, { 1.0, { 1, 0.2, 0.1, 0.1 } } }));
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.stepScale = 0.25;
  const reference::Image truth = subject.render(view);
  for (const Traversal traversal : traversalsOfDevice())
  {
    subject.renderer.selectTraversal(traversal);
    subject.errorTolerance = 0.01;
    subject.levelsLeftOut.reset();
    EXPECT_LE(errorOfDrawn(subject.render(view), truth), 0.02);
    EXPECT_EQ(subject.renderer.statistics().levelsLeftOut, 2);
    const std::uint64_t bytes = subject.renderer.statistics().deviceBytes;
    // all of them, if told so
    subject.levelsLeftOut = 0;
    subject.render(view);
    EXPECT_EQ(subject.renderer.statistics().levelsLeftOut, 0);
    // and none is kept where steps alone count
    subject.errorTolerance = 0.0;
    EXPECT_LE(errorOfDrawn(subject.render(view), truth), 1e-6);
    EXPECT_LT(subject.renderer.statistics().deviceBytes, bytes);
  }
}

TEST(KeepsTolerance, WithAllLevelsWhereTheyAreNeeded)
{
  SceneRenderer subject = makeOversampled(rough);
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.stepScale = 0.25;
  const reference::Image truth = subject.render(view);
  subject.errorTolerance = 0.01;
  EXPECT_LE(errorOfDrawn(subject.render(view), truth), 0.02);
  EXPECT_EQ(subject.renderer.statistics().levelsLeftOut, 0);
  // Without two levels it is another picture, and of the same size in the same place.
  subject.errorTolerance = 0.0;
  subject.levelsLeftOut = 2;
  const reference::Image coarse = subject.render(view);
  EXPECT_GT(errorOfDrawn(coarse, truth), 0.02);
  EXPECT_NEAR(coverage(coarse), coverage(truth), 0.2 * coverage(truth));
  subject.levelsLeftOut = 99; // there are not so many
  EXPECT_EQ(largestDifference(subject.render(view), coarse), 0.0);
}

TEST(KeepsTolerance, OfCompletedLevels)
{
  SceneRenderer subject = makeOversampled(smooth);
  subject.complete();
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.stepScale = 0.125;
  const reference::Image truth = subject.render(view);
  subject.errorTolerance = 0.02;
  EXPECT_LE(errorOfDrawn(subject.render(view), truth), 0.04);
  EXPECT_GT(subject.renderer.statistics().levelsLeftOut, 0);
}

TEST(KeepsTolerance, OfWhatIsLitThoughItsColorIsOneEverywhere)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::anisotropic() })
  {
    SceneRenderer subject(scene);
    subject.opacityUnitDistance = 6.0;
    subject.setTransfer(
      TransferFunction({ { 0.0, { 0.9, 0.8, 0.7, 0.4 } }, { 1.0, { 0.9, 0.8, 0.7, 0.4 } } }));
    subject.lighting = Lighting();
    subject.lighting->lights.emplace_back();
    subject.lighting->lights.back().direction = glm::normalize(glm::dvec3(-0.6, 0.5, -0.4));
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 64);
    subject.stepScale = 0.02;
    const reference::Image fine = subject.render(view);
    for (const double tolerance : { 0.02, 0.005 })
    {
      subject.errorTolerance = tolerance;
      const double error = errorOfDrawn(subject.render(view), fine);
      std::cout << scene.name << ", tolerance " << tolerance << ": " << error << ", step "
                << subject.renderer.statistics().stepScale << "\n";
      EXPECT_LE(error, 2.0 * tolerance) << scene.name;
    }
    subject.errorTolerance = 0.0;
  }
}
