// SPDX-License-Identifier: BSD-3-Clause
// The device's transfer function: exact at control points, and its mean over the values between two
// is that of all of them.
#include "Core/TransferFunctions.h"
#include "Core/TransferTable.h"

#include <cmath>
#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <random>

using namespace exabricks;
using namespace exabricks::testing;

namespace
{
// As the shader does it (TransferFunction.glsl), in single precision.
struct Part
{
  layout::TransferKnot knot;
  int number;
  float share;
  float width;
};

Part findPart(const TransferTable& table, float value)
{
  const std::vector<layout::TransferKnot>& knots = table.knots;
  const float x = std::min(std::max(value, 0.0f), 1.0f) * layout::TRANSFER_BINS;
  const int i = std::min(static_cast<int>(x), layout::TRANSFER_BINS - 1);
  const layout::TransferBin& bin = table.bins[i];
  if (bin.lower.a >= 0.0f)
  {
    return { { bin.lower, bin.upper, bin.integral, bin.opaque, 0.0f }, i, x - static_cast<float>(i),
      1.0f / layout::TRANSFER_BINS };
  }
  int k = bin.integral.x;
  const auto first = knots.begin() + k;
  const auto above = std::upper_bound(first, first + bin.integral.y, value,
    [](float v, const layout::TransferKnot& knot) { return v < knot.value; });
  k = static_cast<int>(above - knots.begin()) - 1;
  const float width = knots[k + 1].value - knots[k].value;
  return { knots[k], layout::TRANSFER_BINS + k, (value - knots[k].value) / width, width };
}

glm::vec4 extinctionAt(const TransferTable& table, float value)
{
  const Part part = findPart(table, value);
  return glm::mix(part.knot.lower, part.knot.upper, part.share);
}

glm::ivec4 integralTo(const TransferTable& table, const Part& part)
{
  const glm::vec4 inside = glm::mix(part.knot.lower, part.knot.upper, 0.5f * part.share);
  return part.knot.integral + glm::ivec4(inside * (part.share * part.width / table.integralUnit));
}

glm::vec4 meanBetween(const TransferTable& table, float from, float to)
{
  const Part a = findPart(table, from);
  const Part b = findPart(table, to);
  if (a.number == b.number)
  {
    return glm::mix(b.knot.lower, b.knot.upper, 0.5f * (a.share + b.share));
  }
  return glm::vec4(integralTo(table, b) - integralTo(table, a)) *
    (table.integralUnit / (to - from));
}

bool meetsOpaque(const TransferTable& table, float from, float to)
{
  const int a = findPart(table, from).knot.opaque;
  return (a & 1) != 0 || a != findPart(table, to).knot.opaque;
}

glm::dvec4 exactExtinction(const TransferFunction& transfer, double value)
{
  const glm::dvec4 color = transfer.evaluate(value);
  return -std::log(std::max(1.0 - color.a, std::pow(2.0, -24))) *
    glm::dvec4(color.r, color.g, color.b, 1.0);
}

void expectNear(const glm::vec4& found, const glm::dvec4& expected, double relative, double value)
{
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(found[i], expected[i], relative * std::max(1.0, expected.a)) << "at " << value;
  }
}
}

TEST(TransferTable, IsExactAtControlPoints)
{
  for (std::uint32_t seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    const TransferFunction transfer = makeRandom(seed);
    const TransferTable table(transfer);
    for (const TransferFunction::Point& point : transfer.points())
    {
      if (point.value >= 0.0 && point.value <= 1.0)
      {
        expectNear(extinctionAt(table, static_cast<float>(point.value)),
          exactExtinction(transfer, point.value), 1e-6, point.value);
      }
    }
    for (const double end : { 0.0, 1.0 })
    {
      expectNear(
        extinctionAt(table, static_cast<float>(end)), exactExtinction(transfer, end), 1e-6, end);
    }
  }
}

TEST(TransferTable, IsCloseBetweenThem)
{
  for (std::uint32_t seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    const TransferFunction transfer = makeRandom(seed);
    const TransferTable table(transfer);
    std::mt19937 random(seed);
    for (int i = 0; i < 200; ++i)
    {
      const float value = static_cast<float>(random()) / 4294967296.0f;
      // Where the mean of a chord is off by 1e-3, its middle is by 1.5e-3; of the part's mean,
      // which may be twice the value.
      expectNear(extinctionAt(table, value), exactExtinction(transfer, value), 3e-4, value);
    }
  }
}

TEST(TransferTable, FollowsPointsFarOutside)
{
  const TransferFunction transfer(
    { gray(-9.0, 0.0), gray(-5.0, 0.9), gray(0.5, 0.25), gray(40.0, 0.0) });
  const TransferTable table(transfer);
  for (int i = 0; i <= 100; ++i)
  {
    const double value = i / 100.0;
    expectNear(extinctionAt(table, static_cast<float>(value)), exactExtinction(transfer, value),
      1e-5, value);
  }
}

TEST(TransferTable, WithoutPointsShowsNothing)
{
  const TransferTable table{ TransferFunction() };
  EXPECT_EQ(extinctionAt(table, 0.5f), glm::vec4(0.0f));
  EXPECT_EQ(meanBetween(table, 0.0f, 1.0f), glm::vec4(0.0f));
}

TEST(TransferTable, TakesTheMeanOfAllValuesBetweenTwo)
{
  for (std::uint32_t seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(seed);
    const TransferFunction transfer = makeRandom(seed);
    const TransferTable table(transfer);
    std::mt19937 random(seed + 1);
    for (int i = 0; i < 20; ++i)
    {
      const float from = static_cast<float>(random() % 10001) / 10000.0f;
      const float to = static_cast<float>(random() % 10001) / 10000.0f;
      if (std::abs(to - from) < 1e-4f)
      {
        continue;
      }
      const TransferFunction::Point* spoils = nullptr; // extinction without bound, or opaque
      glm::dvec4 expected(0.0);
      constexpr int samples = 20000;
      for (int s = 0; s < samples; ++s)
      {
        expected +=
          exactExtinction(transfer, glm::mix(double(from), double(to), (s + 0.5) / samples));
      }
      for (const TransferFunction::Point& point : transfer.points())
      {
        spoils = point.color.a >= 1.0 ? &point : spoils;
      }
      if (!spoils)
      {
        expectNear(meanBetween(table, from, to), expected / double(samples), 2e-3, from);
      }
    }
  }
}

TEST(TransferTable, LosesNoSpikeHoweverNarrow)
{
  for (const double width : { 1e-2, 1e-4, 1e-6 })
  {
    const TransferFunction transfer(
      { gray(0.31416 - 0.5 * width, 0.0), gray(0.31416, 0.5), gray(0.31416 + 0.5 * width, 0.0) });
    const TransferTable table(transfer);
    // Mean of -ln(1 - a) for a from 0 to 1/2, over the share that the spike has of the way.
    const double mean = 1.0 - std::log(2.0);
    EXPECT_NEAR(meanBetween(table, 0.0f, 1.0f).a / width, mean, 1e-2 * mean) << width;
    EXPECT_NEAR(meanBetween(table, 0.6f, 0.3f).a / width, mean / 0.3, 1e-2 * mean / 0.3) << width;
    EXPECT_EQ(meanBetween(table, 0.0f, 0.3f).a, 0.0f) << width;
  }
}

TEST(TransferTable, KnowsAnOpaquePartOnTheWay)
{
  const TransferFunction transfer(
    { gray(0.4, 0.0), gray(0.4, 1.0), gray(0.401, 1.0), gray(0.401, 0.0) });
  const TransferTable table(transfer);
  const float ways[][2] = { { 0.1f, 0.9f }, { 0.9f, 0.1f }, { 0.4005f, 0.9f }, { 0.4002f, 0.4006f },
    { 0.9f, 0.4001f } };
  for (const auto& way : ways)
  {
    EXPECT_TRUE(meetsOpaque(table, way[0], way[1])) << way[0] << " to " << way[1];
  }
  EXPECT_FALSE(meetsOpaque(table, 0.1f, 0.3f));
  EXPECT_FALSE(meetsOpaque(table, 0.9f, 0.5f));
  // Its colour, where it is met: not mixed with that of the way to it.
  const glm::vec4 mean = meanBetween(table, 0.1f, 0.9f);
  EXPECT_NEAR(mean.r / mean.a, 0.4005f, 1e-3f);
}

TEST(TransferTable, KeepsFaintPartsBesideDenseOnes)
{
  // Differences of integrals: what is dense elsewhere must not cost digits.
  const TransferFunction transfer(
    { gray(0.0, 0.9999), gray(0.5, 0.9999), gray(0.5, 1e-5), gray(1.0, 1e-5) });
  const TransferTable table(transfer);
  for (const float way : { 0.001f, 0.01f, 0.3f })
  {
    EXPECT_NEAR(meanBetween(table, 0.6f, 0.6f + way).a, 1e-5, 5e-6) << way;
  }
}

TEST(TransferTable, KeepsAJumpAtOneThatIsAllThereIs)
{
  const TransferTable table(TransferFunction({ gray(1.0, 0.1), gray(1.0, 0.9) }));
  EXPECT_NEAR(extinctionAt(table, 0.5f).a, -std::log(0.9f), 1e-6f);
  EXPECT_NEAR(extinctionAt(table, 1.0f).a, -std::log(0.1f), 1e-6f);
  EXPECT_NEAR(meanBetween(table, 0.5f, 1.0f).a, -std::log(0.9f), 1e-6f);
}

TEST(TransferTable, StaysSmallWhateverTheFunction)
{
  std::vector<TransferFunction::Point> teeth;
  for (int i = 0; i <= 100000; ++i)
  {
    teeth.push_back(gray(i / 100000.0, i % 2 ? 0.9 : 0.0));
  }
  const TransferTable table{ TransferFunction(teeth) };
  EXPECT_LE(table.knots.size(), 200000u);
  // Mean of -ln(1 - a) for a from 0 to 0.9.
  const double exact = (0.1 * std::log(0.1) - 0.1 + 1.0) / 0.9;
  EXPECT_NEAR(meanBetween(table, 0.1f, 0.9f).a, exact, 1e-4);
}
