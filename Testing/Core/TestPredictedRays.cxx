// SPDX-License-Identifier: BSD-3-Clause
// As many pixels are predicted as the error allows, by what is measured on some of them.
#include "Core/PredictedRays.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

using namespace exabricks;

namespace
{
View makeView(int width, int height, double tolerance)
{
  View view;
  view.target.width = width;
  view.target.height = height;
  view.quality.errorTolerance = tolerance;
  return view;
}

// `count` pixels with estimates e, 2 e, 3 e, ... whose errors are as large, in each channel.
std::vector<layout::RayCheck> makeChecks(int count, float e, bool drawn = true)
{
  std::vector<layout::RayCheck> checks;
  for (int i = count; i > 0; --i) // in no order that is of use
  {
    const float error = e * static_cast<float>(i);
    checks.push_back({ error, 4.0f * error * error, drawn ? 1u : 0u });
  }
  return checks;
}

double meanError(const std::vector<layout::RayCheck>& checks, float threshold)
{
  double squares = 0.0;
  for (const layout::RayCheck& check : checks)
  {
    squares += check.estimate < threshold ? check.squares : 0.0;
  }
  return std::sqrt(squares / (4.0 * static_cast<double>(checks.size())));
}
}

TEST(PredictedRays, WhereAnErrorIsAskedFor)
{
  EXPECT_GT(toleranceOfPredictions(makeView(400, 300, 0.01)), 0.0);
  EXPECT_EQ(toleranceOfPredictions(makeView(400, 300, 0.0)), 0.0);
  EXPECT_EQ(toleranceOfPredictions(makeView(100, 100, 0.01)), 0.0); // checks would be most of it
  View view = makeView(400, 300, 0.01);
  view.quality.reconstruction = Reconstruction::Nearest; // is exact
  EXPECT_EQ(toleranceOfPredictions(view), 0.0);
  view = makeView(400, 300, 0.01);
  const std::vector<float> depth(400 * 300, 0.5f);
  view.target.nearDepth = depth.data(); // edges of which are not looked for
  EXPECT_EQ(toleranceOfPredictions(view), 0.0);
  view = makeView(400, 300, 0.01);
  view.quality.jittered = true; // noise tells nothing of its neighbours
  EXPECT_EQ(toleranceOfPredictions(view), 0.0);
}

TEST(PredictedRays, NotInPartsWhichHaveTheStepsOfTheWhole)
{
  const View whole = makeView(400, 300, 0.01);
  const View part = cropTo(whole, 10, 20, 100, 100);
  EXPECT_EQ(toleranceOfPredictions(part), 0.0);
  EXPECT_EQ(toleranceOfSteps(part), toleranceOfSteps(whole));
  // Squares of errors add up.
  EXPECT_NEAR(std::hypot(toleranceOfSteps(whole), toleranceOfPredictions(whole)), 0.01, 1e-12);
  EXPECT_EQ(toleranceOfSteps(makeView(100, 100, 0.01)), 0.01);
}

TEST(PredictedRays, ChecksOnePixelOfEachBlock)
{
  constexpr std::uint32_t width = 203;
  constexpr std::uint32_t height = 97;
  for (const std::uint32_t spacing : { 1u, 2u })
  {
    for (const std::uint32_t side : { 1u, 2u, 5u, 8u })
    {
      std::set<std::pair<std::uint32_t, std::uint32_t>> blocks;
      for (const std::uint32_t pixel : listCheckedPixels(width, height, spacing, side))
      {
        const std::uint32_t x = pixel % width;
        const std::uint32_t y = pixel / width;
        ASSERT_LT(y, height);
        ASSERT_TRUE(x % spacing == 0 && y % spacing == 0);
        // which has no ray yet
        ASSERT_TRUE(x % (2 * spacing) != 0 || y % (2 * spacing) != 0);
        ASSERT_TRUE(blocks.insert({ x / spacing / side, y / spacing / side }).second);
      }
      const double all = (double(width) / spacing / side) * (double(height) / spacing / side);
      EXPECT_NEAR(static_cast<double>(blocks.size()), 0.75 * all, 0.1 * all)
        << spacing << ' ' << side;
    }
  }
}

TEST(PredictedRays, AsManyAsTheErrorAllows)
{
  const std::vector<layout::RayCheck> checks = makeChecks(1000, 1e-5f);
  for (const double tolerance : { 1e-4, 1e-3, 3e-3 })
  {
    const double error = meanError(checks, findThreshold(checks, tolerance, true));
    EXPECT_LE(error, tolerance);
    EXPECT_GE(error, 0.95 * tolerance);
    // Before the last grid: others are predicted from these.
    EXPECT_NEAR(meanError(checks, findThreshold(checks, tolerance, false)), 0.5 * tolerance,
      0.05 * tolerance);
  }
  EXPECT_EQ(findThreshold(checks, 0.1, true), layout::UNPREDICTABLE); // all of them
}

TEST(PredictedRays, NoneWhereEstimatesTellNothing)
{
  // A line that the first rays passed by on both sides, in what looked empty.
  std::vector<layout::RayCheck> checks(1000, { 0.0f, 0.0f, 0u });
  for (std::size_t i = 0; i < 250; ++i)
  {
    checks[4 * i] = { 0.0f, 1.0f, 1u };
  }
  EXPECT_EQ(findThreshold(checks, 0.01, true), 0.0f);
  // Nor do few of what is drawn, however good.
  EXPECT_EQ(findThreshold(makeChecks(100, 0.0f), 0.01, true), 0.0f);
  EXPECT_EQ(findThreshold(makeChecks(1000, 0.01f, false), 0.01, true), 0.0f);
  EXPECT_EQ(findThreshold({}, 0.01, true), 0.0f);
}

TEST(PredictedRays, WhatIsNotDrawnDoesNotCount)
{
  std::vector<layout::RayCheck> checks = makeChecks(1000, 0.0f);
  const std::vector<layout::RayCheck> hidden = makeChecks(1000, 0.01f, false);
  checks.insert(checks.end(), hidden.begin(), hidden.end());
  EXPECT_EQ(findThreshold(checks, 0.01, true), layout::UNPREDICTABLE);
}
