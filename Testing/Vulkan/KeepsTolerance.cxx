// SPDX-License-Identifier: BSD-3-Clause
// The error asked for is the error got.
#include "SceneRenderer.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
double errorOfDrawn(const reference::Image& a, const reference::Image& b)
{
  return std::pow(10.0, -reference::psnrOfDrawn(a, b) / 20.0);
}
}

TEST(KeepsTolerance, WithinAFactorOfTwo)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::mixedRatios(),
         reference::anisotropic(), reference::holes() })
  {
    SCOPED_TRACE(scene.name);
    SceneRenderer subject(scene);
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 128);
    const reference::Image truth = subject.renderOracle(view);
    for (const Traversal traversal : { Traversal::KdTree, Traversal::RayQuery })
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
    for (int x = 0; x < 40; ++x)
    {
      view.depth[x + 131 * y] = 1.0f;
    }
  }
  const double error = errorOfDrawn(subject.render(view), subject.renderOracle(view));
  EXPECT_LE(error, 0.006);
  EXPECT_GE(error, 0.0015);
}

TEST(KeepsTolerance, OfWhatIsSmallInThePicture)
{
  // Too small for the first few pixels to find much of it.
  SceneRenderer subject(reference::twoLevels());
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 400);
  const glm::dmat4 away = glm::scale(glm::dmat4(1.0), glm::dvec3(16.0, 16.0, 1.0));
  view.ndcToLogical = view.ndcToLogical * away;
  view.ndcToWorld = view.ndcToWorld * away;
  subject.errorTolerance = 0.003;
  const double error = errorOfDrawn(subject.render(view), subject.renderOracle(view));
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
