// SPDX-License-Identifier: BSD-3-Clause
// How coarsely pictures are drawn to be done in time, by what the last ones took.
#include "Core/InteractiveSampling.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
constexpr double Pixels = 480000.0;
const InteractiveSampling::Limits limits{ 1.0, 10.0 };

// A machine that takes so long for each ray, and for all else.
struct Machine
{
  double perRay;
  double other;

  double draw(InteractiveSampling& sampling, const Coarseness& coarseness) const
  {
    const double rays = Pixels / (coarseness.imageSampleDistance * coarseness.imageSampleDistance);
    sampling.measured(coarseness, rays, rays * this->perRay, this->other);
    return rays * this->perRay + this->other;
  }
};
}

TEST(InteractiveSampling, IsAsCoarseAsMayBeBeforeAnythingIsKnown)
{
  InteractiveSampling sampling;
  EXPECT_FALSE(sampling.knows());
  EXPECT_EQ(sampling.choose(0.1, Pixels, limits, false).imageSampleDistance, 10.0);
  sampling.measured({}, 0.0, 0.0, 0.0); // of no picture
  EXPECT_FALSE(sampling.knows());
}

TEST(InteractiveSampling, TakesTheTimeThatIsAllowed)
{
  const Machine machine{ 5e-6, 0.01 };
  for (const double seconds : { 0.5, 0.2, 0.1, 0.04 })
  {
    InteractiveSampling sampling;
    machine.draw(sampling, sampling.choose(seconds, Pixels, limits, false));
    const Coarseness chosen = sampling.choose(seconds, Pixels, limits, false);
    EXPECT_GT(chosen.imageSampleDistance, 1.0);
    EXPECT_EQ(chosen.stepGrowth, 1.0);
    EXPECT_NEAR(machine.draw(sampling, chosen), seconds, 0.01 * seconds);
  }
  InteractiveSampling sampling;
  machine.draw(sampling, {});
  EXPECT_EQ(sampling.choose(100.0, Pixels, limits, false).imageSampleDistance, 1.0);
}

TEST(InteractiveSampling, FollowsAMachineThatBecomesSlower)
{
  InteractiveSampling sampling;
  Machine machine{ 2e-6, 0.002 };
  machine.draw(sampling, sampling.choose(0.1, Pixels, limits, false));
  machine.perRay *= 3.0;
  double took = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    took = machine.draw(sampling, sampling.choose(0.1, Pixels, limits, false));
  }
  EXPECT_NEAR(took, 0.1, 0.01);
}

TEST(InteractiveSampling, StepsGrowWhereRaysAreAsThinAsMayBe)
{
  InteractiveSampling sampling;
  const Machine machine{ 1e-4, 0.0 };
  machine.draw(sampling, sampling.choose(0.4, Pixels, limits, false));
  const Coarseness chosen = sampling.choose(0.4, Pixels, limits, false);
  EXPECT_EQ(chosen.imageSampleDistance, 10.0);
  EXPECT_GT(chosen.stepGrowth, 1.0);
  EXPECT_LT(chosen.stepGrowth, 4.0);
  EXPECT_EQ(sampling.choose(0.001, Pixels, limits, false).stepGrowth, 4.0);
  // What longer steps save is not taken for a faster machine.
  sampling.measured(chosen, 100.0, 100.0 * 1e-4 / 1.2, 0.0);
  EXPECT_GT(sampling.choose(0.4, Pixels, limits, false).stepGrowth, 1.0);
}

TEST(InteractiveSampling, KeepsToItsLimits)
{
  InteractiveSampling sampling;
  Machine{ 1e-4, 0.0 }.draw(sampling, {});
  EXPECT_EQ(sampling.choose(0.001, Pixels, { 1.0, 3.0 }, false).imageSampleDistance, 3.0);
  EXPECT_EQ(sampling.choose(1e6, Pixels, { 2.0, 3.0 }, false).imageSampleDistance, 2.0);
  EXPECT_EQ(sampling.choose(0.001, Pixels, { 4.0, 3.0 }, false).imageSampleDistance, 4.0);
  EXPECT_EQ(thinnedSize(100, 4.0), 25);
  EXPECT_EQ(thinnedSize(3, 10.0), 1);
}

TEST(InteractiveSampling, PredictsWhatRaysAreNotEnoughFor)
{
  const Machine machine{ 5e-6, 0.01 };
  InteractiveSampling sampling;
  machine.draw(sampling, {});
  // As many rays, over a picture that is less thin.
  for (const double seconds : { 0.5, 0.1, 0.04 })
  {
    const Coarseness even = sampling.choose(seconds, Pixels, limits, false);
    const Coarseness chosen = sampling.choose(seconds, Pixels, limits, true);
    EXPECT_EQ(even.rays, 0.0);
    EXPECT_EQ(even.pixelDistance, even.imageSampleDistance);
    EXPECT_EQ(chosen.imageSampleDistance, even.imageSampleDistance);
    EXPECT_LT(chosen.pixelDistance, even.pixelDistance);
    EXPECT_GE(chosen.pixelDistance, 1.0);
    EXPECT_NEAR(chosen.rays * chosen.imageSampleDistance * chosen.imageSampleDistance, Pixels, 1.0);
  }
  // Not where there is time for all, nor in a small window.
  EXPECT_EQ(sampling.choose(100.0, Pixels, limits, true).rays, 0.0);
  EXPECT_EQ(sampling.choose(0.001, 10000.0, limits, true).rays, 0.0);
}
