// SPDX-License-Identifier: BSD-3-Clause
// Completed across levels: the layers hold what Testing/Accuracy/Candidates computes, pictures are
// those of its field, and linear fields and constants come out as they are.
#include "SceneRenderer.h"
#include "Traversals.h"

#include "Accuracy/PictureAccuracy.h"

#include <gtest/gtest.h>
#include <iostream>

#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

using namespace exabricks;
using namespace exabricks::accuracy;

namespace
{
reference::Scene makeScene(const Grid& grid, const Field& field)
{
  return { field.name, grid.hierarchy,
    reference::fillCells(grid.hierarchy, atCenters(grid, field)) };
}

// What the device computes, in double precision from the layers of some bricks; NaN: nothing.
template <typename List>
double sampleLayers(const SceneRenderer& subject, const glm::dvec3& logical, const List& list)
{
  double sum = 0.0;
  double weight = 0.0;
  for (const std::uint32_t b : list)
  {
    const Brick& brick = subject.structure.bricks[b];
    const double width = static_cast<double>(subject.structure.width(brick));
    const glm::dvec3 q = (logical - glm::dvec3(brick.lo)) / width - 0.5;
    const glm::ivec3 base(glm::floor(q));
    if (glm::any(glm::lessThan(base, glm::ivec3(-1))) ||
      glm::any(glm::greaterThanEqual(base, brick.cells)))
    {
      continue;
    }
    double values = 0.0;
    double tents = 0.0;
    double own = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 off(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      const glm::ivec3 cell = base + off;
      const glm::dvec3 f = q - glm::dvec3(base);
      const glm::dvec3 part = glm::mix(1.0 - f, f, glm::dvec3(off));
      const double tent = part.x * part.y * part.z;
      const glm::ivec3 at = cell + 1;
      const double value = subject.completed->ofBrick(
        b)[at.x + (brick.cells.x + 2) * (at.y + (brick.cells.y + 2) * at.z)];
      if (value >= 0.0)
      {
        values += tent * value;
        tents += tent;
        own += glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) &&
            glm::all(glm::lessThan(cell, brick.cells))
          ? tent
          : 0.0;
      }
    }
    if (own > 0.0)
    {
      sum += own * values / tents;
      weight += own;
    }
  }
  return weight > 0.0 ? sum / weight : std::numeric_limits<double>::quiet_NaN();
}

double sampleLayers(const SceneRenderer& subject, const glm::dvec3& logical)
{
  std::vector<std::uint32_t> all(subject.structure.bricks.size());
  std::iota(all.begin(), all.end(), 0u);
  return sampleLayers(subject, logical, all);
}

// The renderer's view of the unit cube as renderField sees it.
reference::View lookAtCube(const Grid& grid, int pixels)
{
  Hierarchy cube;
  reference::View view =
    reference::lookAt(cube, { Int3(0), Int3(1) }, { 1.0, 0.7, -0.4 }, 0.0, pixels, pixels);
  view.ndcToLogical =
    glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / grid.cellShare)) * view.ndcToWorld;
  return view;
}

// For values normalised to the range.
TransferFunction normalized(const TransferFunction& transfer, const Range& range)
{
  std::vector<TransferFunction::Point> points = transfer.points();
  for (TransferFunction::Point& point : points)
  {
    point.value = range.normalize(point.value);
  }
  return TransferFunction(points);
}

struct Named
{
  const char* name;
  Grid grid;
};
std::vector<Named> allGrids()
{
  const reference::Scene mixed = reference::mixedRatios();
  const Grid threeThenTwo{ mixed.hierarchy, findLeafBoxes(mixed.hierarchy), 12, 1.0 / 72 };
  return { { "one level", makeBoxGrid(1, 16) }, { "ratio 2", makeBoxGrid(2, 8) },
    { "ratio 3", makeBoxGrid(3, 8) }, { "ratio 4", makeBoxGrid(4, 8) },
    { "shell", makeShellGrid({ 2 }, 16) }, { "shell, 3 levels", makeShellGrid({ 2, 2 }, 16) },
    { "shell, ratio 4, then 2", makeShellGrid({ 4, 2 }, 8) },
    { "shell, ratio 3, then 2", threeThenTwo } };
}
}

TEST(CompletesLevels, TheLayersHoldWhatTheCandidateComputes)
{
  for (const Field& field : { linear({ 0.3, 0.2, 0.35 }), shellAndBlobs() })
  {
    for (const Named& named : allGrids())
    {
      SceneRenderer subject(makeScene(named.grid, field));
      subject.complete();
      const Sampler sampler(named.grid, field);
      const Range range = subject.plain.values->range;
      double largest = 0.0;
      for (int n = 0; n < 4000; ++n)
      {
        const glm::dvec3 p(reference::noise(0, Int3(n), 1), reference::noise(1, Int3(n), 1),
          reference::noise(2, Int3(n), 1));
        const double expected =
          range.normalize(*sampler.sample(p / named.grid.cellShare, Method::Completed));
        largest =
          std::max(largest, std::abs(sampleLayers(subject, p / named.grid.cellShare) - expected));
      }
      std::cout << field.name << ", " << named.name << ": " << largest << "\n";
      EXPECT_LT(largest, 1e-6) << field.name << ", " << named.name;
    }
  }
}

TEST(CompletesLevels, PicturesAreThoseOfTheCandidate)
{
  PictureSettings settings;
  settings.pixels = 48;
  settings.step = 1.0 / 1024;
  const Field field = shellAndBlobs();
  for (const Named& named : allGrids())
  {
    SceneRenderer subject(makeScene(named.grid, field));
    subject.setTransfer(normalized(rampTransfer(), subject.plain.values->range));
    subject.complete();
    subject.opacityUnitDistance = settings.unitDistance;
    subject.stepScale = 0.125;
    const Sampler sampler(named.grid, field);
    const reference::Image truth = renderField([&](const glm::dvec3& p)
      { return *sampler.sample(p / named.grid.cellShare, Method::Completed); },
      rampTransfer(), settings);
    for (const Traversal traversal : traversalsOfDevice())
    {
      subject.renderer.selectTraversal(traversal);
      const double quality =
        reference::psnr(subject.render(lookAtCube(named.grid, settings.pixels)), truth);
      std::cout << named.name << ": " << quality << " dB\n";
      EXPECT_GE(quality, 60.0) << named.name;
    }
  }
}

TEST(CompletesLevels, InsideALevelPicturesAreThoseOfTheBasis)
{
  SceneRenderer basis(reference::uniform());
  SceneRenderer subject(reference::uniform());
  subject.complete();
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  EXPECT_LT(largestDifference(subject.render(view), basis.render(view)), 1e-6);
}

TEST(CompletesLevels, ConstantsAreExact)
{
  const TransferFunction transfer({ { 0.0, glm::dvec4(1.0, 0.5, 0.0, 0.04) } });
  for (const Named& named : allGrids())
  {
    SceneRenderer subject(makeScene(named.grid, constant(0.7)));
    subject.complete();
    for (const float value : subject.completed->normalized)
    {
      ASSERT_EQ(value, 0.0f);
    }
    subject.setTransfer(transfer);
    SceneRenderer basis(makeScene(named.grid, constant(0.7)));
    basis.setTransfer(transfer);
    const reference::View view = lookAtCube(named.grid, 48);
    EXPECT_EQ(largestDifference(subject.render(view), basis.render(view)), 0.0) << named.name;
  }
}

// A linear field with an extinction linear in its values: the optical depth of a ray is that of the
// value in the middle of its way. Rays keep away from the bounds of the data, where values stay.
TEST(CompletesLevels, LinearFieldsAreExactAcrossLevels)
{
  const Field field = linear({ 0.3, 0.2, 0.35 });
  for (const Named& named : allGrids())
  {
    for (const bool completed : { false, true })
    {
      SceneRenderer subject(makeScene(named.grid, field));
      // Extinction is piecewise linear between many control points of its opacity.
      std::vector<TransferFunction::Point> points;
      const auto extinction = [](double normalizedValue) { return 0.02 + 0.5 * normalizedValue; };
      for (int i = 0; i <= 256; ++i)
      {
        const double value = i / 256.0;
        points.push_back({ value, glm::dvec4(1.0, 1.0, 1.0, 1.0 - std::exp(-extinction(value))) });
      }
      subject.setTransfer(TransferFunction(points));
      if (completed)
      {
        subject.complete();
      }
      subject.opacityUnitDistance = 0.2;
      const double coarse = 0.5 * named.grid.coarseWidth();
      reference::View view = lookAtCube(named.grid, 64);
      double largest = 0.0;
      int rays = 0;
      // near and far plane at the ends of what is measured, ray by ray the same
      const glm::dmat4 toCube = view.ndcToWorld;
      const glm::dvec3 near = glm::dvec3(toCube * glm::dvec4(0.0, 0.0, -1.0, 1.0));
      const glm::dvec3 far = glm::dvec3(toCube * glm::dvec4(0.0, 0.0, 1.0, 1.0));
      const double length = glm::distance(near, far);
      const double half = 0.3 / length; // a length of 0.6 through the middle
      const glm::dmat4 part = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, 2.0 * half));
      view.ndcToLogical = view.ndcToLogical * part;
      view.ndcToWorld = view.ndcToWorld * part;
      const reference::Image image = subject.render(view);
      for (int y = 0; y < view.height; ++y)
      {
        for (int x = 0; x < view.width; ++x)
        {
          const glm::dvec2 ndc(
            2.0 * (x + 0.5) / view.width - 1.0, 2.0 * (y + 0.5) / view.height - 1.0);
          const glm::dvec3 a(view.ndcToWorld * glm::dvec4(ndc, -1.0, 1.0));
          const glm::dvec3 b(view.ndcToWorld * glm::dvec4(ndc, 1.0, 1.0));
          if (glm::any(glm::lessThan(glm::min(a, b), glm::dvec3(coarse))) ||
            glm::any(glm::greaterThan(glm::max(a, b), glm::dvec3(1.0 - coarse))))
          {
            continue;
          }
          const double value = subject.plain.values->range.normalize(field.value(0.5 * (a + b)));
          const double depth =
            extinction(value) * glm::distance(a, b) / subject.opacityUnitDistance;
          const double found = -std::log1p(-image.at(x, y).a);
          largest = std::max(largest, std::abs(found / depth - 1.0));
          ++rays;
        }
      }
      std::cout << named.name << (completed ? ", completed" : ", basis")
                << ": greatest relative deviation " << largest << " of " << rays << " rays\n";
      EXPECT_GT(rays, 300);
      if (completed)
      {
        EXPECT_LT(largest, 2e-5) << named.name; // float32
      }
      else if (named.grid.hierarchy.levels() > 1)
      {
        EXPECT_GT(largest, 5e-3) << named.name; // which is what it is for
      }
    }
  }
}

TEST(CompletesLevels, TraversalsAgreeAndAbsentCellsStayAbsent)
{
  for (const reference::Scene& scene : reference::allScenes())
  {
    SceneRenderer basis(scene);
    SceneRenderer subject(scene);
    subject.complete();
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
    subject.renderer.selectTraversal(Traversal::KdTree);
    const reference::Image byTree = subject.render(view);
    for (const Traversal traversal : traversalsOfDevice())
    {
      subject.renderer.selectTraversal(traversal);
      EXPECT_LT(largestDifference(byTree, subject.render(view)), 1e-4) << scene.name;
    }
    const reference::Image other = basis.render(view);
    std::cout << scene.name << ": " << reference::psnr(byTree, other)
              << " dB to the basis, coverage " << coverage(byTree) << " and " << coverage(other)
              << "\n";
    EXPECT_GE(reference::psnr(byTree, other), 25.0) << scene.name;
    // something everywhere: exactly where the basis is
    const TransferFunction white({ { 0.0, glm::dvec4(1.0, 1.0, 1.0, 0.5) } });
    basis.setTransfer(white);
    subject.setTransfer(white);
    const double difference = largestDifference(subject.render(view), basis.render(view));
    std::cout << scene.name << ", white: " << difference << "\n";
    EXPECT_LT(difference, 2e-3) << scene.name;
  }
}

TEST(CompletesLevels, BricksOfALevelAgree)
{
  for (std::uint32_t seed = 0; seed < 60; ++seed)
  {
    SceneRenderer subject(reference::randomScene(seed));
    subject.complete();
    std::map<std::tuple<int, std::int64_t, std::int64_t, std::int64_t>, float> values;
    const float* value = subject.completed->normalized.data();
    for (const Brick& brick : subject.structure.bricks)
    {
      const Int3 first = brick.lo / subject.structure.width(brick);
      glm::ivec3 c;
      for (c.z = -1; c.z <= brick.cells.z; ++c.z)
      {
        for (c.y = -1; c.y <= brick.cells.y; ++c.y)
        {
          for (c.x = -1; c.x <= brick.cells.x; ++c.x)
          {
            const Int3 at = first + Int3(c);
            const auto found =
              values.emplace(std::make_tuple(brick.level, at.x, at.y, at.z), *value);
            EXPECT_NEAR(found.first->second, *value, 1e-6) << seed;
            ++value;
          }
        }
      }
    }
  }
}

TEST(CompletesLevels, RegionsHaveTheirBricksAndRanges)
{
  for (std::uint32_t seed = 0; seed < 60; ++seed)
  {
    SceneRenderer subject(reference::randomScene(seed));
    subject.complete();
    const RegionTree& tree = subject.structure.tree;
    const ValueRanges& ranges = subject.completed->ranges;
    for (int n = 0; n < 300; ++n)
    {
      const glm::dvec3 half = glm::dvec3(tree.size) *
        glm::dvec3(reference::noise(0, Int3(n), seed), reference::noise(1, Int3(n), seed),
          reference::noise(2, Int3(n), seed));
      const glm::dvec3 p = glm::dvec3(tree.bounds.lo) + 0.5 * half;
      std::size_t r = 0;
      while (r < tree.regions.size() &&
        (glm::any(glm::lessThan(half, glm::dvec3(tree.regions[r].lo))) ||
          glm::any(glm::greaterThanEqual(half, glm::dvec3(tree.regions[r].hi)))))
      {
        ++r;
      }
      ASSERT_LT(r, tree.regions.size());
      const layout::Region& region = tree.regions[r];
      if (region.brickCount == 0)
      {
        continue;
      }
      const std::uint32_t* first = tree.brickLists.data() + region.firstBrick;
      const std::vector<std::uint32_t> list(first, first + region.brickCount);
      const double value = sampleLayers(subject, p, list);
      const double expected = sampleLayers(subject, p);
      EXPECT_TRUE(std::abs(value - expected) < 1e-6 || std::isnan(expected)) << seed;
      if (!std::isnan(value))
      {
        EXPECT_GE(value, ranges.regions[r].min - 1e-6) << seed;
        EXPECT_LE(value, ranges.regions[r].max + 1e-6) << seed;
      }
    }
  }
}
