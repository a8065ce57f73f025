// SPDX-License-Identifier: BSD-3-Clause
// A picture in parts: pieces of rays between two depths, as peels of translucent geometry ask for
// them, and tiles. With an error tolerance all parts have the levels and steps of the whole, which
// are those of the view alone, whatever was drawn before.
#include "SceneRenderer.h"
#include "Traversals.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
using Pixels = std::vector<glm::vec4>;

Pixels render(SceneRenderer& subject, const View& view)
{
  Pixels pixels;
  const std::string fault = subject.renderer.render(view, pixels);
  EXPECT_EQ(fault, "");
  return pixels;
}

// Windows depths between the near and the far side of the data, another one for each pixel.
std::vector<float> depthsInside(const SceneRenderer& subject, const reference::View& view)
{
  const double middle = subject.middleDepth(view);
  std::vector<float> depths(static_cast<std::size_t>(view.width) * view.height);
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    depths[i] = static_cast<float>(middle + 0.002 * (double(i * 7 % 16) - 8.0));
  }
  return depths;
}

reference::Image toImage(const View& view, const Pixels& pixels)
{
  return { view.target.width, view.target.height, { pixels.begin(), pixels.end() } };
}
}

TEST(DrawsParts, PiecesOfRaysBlendToTheWhole)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View from = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  for (const Reconstruction reconstruction : { Reconstruction::Basis, Reconstruction::Nearest })
  {
    for (const Traversal traversal : traversalsOfDevice())
    {
      subject.renderer.selectTraversal(traversal);
      subject.reconstruction = reconstruction;
      View view = subject.toView(from);
      const reference::Image whole = toImage(view, render(subject, view));
      const std::vector<float> cut = depthsInside(subject, from);
      view.target.depth = cut.data();
      const Pixels front = render(subject, view);
      view.target.depth = nullptr;
      view.target.nearDepth = cut.data();
      const Pixels back = render(subject, view);
      Pixels both(front.size());
      double least = 1.0;
      for (std::size_t i = 0; i < both.size(); ++i)
      {
        both[i] = front[i] + (1.0f - front[i].a) * back[i];
        least = front[i].a > 0.2f && back[i].a > 0.2f ? 0.0 : least;
      }
      EXPECT_EQ(least, 0.0) << "some pixels show much of both";
      EXPECT_GE(reference::psnr(toImage(view, both), whole), 60.0);
      // Nothing lies between a depth and itself, or behind the end.
      view.target.depth = cut.data();
      EXPECT_EQ(coverage(toImage(view, render(subject, view))), 0.0);
      const std::vector<float> before(cut.size(), 0.0f);
      view.target.depth = before.data();
      EXPECT_EQ(coverage(toImage(view, render(subject, view))), 0.0);
    }
  }
}

TEST(DrawsParts, WithTheLevelsAndStepsOfTheWhole)
{
  SceneRenderer subject(reference::twoLevels());
  subject.errorTolerance = 0.01;
  const reference::View from = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 128);
  const View whole = subject.toView(from);
  const Pixels expected = render(subject, whole);
  const VolumeRenderer::Statistics wanted = subject.renderer.statistics();

  SceneRenderer other(reference::twoLevels()); // which has seen no whole picture
  other.errorTolerance = 0.01;
  std::vector<float> hidden(64 * 64, 0.0f);
  for (int tile = 3; tile >= 0; --tile)
  {
    View view = whole;
    view.target.whole = Target::Whole{ whole.camera, whole.target.width, whole.target.height };
    view.target.width = view.target.height = 64;
    const glm::dmat4 part =
      glm::scale(glm::translate(
                   glm::dmat4(1.0), glm::dvec3(tile % 2 ? 0.5 : -0.5, tile / 2 ? 0.5 : -0.5, 0.0)),
        glm::dvec3(0.5, 0.5, 1.0));
    view.camera.ndcToHalfCells = whole.camera.ndcToHalfCells * part;
    // Rounding, as each tile has a camera of its own.
    view.target.whole->camera.ndcToHalfCells = view.camera.ndcToHalfCells * glm::inverse(part);
    const Pixels pixels = render(other, view);
    EXPECT_EQ(other.renderer.statistics().stepScale, wanted.stepScale) << tile;
    EXPECT_EQ(other.renderer.statistics().levelsLeftOut, wanted.levelsLeftOut) << tile;
    double off = 0.0;
    for (int y = 0; y < 64; ++y)
    {
      for (int x = 0; x < 64; ++x)
      {
        const glm::vec4 d =
          pixels[x + 64 * y] - expected[x + tile % 2 * 64 + 128 * (y + tile / 2 * 64)];
        off = std::max<double>(off, std::abs(d.a));
      }
    }
    EXPECT_LE(off, 1e-5) << tile;
    // Nor does it count what geometry hides of one part.
    view.target.depth = hidden.data();
    EXPECT_EQ(coverage(toImage(view, render(other, view))), 0.0);
    EXPECT_EQ(other.renderer.statistics().stepScale, wanted.stepScale) << tile;
  }
}

TEST(DrawsParts, TheSameWhateverWasDrawnBefore)
{
  SceneRenderer subject(reference::mixedRatios());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 128);
  subject.errorTolerance = 0.01;
  const reference::Image first = subject.render(view);
  EXPECT_GT(coverage(first), 0.05);
  EXPECT_EQ(largestDifference(subject.render(view), first), 0.0);
  for (const double between : { 0.1, 0.001, 0.03 })
  {
    subject.errorTolerance = between;
    subject.render(subject.look({ 1.0, 0.3, 0.2 }, 30.0, 200));
    subject.render(view);
    subject.errorTolerance = 0.01;
    EXPECT_EQ(largestDifference(subject.render(view), first), 0.0) << between;
  }
  // Depth is a part of the view, here of one that is whole.
  reference::View cut = view;
  cut.depth = depthsInside(subject, view);
  const reference::Image cutFirst = subject.render(cut);
  subject.render(view);
  EXPECT_EQ(largestDifference(subject.render(cut), cutFirst), 0.0);
}
