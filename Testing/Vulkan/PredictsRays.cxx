// SPDX-License-Identifier: BSD-3-Clause
// With an error tolerance, pixels that others predict well enough are not marched.
#include "SceneRenderer.h"
#include "Traversals.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
constexpr int Size = 208; // larger than what all pixels are marched of

reference::Image renderTruth(SceneRenderer& subject, const reference::View& view)
{
  subject.errorTolerance = 0.0;
  subject.stepScale = 1.0 / 8.0;
  return subject.render(view);
}

double partOfRays(const SceneRenderer& subject)
{
  return static_cast<double>(subject.renderer.statistics().rays) / (Size * Size);
}

// Mean over the pixels of a kind of the greatest difference of their channels.
template <typename IsOne>
double meanDifference(const reference::Image& a, const reference::Image& b, const IsOne& isOne)
{
  double sum = 0.0;
  int pixels = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    if (isOne(i % Size, i / Size))
    {
      const glm::dvec4 d = glm::abs(a.pixels[i] - b.pixels[i]);
      sum += std::max({ d.r, d.g, d.b, d.a });
      ++pixels;
    }
  }
  return sum / pixels;
}
}

TEST(PredictsRays, WithinTheError)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::mixedRatios(),
         reference::anisotropic(), reference::holes() })
  {
    SCOPED_TRACE(scene.name);
    SceneRenderer subject(scene);
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Size);
    const reference::Image truth = renderTruth(subject, view);
    EXPECT_EQ(partOfRays(subject), 1.0);
    for (const Traversal traversal : traversalsOfDevice())
    {
      subject.renderer.selectTraversal(traversal);
      double last = 0.0;
      for (const double tolerance : { 0.02, 0.005, 0.001 })
      {
        subject.errorTolerance = tolerance;
        EXPECT_LE(errorOfDrawn(subject.render(view), truth), 2.0 * tolerance);
        EXPECT_GT(partOfRays(subject), last) << "less error takes more rays";
        last = partOfRays(subject);
      }
      EXPECT_LT(last, 0.95);
    }
  }
}

TEST(PredictsRays, FewWhereThePictureIsSmooth)
{
  reference::Scene scene = reference::twoLevels();
  scene.cells = reference::fillCells(scene.hierarchy,
    [](int, const Int3& cell) { return 0.5 + 0.4 * std::sin(0.05 * double(cell.x + cell.y)); });
  SceneRenderer subject(scene);
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Size);
  const reference::Image truth = renderTruth(subject, view);
  subject.errorTolerance = 0.01;
  EXPECT_LE(errorOfDrawn(subject.render(view), truth), 0.02);
  EXPECT_LT(partOfRays(subject), 0.4);
  EXPECT_GT(partOfRays(subject), 1.0 / 16.0); // the first grid, and checks
}

TEST(PredictsRays, AllWhereNothingIsSmooth)
{
  // Noise of cells smaller than pixels: nothing between rays is like them.
  reference::Scene scene;
  scene.name = "noise";
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(320, 320, 2) } } };
  scene.cells = reference::fillCells(
    scene.hierarchy, [](int level, const Int3& cell) { return reference::noise(level, cell, 3); });
  SceneRenderer subject(scene);
  subject.setTransfer(
    TransferFunction({ { 0.0, { 0.1, 0.2, 1, 0.0 } }, { 1.0, { 1, 0.5, 0.1, 0.95 } } }));
  const reference::View view = subject.look({ 0.0, 0.0, -1.0 }, 0.0, Size);
  const reference::Image truth = renderTruth(subject, view);
  subject.errorTolerance = 0.005;
  EXPECT_LE(errorOfDrawn(subject.render(view), truth), 0.01);
  double drawn = 0.0;
  for (const glm::dvec4& pixel : truth.pixels)
  {
    drawn += pixel.a > 0.0 ? 1.0 : 0.0;
  }
  EXPECT_GT(partOfRays(subject), 0.95 * drawn / (Size * Size));
}

TEST(PredictsRays, NotAcrossEdgesOfGeometry)
{
  // Thin lines, which few rays of the first grid meet, and a slanted disc, whose depth goes evenly.
  SceneRenderer subject(reference::twoLevels());
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Size);
  const auto middle = static_cast<float>(subject.middleDepth(view));
  const auto isLine = [](int x, int y) { return x == 81 || x == y + 15 || y == 70; };
  const auto isDisc = [](int x, int y)
  { return std::hypot(x - 0.6 * Size, y - 0.6 * Size) < 0.2 * Size; };
  view.depth.assign(Size * Size, 1.0f);
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      view.depth[x + Size * y] = isLine(x, y) ? middle
        : isDisc(x, y)                        ? middle + 1e-5f * static_cast<float>(x)
                                              : 1.0f;
    }
  }
  const reference::Image truth = renderTruth(subject, view);
  subject.errorTolerance = 0.02;
  const reference::Image picture = subject.render(view);
  EXPECT_LE(errorOfDrawn(picture, truth), 0.04);
  EXPECT_LT(partOfRays(subject), 0.6);
  EXPECT_LE(meanDifference(picture, truth, isLine), 0.01);
}

TEST(PredictsRays, NotAcrossLinesAroundTheEye)
{
  // The eye is in the data, and the near plane close to it: window depths of a line and of what is
  // behind it are close together.
  SceneRenderer subject(reference::twoLevels());
  const Box& bounds = subject.structure.tree.bounds;
  const glm::dvec3 middle = 0.5 * (glm::dvec3(bounds.lo) + glm::dvec3(bounds.hi));
  const glm::dmat4 toWorld = reference::logicalToWorld(subject.scene.hierarchy);
  const double extent =
    glm::length(glm::dvec3(toWorld * glm::dvec4(glm::dvec3(bounds.size()), 0.0)));
  reference::Camera camera;
  camera.position = glm::dvec3(toWorld * glm::dvec4(middle, 0.0));
  camera.focalPoint = camera.position + glm::dvec3(1.0, 0.4, 0.3);
  camera.viewAngle = 60.0;
  camera.nearest = 0.0003 * extent;
  camera.farthest = 3.0 * extent;
  reference::View view = reference::makeView(subject.scene.hierarchy, camera, Size, Size);
  const auto depthAt = [&](double distance)
  {
    const double n = camera.nearest;
    const double f = camera.farthest;
    return static_cast<float>(f * (distance - n) / (distance * (f - n)));
  };
  const auto isLine = [](int x, int y) { return x == 81 || x == y + 15 || y == 71; };
  view.depth.assign(Size * Size, 1.0f);
  for (int i = 0; i < Size * Size; ++i)
  {
    view.depth[i] = isLine(i % Size, i / Size) ? depthAt(0.1 * extent) : depthAt(2.0 * extent);
  }
  const reference::Image truth = renderTruth(subject, view);
  EXPECT_GT(coverage(truth), 0.1);
  subject.errorTolerance = 0.05;
  const reference::Image picture = subject.render(view);
  EXPECT_LT(partOfRays(subject), 0.9);
  EXPECT_LE(meanDifference(picture, truth, isLine), 0.02);
}

TEST(PredictsRays, OfPicturesOfAnyShape)
{
  SceneRenderer subject(reference::twoLevels());
  for (const auto& [width, height] :
    { std::pair{ 1, 1 }, { 3, 2 }, { 100, 100 }, { 1, 40001 }, { 40001, 1 }, { 401, 103 } })
  {
    const reference::View from = reference::lookAt(subject.scene.hierarchy,
      subject.structure.tree.bounds, { -0.6, 0.5, -0.4 }, 30.0, width, height);
    subject.errorTolerance = 0.01;
    std::vector<glm::vec4> pixels;
    EXPECT_EQ(subject.renderer.render(subject.toView(from), pixels), "");
    EXPECT_EQ(pixels.size(), static_cast<std::size_t>(width) * height);
    EXPECT_LE(subject.renderer.statistics().rays, pixels.size());
  }
}

TEST(PredictsRays, AllOfWhatIsSmallInThePicture)
{
  // So few of the checked pixels are drawn that they tell nothing.
  SceneRenderer subject(reference::twoLevels());
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Size);
  const glm::dmat4 away = glm::scale(glm::dmat4(1.0), glm::dvec3(8.0, 8.0, 1.0));
  view.ndcToLogical = view.ndcToLogical * away;
  view.ndcToWorld = view.ndcToWorld * away;
  const reference::Image truth = renderTruth(subject, view);
  subject.errorTolerance = 0.01;
  EXPECT_LE(errorOfDrawn(subject.render(view), truth), 0.02);
  EXPECT_EQ(partOfRays(subject), 1.0);
}

TEST(PredictsRays, OfTheGreatestValuesToo)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Size);
  subject.blending = Blending::Maximum;
  const reference::Image truth = renderTruth(subject, view);
  subject.errorTolerance = 0.02;
  EXPECT_LE(errorOfDrawn(subject.render(view), truth), 0.04);
  EXPECT_LT(partOfRays(subject), 0.9);
}

TEST(PredictsRays, TheSameWhateverWasDrawnBefore)
{
  SceneRenderer subject(reference::mixedRatios());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Size);
  subject.errorTolerance = 0.01;
  const reference::Image first = subject.render(view);
  const std::size_t rays = subject.renderer.statistics().rays;
  subject.errorTolerance = 0.05;
  subject.render(subject.look({ 1.0, 0.3, 0.2 }, 30.0, 300));
  subject.errorTolerance = 0.01;
  EXPECT_EQ(largestDifference(subject.render(view), first), 0.0);
  EXPECT_EQ(subject.renderer.statistics().rays, rays);
}

TEST(PredictsRays, InPiecesThatMayBeGivenUp)
{
  SceneRenderer subject(reference::twoLevels());
  subject.errorTolerance = 0.003;
  const View view = subject.toView(subject.look({ -0.6, 0.5, -0.4 }, 30.0, Size));
  std::vector<double> done;
  std::vector<glm::vec4> pixels;
  EXPECT_EQ(subject.renderer.render(view, pixels,
              [&](double part)
              {
                done.push_back(part);
                return true;
              }),
    "");
  EXPECT_EQ(pixels.size(), std::size_t(Size) * Size);
  EXPECT_GE(done.size(), 5u); // first rays, two grids of checks and of the rest
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.back(), 1.0);
  int calls = 0;
  EXPECT_EQ(subject.renderer.render(view, pixels, [&](double) { return ++calls < 4; }), "");
  EXPECT_TRUE(pixels.empty());
  EXPECT_EQ(calls, 4);
}
