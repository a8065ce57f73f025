// SPDX-License-Identifier: BSD-3-Clause
// Steps are longer where the transfer function varies less, and as long as the error allows.
#include "Core/StepControl.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
// Nothing below 0.4, a narrow spike at 0.5, a slow ramp from 0.6 on.
StepWeights makeWeights()
{
  return StepWeights(TransferTable(TransferFunction(
    { { 0.4, { 1, 1, 1, 0.0 } }, { 0.495, { 1, 1, 1, 0.0 } }, { 0.5, { 1, 1, 1, 0.9 } },
      { 0.505, { 1, 1, 1, 0.0 } }, { 0.6, { 1, 1, 1, 0.0 } }, { 1.0, { 1, 1, 1, 0.1 } } })));
}

// Pixels that err by c * scale^order, some up and some down, around the truth; and by what the
// levels left out do, in other pixels up and down.
struct Model
{
  double error;
  double order;
  std::vector<double> levels = {}; // errors without 1, 2, ... levels
  int drawn = 0;

  bool operator()(int levelsLeftOut, double scale, std::vector<glm::vec4>& picture)
  {
    if (levelsLeftOut > static_cast<int>(this->levels.size()))
    {
      return false;
    }
    ++this->drawn;
    const double coarse = levelsLeftOut > 0 ? this->levels[levelsLeftOut - 1] : 0.0;
    picture.assign(1000, glm::vec4(0.0f)); // half of them are background
    for (int i = 0; i < 500; ++i)
    {
      const double off = (i % 2 ? 1.0 : -1.0) * this->error * std::pow(scale, this->order) +
        (i % 4 < 2 ? 1.0 : -1.0) * coarse;
      picture[i] = glm::vec4(static_cast<float>(0.5 + off));
    }
    return true;
  }
};

double findStepScale(double tolerance, Model& model)
{
  return findEffort(tolerance, std::ref(model))->stepScale;
}
}

TEST(StepWeights, AreLongWhereNothingVaries)
{
  const StepWeights weights = makeWeights();
  EXPECT_EQ(weights.step({ 0.1f, 0.3f }, 1.0), StepWeights::LongestStep);
  EXPECT_EQ(weights.step({ 0.7f, 0.7f }, 1.0), StepWeights::LongestStep);
  EXPECT_EQ(StepWeights(TransferTable(TransferFunction())).step({ 0.0f, 1.0f }, 1.0),
    StepWeights::LongestStep);
}

TEST(StepWeights, AreOneOverAllVariationAndFallWithItsCubeRoot)
{
  const StepWeights weights = makeWeights();
  EXPECT_NEAR(weights.step({ 0.0f, 1.0f }, 1.0), 1.0, 1e-6);
  EXPECT_NEAR(weights.step({ 0.0f, 1.0f }, 8.0), 0.5, 1e-6); // cells of a coarser level
  // The spike is in, however little of the range it takes.
  const double spike = weights.step({ 0.49f, 0.51f }, 1.0);
  const double ramp = weights.step({ 0.6f, 1.0f }, 1.0);
  EXPECT_LT(spike, 1.05);
  const double up = -std::log1p(-0.9);
  EXPECT_NEAR(ramp, std::cbrt((2.0 * up - std::log1p(-0.1)) / -std::log1p(-0.1)), 0.01 * ramp);
}

TEST(StepControl, FindsTheStepOfAnError)
{
  for (const double order : { 1.3, 1.7, 2.0, 3.0 })
  {
    for (const double tolerance : { 0.02, 0.001 })
    {
      Model model{ 0.004, order };
      const double scale = findStepScale(tolerance, model);
      const double got = 0.004 * std::pow(scale, order);
      EXPECT_LE(got, 2.0 * tolerance) << order;
      EXPECT_GE(got, 0.5 * tolerance) << order;
    }
  }
}

TEST(StepControl, DrawsLittleToKnow)
{
  Model right{ 0.004, 1.7 };
  EXPECT_EQ(findStepScale(1.15 * 0.004 * (1.0 - std::pow(0.5, 1.7)), right), 1.0);
  EXPECT_EQ(right.drawn, 2);
  Model longer{ 0.004, 1.7 };
  findStepScale(0.001, longer);
  EXPECT_LE(longer.drawn, 5);
}

TEST(StepControl, EndsWhereNothingErrs)
{
  Model exact{ 0.0, 2.0 };
  EXPECT_EQ(findStepScale(0.001, exact), GreatestStepScale);
}

TEST(StepControl, SaysWhenTooFewPixelsAreDrawn)
{
  EXPECT_FALSE(findEffort(0.001,
    [](int levelsLeftOut, double, std::vector<glm::vec4>& picture)
    {
      picture.assign(99, glm::vec4(1.0f));
      return levelsLeftOut == 0;
    }));
}

TEST(StepControl, DoesNotTakeStepsThatLookAlikeForGood)
{
  // From a scale of 2 on each region is one interval: nothing more changes, and all is as wrong.
  Model model{ 0.004, 2.0 };
  const auto saturated = [&](int levelsLeftOut, double scale, std::vector<glm::vec4>& picture)
  { return model(levelsLeftOut, std::min(scale, 2.0), picture); };
  const double scale = findEffort(0.012, saturated)->stepScale;
  EXPECT_LE(0.004 * std::pow(std::min(scale, 2.0), 2.0), 2.0 * 0.012);
  EXPECT_LT(scale, GreatestStepScale);
}

TEST(StepControl, LeavesOutLevelsThatTheErrorAllows)
{
  Model model{ 0.004, 1.7, { 0.0001, 0.004, 0.02 } };
  const auto got = [&](const Effort& effort)
  {
    const double steps = model.error * std::pow(effort.stepScale, model.order);
    const double levels = effort.levelsLeftOut > 0 ? model.levels[effort.levelsLeftOut - 1] : 0.0;
    return std::sqrt(steps * steps + levels * levels);
  };
  for (const auto& [tolerance, expected] : std::vector<std::pair<double, int>>{
         { 0.01, 2 }, { 0.01, 2 }, { 0.1, 3 }, { 0.002, 1 }, { 0.0001, 0 }, { 0.05, 3 } })
  {
    const Effort effort = *findEffort(tolerance, std::ref(model));
    EXPECT_EQ(effort.levelsLeftOut, expected) << tolerance;
    EXPECT_LE(got(effort), 1.5 * tolerance);
    EXPECT_TRUE(got(effort) >= 0.5 * tolerance || effort.stepScale == GreatestStepScale);
  }
}

TEST(StepControl, AsksForLittleMoreWhereLevelsAreNeeded)
{
  Model model{ 0.004, 1.7, { 0.5 } };
  EXPECT_EQ(findEffort(0.001, std::ref(model))->levelsLeftOut, 0);
  Model without{ 0.004, 1.7 };
  findEffort(0.001, std::ref(without));
  EXPECT_EQ(model.drawn, without.drawn + 1);
}
