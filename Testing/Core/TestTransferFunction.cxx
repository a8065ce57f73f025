// SPDX-License-Identifier: BSD-3-Clause
// The transfer function is exact at its control points, and loses no part that can be seen.
#include "Core/TransferFunctions.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace exabricks;
using namespace exabricks::testing;

TEST(TransferFunction, IsExactAtItsControlPoints)
{
  const TransferFunction transfer({ gray(0.1, 0.2), gray(0.1000001, 0.9), gray(0.7, 0.3) });
  for (const TransferFunction::Point& point : transfer.points())
  {
    EXPECT_EQ(transfer.evaluate(point.value), point.color);
  }
}

TEST(TransferFunction, IsLinearBetweenThem)
{
  const TransferFunction transfer({ gray(0.0, 0.0), gray(0.5, 1.0) });
  EXPECT_DOUBLE_EQ(transfer.evaluate(0.125).a, 0.25);
  EXPECT_DOUBLE_EQ(transfer.evaluate(0.125).r, 0.125);
}

TEST(TransferFunction, GoesOnAsAtItsEnds)
{
  const TransferFunction transfer({ gray(0.25, 0.5), gray(0.75, 1.0) });
  EXPECT_EQ(transfer.evaluate(0.0).a, 0.5);
  EXPECT_EQ(transfer.evaluate(1.0).a, 1.0);
}

TEST(TransferFunction, JumpsWhereTwoPointsHaveOneValue)
{
  const TransferFunction transfer({ gray(0.0, 0.0), gray(0.5, 0.0), gray(0.5, 1.0) });
  EXPECT_EQ(transfer.evaluate(std::nextafter(0.5, 0.0)).a, 0.0);
  EXPECT_EQ(transfer.evaluate(0.5).a, 1.0); // the value itself takes what comes after it
}

TEST(TransferFunction, WithoutPointsShowsNothing)
{
  for (const TransferFunction& transfer :
    { TransferFunction(), TransferFunction(std::vector<TransferFunction::Point>()) })
  {
    EXPECT_EQ(transfer.evaluate(0.5).a, 0.0);
    EXPECT_FALSE(transfer.visible({ 0.0f, 1.0f }));
  }
}

TEST(TransferFunction, SeesASpikeBetweenAnySamples)
{
  for (int i = 1; i < 1000; ++i)
  {
    const double at = (i + 0.37) / 1000.0;
    const TransferFunction transfer(
      { gray(at - 0.5e-4, 0.0), gray(at, 1e-3), gray(at + 0.5e-4, 0.0) });
    const float value = static_cast<float>(at);
    EXPECT_TRUE(transfer.visible({ 0.0f, 1.0f }));
    EXPECT_TRUE(transfer.visible({ value - 2e-5f, value + 2e-5f }));
    EXPECT_TRUE(transfer.visible({ value, value }));
    EXPECT_FALSE(transfer.visible({ 0.0f, value - 1e-4f }));
    EXPECT_FALSE(transfer.visible({ value + 1e-4f, 1.0f }));
  }
}

TEST(TransferFunction, SeesASpikeOfNoWidthBetweenTwoJumps)
{
  const TransferFunction transfer({ gray(0.5, 0.0), gray(0.5, 1.0), gray(0.5, 0.0) });
  EXPECT_TRUE(transfer.visible({ 0.4f, 0.6f }));
  EXPECT_FALSE(transfer.visible({ 0.6f, 0.7f }));
}

TEST(TransferFunction, SeesTheValueOfAJump)
{
  // As label maps have it: one value in a step of the function.
  const TransferFunction transfer(
    { gray(0.25, 0.0), gray(0.25, 1.0), gray(0.75, 1.0), gray(0.75, 0.0) });
  EXPECT_TRUE(transfer.visible({ 0.25f, 0.25f }));
  EXPECT_TRUE(transfer.visible({ 0.0f, 0.25f }));
  EXPECT_FALSE(transfer.visible({ 0.0f, std::nextafter(0.25f, 0.0f) }));
  EXPECT_FALSE(transfer.visible({ 0.75f, 0.75f }));
}

TEST(TransferFunction, SeesNothingInAnEmptyRange)
{
  EXPECT_FALSE(TransferFunction({ gray(0.0, 1.0) }).visible({}));
}

TEST(TransferFunction, SeesARangeIfAndOnlyIfSomeValueInItHasOpacity)
{
  for (std::uint32_t seed = 0; seed < 300; ++seed)
  {
    const TransferFunction transfer = makeRandom(seed);
    std::mt19937 random(seed);
    for (int i = 0; i < 100; ++i)
    {
      const float a = static_cast<float>(random() % 4097) / 4096.0f;
      const float b = static_cast<float>(random() % 4097) / 4096.0f;
      const ValueRange range{ std::min(a, b), std::max(a, b) };
      // All control points lie on multiples of 2^-12, so these values meet every slope.
      bool shows = false;
      for (double value = range.min; value <= range.max; value += 1.0 / 8192.0)
      {
        shows = shows || transfer.evaluate(value).a > 0.0;
      }
      if (shows)
      {
        ASSERT_TRUE(transfer.visible(range)) << "seed " << seed << ": " << a << ", " << b;
        continue;
      }
      // A point that only the other side of a jump sees may count as well.
      bool point = false;
      for (const TransferFunction::Point& p : transfer.points())
      {
        point = point || (p.value >= range.min && p.value <= range.max && p.color.a > 0.0);
      }
      ASSERT_TRUE(point || !transfer.visible(range)) << "seed " << seed << ": " << a << ", " << b;
    }
  }
}

TEST(TransferFunction, KnowsWhetherTheSameValuesAreTransparent)
{
  const TransferFunction transfer({ gray(0.25, 0.0), gray(0.5, 1.0) });
  EXPECT_TRUE(transfer.showsTheSame(TransferFunction({ gray(0.25, 0.0), gray(0.5, 1.0) })));
  EXPECT_FALSE(transfer.showsTheSame(TransferFunction({ gray(0.3, 0.0), gray(0.5, 1.0) })));
}
