// SPDX-License-Identifier: BSD-3-Clause
// The reference renderer against pictures known in closed form.
#include "Core/Structures.h"
#include "Reference/Oracle.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

using namespace exabricks;
using namespace exabricks::testing;
using namespace exabricks::reference;

namespace
{
constexpr Reconstruction both[] = { Reconstruction::Basis, Reconstruction::Nearest };

Box cube(int lo, int hi) { return { Int3(lo), Int3(hi) }; }

Hierarchy oneBlock(const Box& cells)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  hierarchy.blocks = { { 0, cells } };
  return hierarchy;
}

Oracle makeOracle(const Hierarchy& hierarchy, const CellField& field, const Range& range)
{
  return Oracle(hierarchy, findLeafBoxes(hierarchy), fillCells(hierarchy, field), range);
}

// One pixel that looks along x through logical (y, z), from x = -100 to x = 100.
View lookAlongX(double y, double z)
{
  View view;
  view.width = view.height = 1;
  view.ndcToLogical = glm::dmat4(0.0);
  view.ndcToLogical[2] = glm::dvec4(100.0, 0.0, 0.0, 0.0);
  view.ndcToLogical[3] = glm::dvec4(0.0, y, z, 1.0);
  view.ndcToWorld = view.ndcToLogical;
  return view;
}

TransferFunction constant(double red, double opacity)
{
  return TransferFunction({ { 0.0, glm::dvec4(red, 0.5, 0.25, opacity) } });
}

const TransferFunction ramp(
  { { 0.0, glm::dvec4(0.0, 0.0, 1.0, 0.0) }, { 1.0, glm::dvec4(1.0, 0.5, 0.0, 0.6) } });

double opacity(double perUnit, double length, double unit)
{
  return 1.0 - std::pow(1.0 - perUnit, length / unit);
}
}

TEST(Oracle, SamplesALinearFieldOfOneLevelExactly)
{
  const Oracle oracle = makeOracle(oneBlock(cube(-4, 4)),
    [](int, const Int3& c) { return 1.0 * c.x + 2.0 * c.y + 3.0 * c.z; }, { 0.0, 1.0 });
  // a cell's value stands at its centre
  EXPECT_NEAR(*oracle.sample({ 1.0, -0.7, 2.2 }, Reconstruction::Basis),
    (1.0 - 0.5) + 2.0 * (-0.7 - 0.5) + 3.0 * (2.2 - 0.5), 1e-12);
  EXPECT_EQ(*oracle.sample({ 1.0, -0.7, 2.2 }, Reconstruction::Nearest), 1.0 - 2.0 + 6.0);
}

TEST(Oracle, WeighsTheTentsOfTwoLevels)
{
  // Along x: a coarse cell [0, 2) of value 0, then fine ones of value 1 from 2 on.
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, cube(0, 1) }, { 1, { Int3(2, 0, 0), Int3(4, 2, 2) } } };
  const Oracle oracle = makeOracle(
    hierarchy, [](int level, const Int3&) { return static_cast<double>(level); }, { 0.0, 1.0 });
  // At (2.25, 1, 1) the coarse tent is 1 - 1.25 / 2; the four fine cells around weigh 0.75 / 4
  // each.
  const double coarse = 0.375;
  const double fine = 0.75;
  EXPECT_NEAR(
    *oracle.sample({ 2.25, 1.0, 1.0 }, Reconstruction::Basis), fine / (coarse + fine), 1e-14);
  EXPECT_EQ(*oracle.sample({ 1.9, 1.0, 1.0 }, Reconstruction::Nearest), 0.0);
}

TEST(Oracle, ShowsNothingOutsideInHolesAndInAbsentCells)
{
  Hierarchy hierarchy = oneBlock(cube(0, 2));
  hierarchy.blocks.push_back({ 0, cube(3, 5) });
  const Oracle oracle = makeOracle(hierarchy,
    [](int, const Int3& c)
    { return c == Int3(1) ? std::numeric_limits<double>::quiet_NaN() : 1.0; },
    { 0.0, 1.0 });
  for (const Reconstruction reconstruction : both)
  {
    EXPECT_FALSE(oracle.sample({ -0.1, 1.0, 1.0 }, reconstruction));
    EXPECT_FALSE(oracle.sample({ 2.5, 2.5, 2.5 }, reconstruction));
    EXPECT_FALSE(oracle.sample({ 1.5, 1.5, 1.5 }, reconstruction));
    EXPECT_EQ(*oracle.sample({ 0.99, 1.5, 1.5 }, reconstruction), 1.0);
  }
}

TEST(Oracle, RendersAConstantFieldInClosedForm)
{
  Hierarchy hierarchy = oneBlock({ Int3(0), Int3(10, 4, 4) });
  const Oracle oracle = makeOracle(hierarchy, [](int, const Int3&) { return 0.5; }, { 0.0, 1.0 });
  for (const Reconstruction reconstruction : both)
  {
    const Image image =
      oracle.render(lookAlongX(1.3, 2.6), constant(0.8, 0.3), { reconstruction, 4.0 });
    const double alpha = opacity(0.3, 10.0, 4.0);
    EXPECT_NEAR(image.at(0, 0).a, alpha, 1e-12);
    EXPECT_NEAR(image.at(0, 0).r, 0.8 * alpha, 1e-12); // premultiplied
    EXPECT_NEAR(image.at(0, 0).b, 0.25 * alpha, 1e-12);
  }
}

TEST(Oracle, MeasuresLengthsInTheWorld)
{
  Hierarchy hierarchy = oneBlock(cube(0, 4));
  hierarchy.origin = glm::dvec3(5.0, -3.0, 1.0);
  hierarchy.spacing = glm::dvec3(1.0, 1.0, 2.0);
  const Oracle oracle = makeOracle(hierarchy, [](int, const Int3&) { return 0.5; }, { 0.0, 1.0 });
  const View view = lookAt(hierarchy, cube(0, 4), { 0.0, 0.0, 1.0 }, 0.0, 3, 3);
  const Image image = oracle.render(view, constant(1.0, 0.1), {});
  EXPECT_NEAR(image.at(1, 1).a, opacity(0.1, 8.0, 1.0), 1e-12);
}

TEST(Oracle, RendersASlabInClosedForm)
{
  // Cells 3 to 5 of 10 are visible, the rest is not.
  const Oracle oracle = makeOracle(oneBlock({ Int3(0), Int3(10, 2, 2) }),
    [](int, const Int3& c) { return c.x >= 3 && c.x < 6 ? 1.0 : 0.0; }, { 0.0, 1.0 });
  const TransferFunction step(
    { { 0.5, glm::dvec4(0.0) }, { 0.5, glm::dvec4(1.0, 1.0, 1.0, 0.2) } });
  const View view = lookAlongX(1.0, 1.0);
  EXPECT_NEAR(oracle.render(view, step, { Reconstruction::Nearest, 1.0 }).at(0, 0).a,
    opacity(0.2, 3.0, 1.0), 1e-12);
  // The basis passes 1/2 on the cells' faces, too.
  EXPECT_NEAR(oracle.render(view, step, { Reconstruction::Basis, 1.0 }).at(0, 0).a,
    opacity(0.2, 3.0, 1.0), 1e-12);
}

TEST(Oracle, RendersALinearFieldLikeAFineQuadrature)
{
  // Between the outer cell centres the value is x / 10 - 0.05, outside of them it stays.
  const Oracle oracle = makeOracle(oneBlock({ Int3(0), Int3(10, 2, 2) }),
    [](int, const Int3& c) { return 0.1 * static_cast<double>(c.x); }, { 0.0, 1.0 });
  const auto extinction = [](double x)
  { return -std::log(1.0 - 0.6 * (0.1 * (glm::clamp(x, 0.5, 9.5) - 0.5))); };
  glm::dvec4 expected(0.0);
  double depth = 0.0; // optical
  constexpr int steps = 100000;
  for (int i = 0; i < steps; ++i)
  {
    const double x = 10.0 * (i + 0.5) / steps;
    const double share = std::exp(-depth) * -std::expm1(-extinction(x) * 10.0 / steps);
    const double value = 0.1 * (glm::clamp(x, 0.5, 9.5) - 0.5);
    expected += share * glm::dvec4(value, 0.5 * value, 1.0 - value, 1.0);
    depth += extinction(x) * 10.0 / steps;
  }
  const Image image = oracle.render(lookAlongX(0.7, 1.1), ramp, {});
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(image.at(0, 0)[i], expected[i], 2e-5);
  }
}

TEST(Oracle, RendersTwoLevelsCellByCell)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(3, 2, 2) } }, { 1, cube(2, 4) } };
  const Oracle oracle = makeOracle(
    hierarchy, [](int level, const Int3&) { return static_cast<double>(level); }, { 0.0, 1.0 });
  const TransferFunction transfer(
    { { 0.0, glm::dvec4(1.0, 0.0, 0.0, 0.1) }, { 1.0, glm::dvec4(0.0, 1.0, 0.0, 0.4) } });
  // 2 coarse, 2 fine, 2 coarse
  const Image image =
    oracle.render(lookAlongX(2.5, 3.5), transfer, { Reconstruction::Nearest, 1.0 });
  const double coarse = 1.0 - 0.9 * 0.9;
  const double fine = 1.0 - 0.6 * 0.6;
  EXPECT_NEAR(image.at(0, 0).r, coarse + 0.81 * 0.36 * coarse, 1e-12);
  EXPECT_NEAR(image.at(0, 0).g, 0.81 * fine, 1e-12);
  EXPECT_NEAR(image.at(0, 0).a, 1.0 - 0.81 * 0.36 * 0.81, 1e-12);
}

TEST(Oracle, EndsRaysAtTheDepthBuffer)
{
  const Oracle oracle = makeOracle(
    oneBlock({ Int3(0), Int3(10, 2, 2) }), [](int, const Int3&) { return 0.5; }, { 0.0, 1.0 });
  View view = lookAlongX(1.0, 1.0);
  view.depth = { 0.515625f }; // x = 200 d - 100 = 3.125
  EXPECT_NEAR(
    oracle.render(view, constant(1.0, 0.3), {}).at(0, 0).a, opacity(0.3, 3.125, 1.0), 1e-12);
}

TEST(Oracle, ConvergesWithTheSquareOfTheStep)
{
  const Scene scene = twoLevels();
  const LeafBoxes leaves = findLeafBoxes(scene.hierarchy);
  const Oracle oracle(scene.hierarchy, leaves, scene.cells);
  const View view = lookAt(scene.hierarchy, leaves.bounds, { 1.0, 2.0, -0.7 }, 30.0, 24, 24);
  const Image exact = oracle.render(view, ramp, { Reconstruction::Basis, 4.0, 1.0 / 64.0 });
  const double coarse =
    psnr(exact, oracle.render(view, ramp, { Reconstruction::Basis, 4.0, 1.0 / 2.0 }));
  const double fine =
    psnr(exact, oracle.render(view, ramp, { Reconstruction::Basis, 4.0, 1.0 / 8.0 }));
  EXPECT_GT(coarse, 50.0);
  EXPECT_GT(fine, coarse + 20.0); // a quarter of the step: 24 dB
}

TEST(View, HoldsAllOfTheBounds)
{
  const Hierarchy hierarchy = anisotropic().hierarchy;
  const Box bounds = boundsOf(hierarchy);
  for (const double angle : { 0.0, 30.0, 90.0 })
  {
    for (const int width : { 16, 32 })
    {
      const View view = lookAt(hierarchy, bounds, { 1.0, -1.0, 0.5 }, angle, width, 48 - width);
      forEachPoint(cube(0, 2),
        [&](const Int3& corner)
        {
          const glm::dvec3 logical(bounds.lo + corner * bounds.size());
          const glm::dvec4 clip = glm::inverse(view.ndcToLogical) * glm::dvec4(logical, 1.0);
          const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
          EXPECT_LE(std::max({ std::abs(ndc.x), std::abs(ndc.y), std::abs(ndc.z) }), 1.0 + 1e-12);
        });
      // and both matrices agree on where a point is
      const glm::dvec4 ndc(0.3, -0.2, 0.7, 1.0);
      const glm::dvec4 logical = view.ndcToLogical * ndc;
      const glm::dvec4 world = view.ndcToWorld * ndc;
      EXPECT_LT(
        glm::distance(glm::dvec3(world) / world.w,
          glm::dvec3(logicalToWorld(hierarchy) * glm::dvec4(glm::dvec3(logical) / logical.w, 1.0))),
        1e-9);
    }
  }
}

TEST(Oracle, MeasuresNoiseInDecibels)
{
  Image a;
  a.width = a.height = 1;
  a.pixels = { glm::dvec4(0.0) };
  Image b = a;
  EXPECT_EQ(psnr(a, b), std::numeric_limits<double>::infinity());
  b.pixels[0] = glm::dvec4(0.1);
  EXPECT_NEAR(psnr(a, b), 20.0, 1e-12);
}
