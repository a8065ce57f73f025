// SPDX-License-Identifier: BSD-3-Clause
// Steps are as long, and levels as few, as the error allows.
#include "Core/SamplingSearch.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

using namespace exabricks;

namespace
{
// Pictures of 500 pixels that err by error * scale^order, some up and some down; and by what the
// levels left out do, in other pixels up and down.
struct Model : SparsePictures
{
  Model(double e, double o, std::vector<double> l = {})
    : error(e)
    , order(o)
    , levels(std::move(l))
  {
  }

  std::vector<std::optional<Difference>> compare(const std::vector<Pair>& pairs) override
  {
    ++this->submissions;
    std::vector<std::optional<Difference>> differences;
    for (const auto& [a, b] : pairs)
    {
      if (std::max(a.levelsLeftOut, b.levelsLeftOut) > static_cast<int>(this->levels.size()))
      {
        differences.push_back(std::nullopt);
        continue;
      }
      this->drawn.insert(a);
      this->drawn.insert(b);
      const double ofSteps = this->errorOfSteps(a.stepScale) - this->errorOfSteps(b.stepScale);
      const double ofLevels = this->errorOfLevels(a) - this->errorOfLevels(b);
      differences.push_back(
        Difference{ 4.0 * this->pixels * (ofSteps * ofSteps + ofLevels * ofLevels), this->pixels });
    }
    return differences;
  }

  double errorOfSteps(double scale) const
  {
    return this->error * std::pow(std::min(scale, this->longest), this->order);
  }
  double errorOfLevels(const Sampling& sampling) const
  {
    return sampling.levelsLeftOut > 0 ? this->levels[sampling.levelsLeftOut - 1] : 0.0;
  }

  const double error;
  const double order;
  const std::vector<double> levels; // errors without 1, 2, ... levels
  double longest = 1e9;             // longer steps are as this one
  int pixels = 500;
  int submissions = 0;
  std::set<Sampling> drawn;
};

double findStepScale(double tolerance, Model& model)
{
  return findSampling(tolerance, model)->stepScale;
}
}

TEST(SamplingSearch, FindsTheStepOfAnError)
{
  for (const double order : { 1.3, 1.7, 2.0, 3.0 })
  {
    for (const double tolerance : { 0.02, 0.001 })
    {
      Model model{ 0.004, order };
      const double got = model.errorOfSteps(findStepScale(tolerance, model));
      EXPECT_LE(got, 2.0 * tolerance) << order;
      EXPECT_GE(got, 0.5 * tolerance) << order;
    }
  }
}

TEST(SamplingSearch, DrawsLittleToKnow)
{
  Model right{ 0.004, 1.7 };
  EXPECT_EQ(findStepScale(1.15 * 0.004 * (1.0 - std::pow(0.5, 1.7)), right), 1.0);
  EXPECT_EQ(right.drawn.size(), 2u);
  Model longer{ 0.004, 1.7 };
  findStepScale(0.001, longer);
  EXPECT_LE(longer.drawn.size(), 5u);
  EXPECT_LE(longer.submissions, 4);
}

TEST(SamplingSearch, EndsWhereNothingErrs)
{
  Model exact{ 0.0, 2.0 };
  EXPECT_EQ(findStepScale(0.001, exact), GreatestStepScale);
}

TEST(SamplingSearch, SaysWhenTooFewPixelsAreDrawn)
{
  Model few{ 0.004, 1.7 };
  few.pixels = 99;
  EXPECT_FALSE(findSampling(0.001, few));
}

TEST(SamplingSearch, DoesNotTakeStepsThatLookAlikeForGood)
{
  // From a scale of 2 on each region is one interval: nothing more changes, and all is as wrong.
  Model model{ 0.004, 2.0 };
  model.longest = 2.0;
  const double scale = findStepScale(0.012, model);
  EXPECT_LE(model.errorOfSteps(scale), 2.0 * 0.012);
  EXPECT_LT(scale, GreatestStepScale);
}

TEST(SamplingSearch, LeavesOutLevelsThatTheErrorAllows)
{
  Model model{ 0.004, 1.7, { 0.0001, 0.004, 0.02 } };
  for (const auto& [tolerance, expected] : std::vector<std::pair<double, int>>{
         { 0.01, 2 }, { 0.01, 2 }, { 0.1, 3 }, { 0.002, 1 }, { 0.0001, 0 }, { 0.05, 3 } })
  {
    const Sampling sampling = *findSampling(tolerance, model);
    const double got =
      std::hypot(model.errorOfSteps(sampling.stepScale), model.errorOfLevels(sampling));
    EXPECT_EQ(sampling.levelsLeftOut, expected) << tolerance;
    EXPECT_LE(got, 1.5 * tolerance);
    EXPECT_TRUE(got >= 0.5 * tolerance || sampling.stepScale == GreatestStepScale);
  }
}

TEST(SamplingSearch, AsksForLittleMoreWhereLevelsAreNeeded)
{
  Model model{ 0.004, 1.7, { 0.5 } };
  EXPECT_EQ(findSampling(0.001, model)->levelsLeftOut, 0);
  Model without{ 0.004, 1.7 };
  findSampling(0.001, without);
  EXPECT_EQ(model.submissions, without.submissions);
  EXPECT_LE(model.drawn.size(), without.drawn.size() + 2);
}
