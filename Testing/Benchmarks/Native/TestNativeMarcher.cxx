// SPDX-License-Identifier: BSD-3-Clause
// The native marcher draws the pictures of VolumeRenderer, so that the two can be timed against
// each other.
#include "NativeMarcher.h"
#include "Vulkan/SceneRenderer.h"

#include <gtest/gtest.h>

using namespace exabricks;
using benchmarks::NativeMarcher;

namespace
{
reference::Image draw(const NativeMarcher& marcher, const View& view, int threads)
{
  std::vector<glm::vec4> pixels;
  marcher.render(view, threads, pixels);
  return { view.target.width, view.target.height, { pixels.begin(), pixels.end() } };
}
}

TEST(TestNativeMarcher, DrawsTheShadersPicture)
{
  for (const reference::Scene& scene :
    { reference::twoLevels(), reference::mixedRatios(), reference::anisotropic() })
  {
    SceneRenderer subject(scene);
    subject.renderer.selectTraversal(Traversal::KdTree);
    const NativeMarcher marcher(subject.plain, subject.transfer);
    for (const double stepScale : { 0.25, 1.0 })
    {
      subject.stepScale = stepScale;
      const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 64);
      const reference::Image expected = subject.render(view);
      EXPECT_GT(coverage(expected), 0.01);
      for (const int threads : { 1, 3 })
      {
        const reference::Image image = draw(marcher, subject.toView(view), threads);
        EXPECT_LE(largestDifference(image, expected), 5e-6)
          << scene.name << ", step scale " << stepScale << ", " << threads << " threads";
      }
    }
  }
}

TEST(TestNativeMarcher, FollowsRaysFarFromTheirBase)
{
  // A copy of the scene behind it, so far along the diagonal that rays are set up anew in between.
  reference::Scene scene = reference::twoLevels();
  constexpr std::int64_t distance = 1 << 12;
  const std::size_t blocks = scene.hierarchy.blocks.size();
  const SceneRenderer one(scene);
  scene.cells.duplicates.resize(2 * blocks);
  for (std::size_t b = 0; b < blocks; ++b)
  {
    Block block = scene.hierarchy.blocks[b];
    const Int3 shift(distance / scene.hierarchy.cellWidth[block.level]);
    block.cells.lo += shift;
    block.cells.hi += shift;
    scene.hierarchy.blocks.push_back(block);
    scene.cells.blocks.push_back(block.cells);
    scene.cells.values.push_back(std::vector<double>(scene.cells.values[b]));
  }
  SceneRenderer both(scene);
  both.renderer.selectTraversal(Traversal::KdTree);
  const NativeMarcher marcher(both.plain, both.transfer);

  // Rays along the diagonal that begin before the first one and end behind the second.
  reference::View view = one.look({ 1.0, 1.0, 1.0 }, 0.0, 64);
  glm::dmat4 deeper = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -1.0));
  deeper = glm::scale(deeper, glm::dvec3(1.0, 1.0, 1000.0));
  deeper = glm::translate(deeper, glm::dvec3(0.0, 0.0, 1.0));
  view.ndcToLogical = view.ndcToLogical * deeper;
  view.ndcToWorld = view.ndcToWorld * deeper;
  const reference::Image expected = both.render(view);
  const View seen = both.toView(view);
  EXPECT_LE(largestDifference(draw(marcher, seen, 1), expected), 5e-6);
  // It sees both.
  const NativeMarcher alone(one.plain, one.transfer);
  EXPECT_GT(static_cast<double>(marcher.count(seen).samples),
    1.5 * static_cast<double>(alone.count(one.toView(view)).samples));
}

TEST(TestNativeMarcher, CountsWhatAPictureTakes)
{
  SceneRenderer subject(reference::twoLevels());
  const NativeMarcher marcher(subject.plain, subject.transfer);
  const reference::View from = subject.look({ 1.0, 0.2, 0.3 }, 30.0, 32);
  const NativeMarcher::Counts coarse = marcher.count(subject.toView(from));
  EXPECT_GT(coarse.rays, 0u);
  EXPECT_LE(coarse.rays, 32u * 32u);
  EXPECT_GE(coarse.treeSteps, coarse.regions);
  EXPECT_GE(coarse.intervals, coarse.regions);
  EXPECT_GE(coarse.samples, coarse.intervals);
  EXPECT_GE(coarse.bricks, coarse.samples);
  subject.stepScale *= 0.5;
  const NativeMarcher::Counts fine = marcher.count(subject.toView(from));
  EXPECT_EQ(fine.regions, coarse.regions);
  EXPECT_GT(fine.samples, coarse.samples);
}

TEST(TestNativeMarcher, RefusesWhatItCannotDraw)
{
  const SceneRenderer holes(reference::holes());
  ASSERT_GT(holes.plain.values->absentCells, 0u);
  EXPECT_THROW(NativeMarcher(holes.plain, holes.transfer), std::invalid_argument);

  const SceneRenderer whole(reference::uniform());
  const NativeMarcher marcher(whole.plain, whole.transfer);
  View view = whole.toView(whole.look({ 1.0, 0.2, 0.3 }, 30.0, 8));
  view.quality.reconstruction = Reconstruction::Nearest;
  std::vector<glm::vec4> pixels;
  EXPECT_THROW(marcher.render(view, 1, pixels), std::invalid_argument);
  EXPECT_THROW(marcher.count(view), std::invalid_argument);
}
