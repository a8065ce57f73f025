// SPDX-License-Identifier: BSD-3-Clause
// Steps are longer where the transfer function varies less.
#include "Core/StepWeights.h"

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
