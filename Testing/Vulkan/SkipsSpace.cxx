// SPDX-License-Identifier: BSD-3-Clause
// What the transfer function does not show is skipped, what it shows never is; and a change costs
// only what depends on it.
#include "SceneRenderer.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
// Opaque white between two values, as thin as wanted.
TransferFunction spike(double center, double width)
{
  return TransferFunction({ { 0.0, glm::dvec4(1, 1, 1, 0) },
    { center - 0.5 * width, glm::dvec4(1, 1, 1, 0) }, { center, glm::dvec4(1, 1, 1, 0.9) },
    { center + 0.5 * width, glm::dvec4(1, 1, 1, 0) }, { 1.0, glm::dvec4(1, 1, 1, 0) } });
}

// One level, a constant value in the left half, another in the right, and the ends of the range in
// two corner cells.
reference::Scene twoConstants(double left, double right)
{
  reference::Scene scene;
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(96, 32, 32) } } };
  scene.cells = reference::fillCells(scene.hierarchy,
    [=](int, const Int3& c) {
      return c == Int3(0) ? 0.0 : c == Int3(95, 0, 0) ? 1.0 : c.x < 48 ? left : right;
    });
  return scene;
}
}

TEST(SkipsSpace, ASpikeOfATenThousandthOfTheRangeIsNeitherSkippedNorMissed)
{
  SceneRenderer subject(twoConstants(0.31234, 0.7));
  subject.setTransfer(spike(0.31234, 1e-4));
  const reference::View view = subject.look({ 0, 1, 0 }, 0.0, 64);
  const reference::Image picture = subject.render(view);
  const reference::Image truth = subject.renderOracle(view);
  EXPECT_GE(reference::psnr(picture, truth), 50.0);
  EXPECT_NEAR(coverage(picture), coverage(truth), 0.001); // the left half
  EXPECT_GT(picture.at(24, 32).a, 0.99);
  EXPECT_EQ(picture.at(44, 32).a, 0.0);
}

TEST(SkipsSpace, OnlyRegionsThatShowSomethingAreActive)
{
  SceneRenderer subject(twoConstants(0.31234, 0.7));
  const std::size_t all = subject.structure.tree.regions.size();
  subject.setTransfer(TransferFunction({ { 0.5, glm::dvec4(1.0) } }));
  EXPECT_EQ(subject.renderer.statistics().activeRegions, all);
  subject.setTransfer(spike(0.31234, 1e-4));
  EXPECT_LT(subject.renderer.statistics().activeRegions, all);
  EXPECT_GT(subject.renderer.statistics().activeRegions, 0u);
  subject.setTransfer(TransferFunction({ { 0.5, glm::dvec4(1.0, 1.0, 1.0, 0.0) } }));
  EXPECT_EQ(subject.renderer.statistics().activeRegions, 0u);
  EXPECT_EQ(coverage(subject.render(subject.look({ 0, 1, 0 }, 0.0, 16))), 0.0);
}

TEST(SkipsSpace, SkippingChangesNoPixel)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.reconstruction = Reconstruction::Nearest; // exact, whatever the intervals
  const reference::Image skipping = subject.render(view);
  subject.reconstruction = Reconstruction::Basis;
  const reference::Image truth = subject.renderOracle(view);
  const double skippingBasis = reference::psnr(subject.render(view), truth);
  const std::size_t active = subject.renderer.statistics().activeRegions;
  // The same function once more, with an opacity too small to see everywhere, so that nothing is
  // skipped.
  std::vector<TransferFunction::Point> points = layeredTransfer().points();
  for (TransferFunction::Point& point : points)
  {
    point.color.a = std::max(point.color.a, 1e-12);
  }
  subject.setTransfer(TransferFunction(points));
  EXPECT_GT(subject.renderer.statistics().activeRegions, active);
  // intervals begin at other places: as near to what it ought to be
  EXPECT_NEAR(reference::psnr(subject.render(view), truth), skippingBasis, 2.0);
  subject.reconstruction = Reconstruction::Nearest;
  EXPECT_LE(largestDifference(skipping, subject.render(view)), 1e-5);
}

TEST(SkipsSpace, AMacrocellThatShowsNothingIsSkippedInsideABrick)
{
  // A ball in the middle of one brick.
  reference::Scene scene;
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(32) } } };
  scene.cells = reference::fillCells(scene.hierarchy,
    [](int, const Int3& c)
    { return std::exp(-0.02 * std::pow(glm::length(glm::dvec3(c) - 15.5), 2.0)); });
  SceneRenderer subject(scene);
  const std::size_t regions = subject.structure.tree.regions.size();
  ASSERT_EQ(regions, 1u);
  subject.setTransfer(
    TransferFunction({ { 0.5, glm::dvec4(1, 1, 1, 0) }, { 0.9, glm::dvec4(1) } }));
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  // the eight macrocells around the middle, as one box
  EXPECT_EQ(subject.renderer.statistics().activeBoxes, 1u);
  EXPECT_GE(reference::psnr(subject.render(view), subject.renderOracle(view)), 60.0);
}

TEST(SkipsSpace, ColoursKeepTheActiveRegionsAndTheCameraKeepsAll)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.render(view);
  const VolumeRenderer::Statistics before = subject.renderer.statistics();

  subject.render(subject.look({ 0.6, 0.5, 0.4 }, 30.0));
  EXPECT_EQ(subject.renderer.statistics().uploadTime, before.uploadTime);
  EXPECT_EQ(subject.renderer.statistics().colorTime, before.colorTime);
  EXPECT_EQ(subject.renderer.statistics().opacityTime, before.opacityTime);

  std::vector<TransferFunction::Point> points = layeredTransfer().points();
  for (TransferFunction::Point& point : points)
  {
    point.color = glm::dvec4(0.2, 0.9, 0.2, point.color.a * 0.5);
  }
  subject.setTransfer(TransferFunction(points));
  const reference::Image green = subject.render(view);
  EXPECT_EQ(subject.renderer.statistics().uploadTime, before.uploadTime);
  EXPECT_NE(subject.renderer.statistics().colorTime, before.colorTime);
  EXPECT_EQ(subject.renderer.statistics().opacityTime, before.opacityTime);
  EXPECT_GE(reference::psnr(green, subject.renderOracle(view)), 50.0);

  subject.setTransfer(spike(0.8, 0.1));
  const reference::Image other = subject.render(view);
  EXPECT_EQ(subject.renderer.statistics().uploadTime, before.uploadTime);
  EXPECT_NE(subject.renderer.statistics().opacityTime, before.opacityTime);
  EXPECT_GE(reference::psnr(other, subject.renderOracle(view)), 40.0); // steep
}

TEST(SkipsSpace, ARayEndsEarlyOnlyWhenNothingMoreCanBeSeen)
{
  SceneRenderer subject(reference::twoLevels());
  subject.opacityUnitDistance = 0.1; // dense
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image whole = subject.render(view);
  subject.terminationOpacity = 0.999;
  const double difference = largestDifference(whole, subject.render(view));
  EXPECT_LE(difference, 0.001 + 1e-6);
  EXPECT_GT(difference, 0.0);
}
