// SPDX-License-Identifier: BSD-3-Clause
// The integration rule of the basis: the order that theory says, where it says it. (Nearest has
// constant values on known intervals: nothing to converge, see MatchesOracle.)
#include "Accuracy/StepOrder.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;
using namespace exabricks::accuracy;

namespace
{
std::vector<StepError> measure(const StepScene& scene)
{
  const std::vector<StepError> rows = measureStepErrors(scene);
  std::cout << scene.name << ":\n";
  for (const StepError& row : rows)
  {
    std::cout << "  step " << row.stepScale << ": opacity " << row.opacity << ", color "
              << row.color << '\n';
  }
  std::cout << "  orders " << observedOrder(rows, &StepError::opacity) << ", "
            << observedOrder(rows, &StepError::color) << '\n';
  return rows;
}
}

TEST(StepOrder, OnASmoothField)
{
  // Simpson's rule has order 4, less where the middle is kept from overshooting. An interval's
  // colour is the mean over its values, whichever comes first: second order.
  const std::vector<StepError> rows = measure(smoothScene());
  EXPECT_GE(observedOrder(rows, &StepError::opacity), 2.6);
  EXPECT_GE(observedOrder(rows, &StepError::color), 1.85);
  EXPECT_LE(rows.back().opacity, 1e-5);
}

TEST(StepOrder, OnFieldsWithKinks)
{
  for (const StepScene& scene : kinkedScenes())
  {
    const std::vector<StepError> rows = measure(scene);
    const double order = observedOrder(rows, &StepError::opacity);
    if (scene.name.find("spike") != std::string::npos)
    {
      // How long a ray stays in the spike depends on the field's slope, which a straight way
      // between two samples has to first order, and not at all where a kink lies between them: a
      // share of the rays that falls with the step. Found it is at any step.
      EXPECT_GE(order, 0.5);
      EXPECT_LE(rows.front().opacity, 0.05);
    }
    else if (scene.name.find("jump") != std::string::npos)
    {
      // Second order where the ray crosses the jump's surface; where it grazes it, less.
      EXPECT_GE(order, 1.4);
    }
    else
    {
      EXPECT_GE(order, 1.75) << scene.name; // second order at a kink
    }
  }
}
