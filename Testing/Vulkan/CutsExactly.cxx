// SPDX-License-Identifier: BSD-3-Clause
// What is cut away is cut exactly, through cells and steps, wherever the cut runs: pictures match
// those of the oracle, whose rays are cut in double precision.
#include "SceneRenderer.h"
#include "Traversals.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>

using namespace exabricks;

namespace
{
glm::dvec3 middleOf(const SceneRenderer& subject)
{
  const auto& bounds = subject.structure.tree.bounds;
  return 0.5 * glm::dvec3(bounds.lo + bounds.hi);
}

// Leaves what is on the side of the normal, from a distance in finest cells behind `place` on.
glm::dvec4 planeAt(const glm::dvec3& place, const glm::dvec3& normal, double behind)
{
  return { normal, behind * glm::length(normal) - glm::dot(normal, place) };
}

// A box around the middle that is turned, and off the faces of cells.
std::vector<glm::dvec4> turnedBox(const SceneRenderer& subject)
{
  const glm::dvec3 x = glm::normalize(glm::dvec3(3.0, 1.0, -1.0));
  const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.2, 0.1, 1.0), x));
  const glm::dvec3 z = glm::cross(x, y);
  std::vector<glm::dvec4> planes;
  for (const glm::dvec3& axis : { x, y, z })
  {
    planes.push_back(planeAt(middleOf(subject), axis, 7.31));
    planes.push_back(planeAt(middleOf(subject), -5.0 * axis, 5.67)); // of any length
  }
  return planes;
}

// By all traversals.
void expectMatch(SceneRenderer& subject, double viewAngle, const reference::Cut& cut, double bound,
  const std::string& what)
{
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, viewAngle, 48);
  const reference::Image whole = subject.render(view);
  view.cut = cut;
  const reference::Image truth = subject.renderOracle(view);
  EXPECT_GT(coverage(truth), 0.005) << what;
  EXPECT_LT(reference::psnr(truth, whole), 40.0) << what;
  for (const Traversal traversal : traversalsOfDevice())
  {
    subject.renderer.selectTraversal(traversal);
    const double quality = reference::psnr(subject.render(view), truth);
    std::cout << subject.scene.name << ", " << what << ": " << quality << " dB\n";
    EXPECT_GE(quality, bound) << subject.scene.name << ", " << what;
  }
}

// As exact as without a cut, in MatchesOracle; in perspective, and parallel.
void expectMatch(SceneRenderer& subject, const reference::Cut& cut, const std::string& what)
{
  subject.reconstruction = Reconstruction::Basis;
  expectMatch(subject, 30.0, cut, 60.0, what + ", basis");
  subject.reconstruction = Reconstruction::Nearest;
  expectMatch(subject, 0.0, cut, 100.0, what + ", nearest");
}

// Regions around a block off the faces of cells.
reference::Cut cropping(const SceneRenderer& subject, unsigned int shownRegions)
{
  reference::Cut cut;
  cut.cropped = true;
  cut.lower = middleOf(subject) - glm::dvec3(5.37, 6.21, 4.44);
  cut.upper = middleOf(subject) + glm::dvec3(4.83, 3.12, 6.66);
  cut.shownRegions = shownRegions;
  return cut;
}

std::vector<reference::Scene> scenesToCut()
{
  return { reference::twoLevels(), reference::anisotropic(), reference::holes() };
}

// A field of one value, of which a piece of a quarter of a finest cell is half opaque: an error of
// 1e-3 half cells in its length shows as one of 7e-4.
struct EvenRenderer : SceneRenderer
{
  explicit EvenRenderer(const Hierarchy& hierarchy)
    : SceneRenderer({ "even", hierarchy,
        reference::fillCells(hierarchy, [](int, const Int3&) { return 1.0; }) })
  {
    this->setTransfer(TransferFunction({ { 0.0, { 0.2, 0.4, 0.8, 0.5 } } }));
    this->opacityUnitDistance = 0.25;
  }
};

// A slice of a quarter of a finest cell.
reference::Cut slice(const glm::dvec3& middle, const glm::dvec3& normal)
{
  return { { planeAt(middle, normal, 0.1), planeAt(middle, -normal, 0.15) } };
}

// Three crossed bars, a quarter of a finest cell thick.
reference::Cut bars(const glm::dvec3& middle)
{
  reference::Cut cut;
  cut.cropped = true;
  cut.lower = middle - 0.1;
  cut.upper = middle + 0.15;
  cut.shownRegions = 0x0417410;
  return cut;
}
}

TEST(CutsExactly, ByOneClippingPlane)
{
  for (const reference::Scene& scene : scenesToCut())
  {
    SceneRenderer subject(scene);
    const glm::dvec3 middle = middleOf(subject);
    expectMatch(subject, { { planeAt(middle, { 0.0, -1.0, 0.0 }, 2.37) } }, "along an axis");
    expectMatch(subject, { { planeAt(middle, { 1.0, 0.7, -0.3 }, 0.61) } }, "oblique");
    expectMatch(subject, { { planeAt(middle, { 0.6, -0.5, 0.45 }, -1.2) } }, "across the rays");
  }
}

TEST(CutsExactly, BySixClippingPlanes)
{
  for (const reference::Scene& scene : scenesToCut())
  {
    SceneRenderer subject(scene);
    expectMatch(subject, { turnedBox(subject) }, "a turned box");
  }
}

TEST(CutsExactly, ByAsManyClippingPlanesAsThereMayBe)
{
  SceneRenderer subject(reference::twoLevels());
  reference::Cut ball;
  for (std::size_t i = 0; i < Cutaway::MostClippingPlanes; ++i)
  {
    const double z = (2.0 * i + 1.0) / Cutaway::MostClippingPlanes - 1.0;
    const double turn = 2.399963 * i;
    const double r = std::sqrt(1.0 - z * z);
    ball.planes.push_back(
      planeAt(middleOf(subject), { r * std::cos(turn), r * std::sin(turn), z }, 7.1));
  }
  expectMatch(subject, ball, "a ball");

  ball.planes.push_back(ball.planes.front());
  reference::View view = subject.look({ 1.0, 0.0, 0.0 }, 0.0);
  view.cut = ball;
  EXPECT_THROW(subject.render(view), std::runtime_error);
  view.cut.planes.clear();
  EXPECT_GT(coverage(subject.render(view)), 0.1); // and goes on
}

TEST(CutsExactly, ByCroppingRegions)
{
  // VTK's presets: the block alone, fence, cross, both inverted; and those that part the rays most.
  const std::pair<unsigned int, const char*> regions[] = { { 0x0002000, "subvolume" },
    { 0x2ebfeba, "fence" }, { 0x5140145, "inverted fence" }, { 0x0417410, "cross" },
    { 0x7be8bef, "inverted cross" }, { 0x5555555, "every other one" }, { 0x2aaaaaa, "the others" },
    { 0x7ffdfff, "all but the block" } };
  SceneRenderer subject(reference::twoLevels());
  for (const auto& shown : regions)
  {
    expectMatch(subject, cropping(subject, shown.first), shown.second);
  }
  for (const reference::Scene& scene : { reference::anisotropic(), reference::holes() })
  {
    SceneRenderer other(scene);
    expectMatch(other, cropping(other, 0x5555555), "every other one");
  }
}

TEST(CutsExactly, ByEachCroppingRegionAlone)
{
  SceneRenderer subject(reference::twoLevels());
  subject.reconstruction = Reconstruction::Nearest;
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  for (int region = 0; region < 27; ++region)
  {
    view.cut = cropping(subject, 1u << region);
    EXPECT_GE(reference::psnr(subject.render(view), subject.renderOracle(view)), 100.0) << region;
  }
  // All of them are the whole, to the last bit, as nothing is split where both sides are shown.
  view.cut = {};
  const reference::Image whole = subject.render(view);
  view.cut = cropping(subject, 0x7ffffff);
  EXPECT_EQ(largestDifference(subject.render(view), whole), 0.0);
  view.cut.shownRegions = 0;
  EXPECT_EQ(coverage(subject.render(view)), 0.0);
}

TEST(CutsExactly, ByCroppingPlanesAnywhere)
{
  SceneRenderer subject(reference::twoLevels());
  subject.reconstruction = Reconstruction::Nearest;
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image whole = subject.render(view);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double far : { 1e3, 1e20, infinity })
  {
    view.cut = cropping(subject, 0x0002000);
    view.cut.lower = glm::dvec3(-far);
    view.cut.upper = glm::dvec3(far);
    EXPECT_EQ(largestDifference(subject.render(view), whole), 0.0) << far;
  }
  // Planes of an axis in the wrong order have nothing between them: the lower one counts.
  for (const unsigned int shown : { 0x0002000u, 0x2ebfebau, 0x5555555u })
  {
    view.cut = cropping(subject, shown);
    std::swap(view.cut.lower.x, view.cut.upper.x);
    EXPECT_GE(reference::psnr(subject.render(view), subject.renderOracle(view)), 100.0);
  }
  // Rays along axes, in the planes of others.
  for (const glm::dvec3 direction :
    { glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1) })
  {
    view = subject.look(direction, 0.0);
    view.cut = cropping(subject, 0x2ebfeba);
    EXPECT_GE(reference::psnr(subject.render(view), subject.renderOracle(view)), 50.0);
  }
}

TEST(CutsExactly, ByCroppingRegionsAndClippingPlanes)
{
  for (const reference::Scene& scene : scenesToCut())
  {
    SceneRenderer subject(scene);
    reference::Cut cut = cropping(subject, 0x2ebfeba);
    cut.planes = turnedBox(subject);
    expectMatch(subject, cut, "a fence in a turned box");
  }
}

TEST(CutsExactly, CompletedLevels)
{
  // Inside a level the completed field is the basis.
  SceneRenderer subject(reference::uniform());
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  view.cut = cropping(subject, 0x7ffdfff);
  view.cut.planes = turnedBox(subject);
  const reference::Image truth = subject.renderOracle(view);
  subject.complete();
  EXPECT_GE(reference::psnr(subject.render(view), truth), 60.0);
  EXPECT_GT(coverage(truth), 0.01);
}

TEST(CutsExactly, ThinSlices)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::anisotropic() })
  {
    EvenRenderer subject(scene.hierarchy);
    for (const Reconstruction reconstruction : { Reconstruction::Basis, Reconstruction::Nearest })
    {
      subject.reconstruction = reconstruction;
      for (const glm::dvec3 normal : { glm::dvec3(1.0, -0.8, 0.5), glm::dvec3(0.0, 0.0, 1.0) })
      {
        reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
        view.cut = slice(middleOf(subject), normal);
        const reference::Image truth = subject.renderOracle(view);
        EXPECT_GT(coverage(truth), 0.05);
        for (const Traversal traversal : traversalsOfDevice())
        {
          subject.renderer.selectTraversal(traversal);
          EXPECT_LE(largestDifference(subject.render(view), truth), 1e-5);
        }
      }
    }
  }
}

TEST(CutsExactly, WhereNothingOrAllIsCutAway)
{
  SceneRenderer subject(reference::twoLevels());
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image whole = subject.render(view);
  const glm::dvec3 normal(1.0, 0.3, 0.2);
  for (const double far : { 1e2, 1e9, 1e30, 1e200 })
  {
    view.cut = { { planeAt(middleOf(subject), normal, far) } };
    EXPECT_EQ(largestDifference(subject.render(view), whole), 0.0) << far;
    view.cut = { { planeAt(middleOf(subject), normal, -far) } };
    EXPECT_EQ(coverage(subject.render(view)), 0.0) << far;
  }
  // Rays along the plane are on one side of it.
  view = subject.look({ 0.0, 1.0, 0.0 }, 0.0);
  view.cut = { { planeAt(middleOf(subject), { 1.0, 0.0, 0.0 }, 0.3) } };
  EXPECT_GE(reference::psnr(subject.render(view), subject.renderOracle(view)), 50.0);
}

TEST(CutsExactly, BetweenTheDepthsOfGeometry)
{
  SceneRenderer subject(reference::twoLevels());
  subject.reconstruction = Reconstruction::Nearest;
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  view.cut = { turnedBox(subject) };
  const reference::Image whole = subject.render(view);
  const glm::dvec4 middle = glm::inverse(view.ndcToLogical) * glm::dvec4(middleOf(subject), 1.0);
  view.depth.assign(static_cast<std::size_t>(view.width) * view.height,
    static_cast<float>(0.5 + 0.5 * middle.z / middle.w));
  const reference::Image before = subject.render(view);
  EXPECT_GE(reference::psnr(before, subject.renderOracle(view)), 80.0); // depths are floats
  EXPECT_LT(coverage(before), 0.95 * coverage(whole));
  // What lies behind, blended under what lies before, is the whole again.
  const std::vector<float> depth = view.depth;
  View behind = subject.toView(view);
  behind.target.depth = nullptr;
  behind.target.nearDepth = depth.data();
  std::vector<glm::vec4> pixels;
  EXPECT_EQ(subject.renderer.render(behind, pixels), "");
  reference::Image both = before;
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    both.pixels[i] += (1.0 - both.pixels[i].a) * glm::dvec4(pixels[i]);
  }
  EXPECT_LE(largestDifference(both, whole), 1e-5);
}

TEST(CutsExactly, AtLogicalCoordinatesOfTwoToTheTwenty)
{
  // The same slice of the same scene there, behind 2^20 cells of nothing.
  constexpr double distance = 1 << 20;
  const reference::Scene scene = reference::twoLevels();
  EvenRenderer near(scene.hierarchy);
  EvenRenderer far(reference::repeatFarAway(scene, std::int64_t(distance)).hierarchy);
  for (const double viewAngle : { 30.0, 0.0 })
  {
    using MakeCut = std::function<reference::Cut(const glm::dvec3& middle)>;
    const MakeCut cuts[] = { [](const glm::dvec3& middle) {
                              return slice(middle, { 1.0, 0.8, 0.5 });
                            },
      [](const glm::dvec3& middle) {
        return slice(middle, { 1.0, -0.8, 0.0 });
      },
      bars };
    for (const MakeCut& cut : cuts)
    {
      reference::View view = near.look({ 1.0, 1.0, 1.0 }, viewAngle);
      view.cut = cut(middleOf(near));
      const reference::Image truth = near.renderOracle(view);
      EXPECT_GT(coverage(truth), 0.002);

      reference::View shifted = view;
      const glm::dmat4 shift = glm::translate(glm::dmat4(1.0), glm::dvec3(distance));
      shifted.ndcToLogical = shift * view.ndcToLogical;
      shifted.ndcToWorld = shift * view.ndcToWorld;
      shifted.cut = cut(middleOf(near) + distance);
      std::vector<reference::View> views{ shifted };
      if (viewAngle == 0.0)
      {
        // Rays that begin at the first of the two scenes.
        const glm::dmat4 longer =
          glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -1e5)),
            glm::dvec3(1.0, 1.0, 1e5 + 1.0));
        views.push_back(shifted);
        views.back().ndcToLogical = shifted.ndcToLogical * longer;
        views.back().ndcToWorld = shifted.ndcToWorld * longer;
      }
      for (const reference::View& there : views)
      {
        for (const Traversal traversal : traversalsOfDevice())
        {
          far.renderer.selectTraversal(traversal);
          const double largest = largestDifference(far.render(there), truth);
          std::cout << "differs by " << largest << " at 2^20\n";
          EXPECT_LE(largest, 1e-5);
        }
      }
    }
  }
}

TEST(CutsExactly, RightBehindAFaceThatIsFarAway)
{
  // 2^20 cells of nothing end at the face, and a twentieth of a cell behind it the ray does, which
  // is less than floats tell apart at that distance.
  constexpr double distance = 1 << 20;
  const reference::Scene scene = reference::twoLevels();
  EvenRenderer near(scene.hierarchy);
  EvenRenderer far(reference::repeatFarAway(scene, std::int64_t(distance)).hierarchy);
  const glm::dvec3 face(near.structure.tree.bounds.lo);
  reference::View view = near.look({ 1.0, 0.03, 0.02 }, 0.0);
  view.cut = { { planeAt(face, { -1.0, 0.0, 0.0 }, 0.05) } };
  const reference::Image truth = near.renderOracle(view);
  EXPECT_GT(coverage(truth), 0.01);

  reference::View there = view;
  const glm::dmat4 shift =
    glm::translate(glm::dmat4(1.0), glm::dvec3(distance)) * view.ndcToLogical;
  const glm::dmat4 longer = glm::scale(
    glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -1e5)), glm::dvec3(1.0, 1.0, 1e5 + 1.0));
  there.ndcToLogical = shift * longer;
  there.ndcToWorld = there.ndcToLogical;
  there.cut = { { planeAt(face + distance, { -1.0, 0.0, 0.0 }, 0.05) } };
  for (const Traversal traversal : traversalsOfDevice())
  {
    far.renderer.selectTraversal(traversal);
    const double largest = largestDifference(far.render(there), truth);
    std::cout << "differs by " << largest << " right behind a face\n";
    EXPECT_LE(largest, 1e-5);
  }
}

TEST(CutsExactly, WithTheCameraAHundredThousandDomainsAway)
{
  EvenRenderer subject(reference::twoLevels().hierarchy);
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0 * 1e-5);
  for (const glm::dvec3 normal : { glm::dvec3(1.0, -0.8, 0.5), glm::dvec3(0.0, 0.0, 1.0) })
  {
    view.cut = slice(middleOf(subject), normal);
    const double largest = largestDifference(subject.render(view), subject.renderOracle(view));
    std::cout << "differs by " << largest << " from far away\n";
    EXPECT_LE(largest, 1e-5);
  }
}

TEST(CutsExactly, WithLevelsLeftOutAndWithinATolerance)
{
  // A smooth field on three levels everywhere, of which a picture needs the coarsest alone.
  reference::Scene scene;
  scene.name = "oversampled";
  scene.hierarchy.cellWidth = { 4, 2, 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(24) } }, { 1, { Int3(0), Int3(48) } },
    { 2, { Int3(0), Int3(96) } } };
  scene.cells = reference::fillCells(scene.hierarchy,
    [](int, const Int3& cell)
    {
      const glm::dvec3 p = (glm::dvec3(cell) + 0.5) / 96.0;
      return 0.5 + 0.5 * std::sin(5.0 * p.x) * std::cos(4.0 * p.y + 3.0 * p.z);
    });
  SceneRenderer subject(scene);
  subject.setTransfer(TransferFunction(
    { { 0.0, { 0.2, 0.3, 1, 0.0 } }, { 0.5, { 1, 1, 1, 0.02 } }, { 1.0, { 1, 0.2, 0.1, 0.1 } } }));
  reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  view.cut = { { planeAt({ 40.3, 50.0, 60.0 }, { 1.0, 0.4, -0.3 }, 0.0),
    planeAt({ 40.0, 51.7, 60.0 }, { 0.0, -1.0, 0.0 }, 0.0) } };
  const reference::Image truth = subject.render(view);
  EXPECT_GT(coverage(truth), 0.05);
  subject.errorTolerance = 0.01;
  for (const Traversal traversal : traversalsOfDevice())
  {
    subject.renderer.selectTraversal(traversal);
    const reference::Image picture = subject.render(view);
    EXPECT_GE(reference::psnrOfDrawn(picture, truth), 34.0); // twice the tolerance
    EXPECT_EQ(subject.renderer.statistics().levelsLeftOut, 2);
  }
  // What was chosen is kept for the same cut, and chosen anew for another one.
  subject.render(view);
  EXPECT_EQ(subject.renderer.statistics().samplingTime, 0.0);
  view.cut.planes.pop_back();
  subject.render(view);
  EXPECT_GT(subject.renderer.statistics().samplingTime, 0.0);
}
