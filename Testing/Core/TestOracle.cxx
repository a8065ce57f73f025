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

// A row of transparent pixels, but for the first one.
Image row(int pixels, double first)
{
  Image image{ pixels, 1, std::vector<glm::dvec4>(pixels, glm::dvec4(0.0)) };
  image.pixels[0] = glm::dvec4(first);
  return image;
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

TEST(Oracle, RendersALinearFieldWithAnOpacityRampInClosedForm)
{
  // Between the outer cell centres the value is x / 10 - 0.05, outside of them it stays.
  const Oracle oracle = makeOracle(oneBlock({ Int3(0), Int3(10, 2, 2) }),
    [](int, const Int3& c) { return 0.1 * static_cast<double>(c.x); }, { 0.0, 1.0 });
  // Opacity rises from 0 at 0.25 to 1 at 0.65, stays there for nothing, and falls to 0.2 at 0.85.
  const glm::dvec4 red(0.9, 0.3, 0.1, 0.0);
  const auto opaque = [&](double a) { return red + glm::dvec4(0.0, 0.0, 0.0, a); };
  const TransferFunction tent(
    { { 0.25, opaque(0.0) }, { 0.65, opaque(0.8) }, { 0.85, opaque(0.2) } });
  // Of -ln u, for u falling or rising along the way with `slope`.
  const auto antiderivative = [](double u) { return u - u * std::log(u); };
  const double depth = (antiderivative(1.0) - antiderivative(0.2)) / (0.8 / 4.0) +
    (antiderivative(0.8) - antiderivative(0.2)) / (0.6 / 2.0) + // to the value 0.85, x = 9
    -std::log(0.8) * 1.0;                                       // the rest of the way
  for (const double unit : { 0.03, 1.0, 7.0, 1e6 })
  {
    const double alpha = -std::expm1(-depth / unit);
    double error;
    const glm::dvec4 pixel =
      oracle.render(lookAlongX(0.7, 1.1), tent, { Reconstruction::Basis, unit }, error).at(0, 0);
    EXPECT_NEAR(pixel.a, alpha, 1e-9) << unit;
    EXPECT_NEAR(pixel.r, 0.9 * alpha, 1e-7) << unit;
    EXPECT_LE(error, 1e-7) << unit;
  }
}

TEST(Oracle, RendersALinearFieldWithAColorRampInClosedForm)
{
  const Oracle oracle = makeOracle(oneBlock({ Int3(0), Int3(10, 2, 2) }),
    [](int, const Int3& c) { return 0.1 * static_cast<double>(c.x); }, { 0.0, 1.0 });
  const TransferFunction colors(
    { { 0.0, glm::dvec4(0.0, 1.0, 0.2, 0.4) }, { 0.9, glm::dvec4(0.9, 0.1, 0.2, 0.4) } });
  // The red is the value: 0 for half a cell, then x / 10 - 0.05 up to 0.9, where it stays.
  const double k = -std::log(0.6);
  const auto integral = [k](double x) // of k (x / 10 - 0.05) exp(-k x)
  { return -std::exp(-k * x) * (0.1 * x - 0.05 + 0.1 / k); };
  const double red =
    integral(9.5) - integral(0.5) + 0.9 * (std::exp(-k * 9.5) - std::exp(-k * 10.0));
  const glm::dvec4 pixel = oracle.render(lookAlongX(0.7, 1.1), colors, {}).at(0, 0);
  EXPECT_NEAR(pixel.r, red, 1e-9);
  EXPECT_NEAR(pixel.g, 1.0 * pixel.a - red, 1e-9); // green is 1 - red
  EXPECT_NEAR(pixel.a, -std::expm1(-10.0 * k), 1e-12);
}

TEST(Oracle, FindsAJumpOnTheWay)
{
  // The value is 0.43 at x = 4.8: from there on 0.5 of opacity.
  const Oracle oracle = makeOracle(oneBlock({ Int3(0), Int3(10, 2, 2) }),
    [](int, const Int3& c) { return 0.1 * static_cast<double>(c.x); }, { 0.0, 1.0 });
  const TransferFunction jump({ { 0.43, glm::dvec4(0.0) }, { 0.43, glm::dvec4(0.5) } });
  const Image image = oracle.render(lookAlongX(0.7, 1.1), jump, {});
  EXPECT_NEAR(image.at(0, 0).a, opacity(0.5, 10.0 - 4.8, 1.0), 1e-12);
}

TEST(Oracle, BecomesOpaqueWhereTheOpacityReachesOne)
{
  // An integrable singularity of the extinction, then a plateau of opacity 1: its front shows.
  const Oracle oracle = makeOracle(oneBlock({ Int3(0), Int3(10, 2, 2) }),
    [](int, const Int3& c) { return 0.1 * static_cast<double>(c.x); }, { 0.0, 1.0 });
  const auto green = [](double g, double a) { return glm::dvec4(0.0, g, 0.0, a); };
  const TransferFunction rising(
    { { 0.2, green(1.0, 0.0) }, { 0.4, green(1.0, 1.0) }, { 0.7, green(0.0, 1.0) } });
  const glm::dvec4 pixel = oracle.render(lookAlongX(0.7, 1.1), rising, {}).at(0, 0);
  EXPECT_NEAR(pixel.a, 1.0, 1e-12);
  EXPECT_NEAR(pixel.g, 1.0, 1e-9);
  // seen from the other side: 0.5 cells of 0.9, which is opaque and black
  View back = lookAlongX(0.7, 1.1);
  back.ndcToLogical[2] = back.ndcToWorld[2] = glm::dvec4(-100.0, 0.0, 0.0, 0.0);
  EXPECT_NEAR(oracle.render(back, rising, {}).at(0, 0).g, 0.0, 1e-12);
}

TEST(Oracle, RendersTheBasisAcrossTwoLevelsInClosedForm)
{
  // Coarse cells of value 0 up to x = 8, fine ones of value 1 from there: only x decides.
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(4) } }, { 1, { Int3(8, 0, 0), Int3(16, 8, 8) } } };
  const Oracle oracle = makeOracle(
    hierarchy, [](int level, const Int3&) { return static_cast<double>(level); }, { 0.0, 1.0 });
  constexpr double most = 0.6;
  const TransferFunction opacityOnly(
    { { 0.0, glm::dvec4(1.0, 1.0, 1.0, 0.0) }, { 1.0, glm::dvec4(1.0, 1.0, 1.0, most) } });
  // The last coarse tent falls from 1 at x = 7 to 0 at 9, the first fine one rises from 0 at 7.5 to
  // 1 at 8.5, where others take over. B = fine / (coarse + fine), and 1 - most B is a quotient of
  // linear functions: u ln u - u for each.
  const auto integralOfLog = [](double x0, double u0, double x1, double u1)
  {
    const auto f = [](double u) { return u > 0.0 ? u * std::log(u) - u : 0.0; };
    return u0 == u1 ? (x1 - x0) * std::log(u0) : (f(u1) - f(u0)) * (x1 - x0) / (u1 - u0);
  };
  // -ln(1 - most B) from x0 to x1, with the tents' values at the ends
  const auto depth =
    [&](double x0, double coarse0, double fine0, double x1, double coarse1, double fine1)
  {
    return integralOfLog(x0, coarse0 + fine0, x1, coarse1 + fine1) -
      integralOfLog(x0, coarse0 + (1.0 - most) * fine0, x1, coarse1 + (1.0 - most) * fine1);
  };
  const double total = depth(7.5, 0.75, 0.0, 8.5, 0.25, 1.0) +
    depth(8.5, 0.25, 1.0, 9.0, 0.0, 1.0) + -std::log(1.0 - most) * 7.0;
  const double unit = 20.0;
  const Image image =
    oracle.render(lookAlongX(3.3, 4.1), opacityOnly, { Reconstruction::Basis, unit });
  EXPECT_NEAR(image.at(0, 0).a, -std::expm1(-total / unit), 1e-9);
}

TEST(Oracle, RendersRandomScenesLikeAFineQuadrature)
{
  // Independent of the splitting: the field point by point, through all levels, holes and NaN.
  for (std::uint32_t seed = 0; seed < 12; ++seed)
  {
    const Scene scene = randomScene(seed);
    const LeafBoxes leaves = findLeafBoxes(scene.hierarchy);
    const Oracle oracle(scene.hierarchy, leaves, scene.cells);
    const View view = lookAt(scene.hierarchy, leaves.bounds, { 1.0, 0.3, -0.7 }, 0.0, 3, 3);
    for (const Reconstruction reconstruction : both)
    {
      const Image image = oracle.render(view, ramp, { reconstruction, 3.0 });
      for (int pixel = 0; pixel < 9; ++pixel)
      {
        const glm::dvec2 ndc(2.0 / 3.0 * (pixel % 3 - 1), 2.0 / 3.0 * (pixel / 3 - 1));
        const glm::dvec3 begin(view.ndcToLogical * glm::dvec4(ndc, -1.0, 1.0));
        const glm::dvec3 end(view.ndcToLogical * glm::dvec4(ndc, 1.0, 1.0));
        constexpr int steps = 20000;
        const double step = glm::distance(begin, end) / steps; // spacing 1
        glm::dvec4 expected(0.0);
        for (int i = 0; i < steps; ++i)
        {
          if (const auto value =
                oracle.sample(glm::mix(begin, end, (i + 0.5) / steps), reconstruction))
          {
            const glm::dvec4 color = ramp.evaluate(*value);
            const double alpha = (1.0 - expected.a) * opacity(color.a, step, 3.0);
            expected += alpha * glm::dvec4(color.r, color.g, color.b, 1.0);
          }
        }
        const glm::dvec4& found = image.at(pixel % 3, pixel / 3);
        for (int i = 0; i < 4; ++i)
        {
          EXPECT_NEAR(found[i], expected[i], 1e-3) << scene.name; // a face is met to a step
        }
      }
    }
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

TEST(Oracle, KeepsToItsTolerance)
{
  for (const Scene& scene : allScenes())
  {
    const LeafBoxes leaves = findLeafBoxes(scene.hierarchy);
    const Oracle oracle(scene.hierarchy, leaves, scene.cells);
    const View view = lookAt(scene.hierarchy, leaves.bounds, { 1.0, 2.0, -0.7 }, 30.0, 16, 16);
    double error;
    const Image exact = oracle.render(view, ramp, { Reconstruction::Basis, 4.0, 1e-12 }, error);
    EXPECT_LE(error, 1e-12) << scene.name;
    for (const double tolerance : { 1e-7, 1e-3 })
    {
      const Image image =
        oracle.render(view, ramp, { Reconstruction::Basis, 4.0, tolerance }, error);
      EXPECT_LE(error, tolerance) << scene.name;
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
      {
        const glm::dvec4 difference = glm::abs(image.pixels[i] - exact.pixels[i]);
        EXPECT_LE(std::max({ difference.r, difference.g, difference.b, difference.a }), tolerance);
      }
    }
  }
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
  EXPECT_EQ(psnr(row(1, 0.0), row(1, 0.0)), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(psnr(row(1, 0.0), row(1, 0.1)), 20.0, 1e-12);
  // Pixels that show nothing make a picture look better than it is.
  EXPECT_NEAR(psnr(row(100, 0.0), row(100, 0.1)), 40.0, 1e-12);
  EXPECT_NEAR(psnrOfDrawn(row(100, 0.0), row(100, 0.1)), 20.0, 1e-12);
}
