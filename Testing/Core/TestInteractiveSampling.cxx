// SPDX-License-Identifier: BSD-3-Clause
// How coarsely pictures are drawn to be done in time, by what the last ones took.
#include "Core/InteractiveSampling.h"

#include <algorithm>
#include <cmath>
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
  EXPECT_EQ(sampling.choose(0.1, Pixels, limits).imageSampleDistance, 10.0);
  sampling.measured({}, 0.0, 0.0, 0.0); // of no picture
  EXPECT_FALSE(sampling.knows());
}

TEST(InteractiveSampling, TakesTheTimeThatIsAllowed)
{
  const Machine machine{ 5e-6, 0.01 };
  for (const double seconds : { 0.5, 0.2, 0.1, 0.04 })
  {
    InteractiveSampling sampling;
    machine.draw(sampling, sampling.choose(seconds, Pixels, limits));
    const Coarseness chosen = sampling.choose(seconds, Pixels, limits);
    EXPECT_GT(chosen.imageSampleDistance, 1.0);
    EXPECT_EQ(chosen.stepGrowth, 1.0);
    EXPECT_NEAR(machine.draw(sampling, chosen), seconds, 0.01 * seconds);
  }
  InteractiveSampling sampling;
  machine.draw(sampling, {});
  EXPECT_EQ(sampling.choose(100.0, Pixels, limits).imageSampleDistance, 1.0);
}

TEST(InteractiveSampling, FollowsAMachineThatBecomesSlower)
{
  InteractiveSampling sampling;
  Machine machine{ 2e-6, 0.002 };
  machine.draw(sampling, sampling.choose(0.1, Pixels, limits));
  machine.perRay *= 3.0;
  double took = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    took = machine.draw(sampling, sampling.choose(0.1, Pixels, limits));
  }
  EXPECT_NEAR(took, 0.1, 0.01);
}

TEST(InteractiveSampling, StepsGrowWhereRaysAreAsThinAsMayBe)
{
  InteractiveSampling sampling;
  const Machine machine{ 1e-4, 0.0 };
  machine.draw(sampling, sampling.choose(0.4, Pixels, limits));
  const Coarseness chosen = sampling.choose(0.4, Pixels, limits);
  EXPECT_EQ(chosen.imageSampleDistance, 10.0);
  EXPECT_GT(chosen.stepGrowth, 1.0);
  EXPECT_LT(chosen.stepGrowth, 4.0);
  EXPECT_EQ(sampling.choose(0.001, Pixels, limits).stepGrowth, 4.0);
  // What longer steps save is not taken for a faster machine.
  sampling.measured(chosen, 100.0, 100.0 * 1e-4 / 1.2, 0.0);
  EXPECT_GT(sampling.choose(0.4, Pixels, limits).stepGrowth, 1.0);
}

TEST(InteractiveSampling, LeavesLevelsOutWhoseCellsLieCloserThanRays)
{
  InteractiveSampling sampling;
  // Each level less makes a picture 1.5 times as fast.
  const auto draw = [&](const Coarseness& coarseness)
  {
    const Machine machine{ 1e-5 / std::pow(1.5, coarseness.levelsLeftOut), 0.0 };
    return machine.draw(sampling, coarseness);
  };
  InteractiveSampling::Limits ofCells = limits;
  ofCells.cells = { 0.7, 1.4, 2.8, 5.6 };
  draw({});
  double before = 0.0;
  for (const double seconds : { 4.0, 1.0, 0.5, 0.2, 0.03 })
  {
    Coarseness chosen;
    double took = 0.0;
    for (int i = 0; i < 6; ++i) // what a number of levels takes is not known beforehand
    {
      chosen = sampling.choose(seconds, Pixels, ofCells);
      took = draw(chosen);
    }
    EXPECT_NEAR(took, seconds, 0.05 * seconds);
    EXPECT_LE(ofCells.cells[static_cast<std::size_t>(chosen.levelsLeftOut)],
      std::max(chosen.imageSampleDistance, 0.7));
    EXPECT_GE(chosen.levelsLeftOut, before);
    before = chosen.levelsLeftOut;
    // It stays where it is.
    EXPECT_EQ(sampling.choose(seconds, Pixels, ofCells).levelsLeftOut, chosen.levelsLeftOut);
  }
  EXPECT_EQ(before, 3);
  // Large cells are never left out, nor where it is not known how large they are.
  ofCells.cells = { 5.0, 10.1 };
  EXPECT_EQ(sampling.choose(0.05, Pixels, ofCells).levelsLeftOut, 0);
  EXPECT_EQ(sampling.choose(0.05, Pixels, limits).levelsLeftOut, 0);
}

TEST(InteractiveSampling, KeepsToItsLimits)
{
  InteractiveSampling sampling;
  Machine{ 1e-4, 0.0 }.draw(sampling, {});
  EXPECT_EQ(sampling.choose(0.001, Pixels, { 1.0, 3.0 }).imageSampleDistance, 3.0);
  EXPECT_EQ(sampling.choose(1e6, Pixels, { 2.0, 3.0 }).imageSampleDistance, 2.0);
  EXPECT_EQ(sampling.choose(0.001, Pixels, { 4.0, 3.0 }).imageSampleDistance, 4.0);
  EXPECT_EQ(thinnedSize(100, 4.0), 25);
  EXPECT_EQ(thinnedSize(3, 10.0), 1);
}
