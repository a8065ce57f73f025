// SPDX-License-Identifier: BSD-3-Clause
// The Vulkan pass draws what the formulas say: pictures at a quarter of a cell's step match the
// double-precision oracle, and get better with the square of the step.
#include "SceneRenderer.h"
#include "Traversals.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>

using namespace exabricks;

namespace
{
void expectMatch(const reference::Scene& scene, Reconstruction reconstruction, double bound)
{
  SceneRenderer subject(scene);
  subject.reconstruction = reconstruction;
  for (const double viewAngle : { 30.0, 0.0 })
  {
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, viewAngle);
    const reference::Image truth = subject.renderOracle(view);
    const reference::Image picture = subject.render(view);
    const double quality = reference::psnr(picture, truth);
    std::cout << scene.name << (viewAngle > 0.0 ? " perspective" : " parallel") << ": " << quality
              << " dB, coverage " << coverage(truth) << ", "
              << subject.renderer.statistics().activeRegions << " of "
              << subject.structure.tree.regions.size() << " regions active\n";
    EXPECT_GE(quality, bound) << scene.name;
    EXPECT_GT(coverage(truth), 0.02) << scene.name;
  }
}
}

TEST(MatchesOracle, BasisOnEveryScene)
{
  for (const reference::Scene& scene : reference::allScenes())
  {
    expectMatch(scene, Reconstruction::Basis, 60.0);
  }
}

TEST(MatchesOracle, NearestOnEveryScene)
{
  for (const reference::Scene& scene : reference::allScenes())
  {
    expectMatch(scene, Reconstruction::Nearest, 100.0); // exact: one interval for each cell
  }
}

TEST(MatchesOracle, RaysAlongAnAxisAndThroughCellFaces)
{
  SceneRenderer subject(reference::twoLevels());
  for (const glm::dvec3 direction :
    { glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0) })
  {
    // 64 pixels: many rays run exactly in faces and edges of cells.
    const reference::View view = subject.look(direction, 0.0, 64);
    EXPECT_GE(reference::psnr(subject.render(view), subject.renderOracle(view)), 50.0);
  }
}

TEST(MatchesOracle, AnOpaqueValueIsOpaqueAtAnyLength)
{
  SceneRenderer subject(reference::twoLevels());
  subject.setTransfer(TransferFunction({ { 0.0, { 0.2, 0.4, 0.8, 1.0 } } }));
  subject.opacityUnitDistance = 1e6; // that of the whole domain, in metres say
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image picture = subject.render(view);
  EXPECT_GE(reference::psnr(picture, subject.renderOracle(view)), 100.0);
  EXPECT_EQ(picture.at(48, 48).a, 1.0);
}

TEST(MatchesOracle, LabelsOfOpacityOneAreOpaque)
{
  // Values 0, 0.5 and 1; opacity 1 at 0.5 alone, as tents around labels have it.
  SceneRenderer subject({ "labels", reference::twoLevels().hierarchy,
    reference::fillCells(reference::twoLevels().hierarchy,
      [](int level, const Int3& c)
      { return std::floor(3.0 * reference::noise(level, c, 3)) / 2.0; }) });
  subject.setTransfer(TransferFunction({ { 0.4, { 1.0, 0.5, 0.0, 0.0 } },
    { 0.5, { 1.0, 0.5, 0.0, 1.0 } }, { 0.6, { 1.0, 0.5, 0.0, 0.0 } } }));
  subject.reconstruction = Reconstruction::Nearest;
  subject.opacityUnitDistance = 1e3;
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image picture = subject.render(view);
  EXPECT_GE(reference::psnr(picture, subject.renderOracle(view)), 100.0);
  EXPECT_EQ(picture.at(48, 48).a, 1.0);
}

TEST(MatchesOracle, APlateauOfTheGreatestValueBesideAbsentCells)
{
  // Weighted means of 1 round to a little more than 1, which is no value of the transfer function.
  const Hierarchy hierarchy = reference::twoLevels().hierarchy;
  SceneRenderer subject({ "plateau", hierarchy,
    reference::fillCells(hierarchy,
      [](int level, const Int3& c)
      {
        const double chance = reference::noise(level, c, 5);
        return chance < 0.2 ? std::numeric_limits<double>::quiet_NaN() : chance < 0.3 ? 0.0 : 1.0;
      }) });
  subject.setTransfer(
    TransferFunction({ { 0.0, { 0.0, 0.5, 1.0, 0.0 } }, { 1.0, { 1.0, 0.5, 0.0, 1.0 } } }));
  subject.opacityUnitDistance = 20.0;
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  for (const Traversal traversal : traversalsOfDevice())
  {
    subject.renderer.selectTraversal(traversal);
    const reference::Image picture = subject.render(view);
    for (const glm::dvec4& pixel : picture.pixels)
    {
      EXPECT_GE(std::min({ pixel.r, pixel.g, pixel.b, pixel.a }), 0.0);
      EXPECT_LE(std::max({ pixel.r, pixel.g, pixel.b, pixel.a }), 1.0 + 1e-6);
    }
  }
}

TEST(MatchesOracle, DeepHierarchiesWithHugeCells)
{
  // Eleven levels around a corner: cells of the coarsest are 1024 finest ones wide, and a ray's
  // distances within one region large.
  reference::Scene scene;
  scene.name = "eleven levels";
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(32) } } };
  for (int level = 0; level < 11; ++level)
  {
    scene.hierarchy.cellWidth.push_back(std::int64_t(1) << (10 - level));
    if (level > 0)
    {
      scene.hierarchy.blocks.push_back({ level, { Int3(0), Int3(4) } });
    }
  }
  scene.cells = reference::fillCells(
    scene.hierarchy, [](int level, const Int3& c) { return reference::noise(level, c, 7); });
  for (const Reconstruction reconstruction : { Reconstruction::Basis, Reconstruction::Nearest })
  {
    SceneRenderer subject(scene);
    subject.reconstruction = reconstruction;
    subject.opacityUnitDistance = 4000.0;
    for (const glm::dvec3 direction : { glm::dvec3(-0.6, 0.5, -0.4), glm::dvec3(1.0) })
    {
      const reference::View view = subject.look(direction, 30.0, 48);
      const double quality = reference::psnr(subject.render(view), subject.renderOracle(view));
      std::cout << scene.name << ": " << quality << " dB\n";
      EXPECT_GE(quality, 50.0);
    }
  }
}

TEST(MatchesOracle, PicturesOfManyPixelsComeInBands)
{
  SceneRenderer subject(reference::uniform());
  subject.setTransfer(TransferFunction({ { 0.0, glm::dvec4(1.0) } }));
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 40);
  const reference::Image narrow = subject.render(view);
  view.width = 65000; // 16 rows are a band
  const reference::Image wide = subject.render(view);
  for (int y = 0; y < view.height; ++y)
  {
    EXPECT_EQ(wide.at(view.width / 2, y).a, narrow.at(view.height / 2, y).a) << y;
  }
  EXPECT_GT(coverage(wide), 0.1);
}

TEST(MatchesOracle, CameraInsideTheVolume)
{
  SceneRenderer subject(reference::mixedRatios());
  reference::View view = subject.look({ 0.3, 0.9, 0.2 }, 30.0);
  // The ray begins at the near plane, z = -1: let it begin half way to the far plane.
  const glm::dmat4 half = glm::translate(
    glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, 0.5)), glm::dvec3(0.0, 0.0, 1.0));
  view.ndcToLogical = view.ndcToLogical * half;
  view.ndcToWorld = view.ndcToWorld * half;
  EXPECT_GE(reference::psnr(subject.render(view), subject.renderOracle(view)), 50.0);
}

TEST(MatchesOracle, RaysEndAtTheDepthOfOpaqueGeometry)
{
  SceneRenderer subject(reference::twoLevels());
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image whole = subject.render(view);
  view.depth.assign(static_cast<std::size_t>(view.width) * view.height, 1.0f);
  for (int i = 0; i < view.width * view.height; ++i)
  {
    // a staircase of depths through the volume
    const glm::dvec4 center = glm::inverse(view.ndcToLogical) *
      glm::dvec4(
        glm::dvec3(subject.structure.tree.bounds.lo + subject.structure.tree.bounds.hi) * 0.5, 1.0);
    view.depth[i] = static_cast<float>(0.5 + 0.5 * center.z / center.w) +
      0.002f * static_cast<float>(i % view.width / 16 - 3);
  }
  const reference::Image cut = subject.render(view);
  EXPECT_GE(reference::psnr(cut, subject.renderOracle(view)), 50.0);
  EXPECT_LT(coverage(cut), 0.9 * coverage(whole));
}

TEST(MatchesOracle, ErrorFallsWithTheSquareOfTheStep)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image truth = subject.renderOracle(view);
  double quality[3];
  const double scales[3] = { 1.0, 0.5, 0.25 };
  for (int i = 0; i < 3; ++i)
  {
    subject.stepScale = scales[i];
    quality[i] = reference::psnr(subject.render(view), truth);
    std::cout << "step " << scales[i] << ": " << quality[i] << " dB\n";
  }
  // Second order is 12 dB for each halving on smooth fields. The field has kinks at cell centres
  // and level boundaries, which cost some of it.
  EXPECT_GT(quality[1] - quality[0], 8.0);
  EXPECT_GT(quality[2] - quality[1], 8.0);
}
