// SPDX-License-Identifier: BSD-3-Clause
#include "Core/InteractiveSampling.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace
{
// Of what the last picture took this part counts, and the rest of what those before took: views
// change little from one picture to the next, but machines are not steady.
constexpr double PartOfLast = 0.6;

// Longer steps save the less, the more of the time goes into finding regions: half as many samples
// are a quarter less time, on scenes of 10^6 and 10^7 cells.
constexpr double GreatestGrowth = 4.0; // beyond it nothing of fine structures is left
double speedOf(double stepGrowth) { return 1.0 + 0.3 * std::log2(stepGrowth); }

// What is done beside marching leaves this part of the time for it at least.
constexpr double LeastPartOfMarching = 0.2;

double mean(double before, double last) { return before + PartOfLast * (last - before); }
}

int thinnedSize(int pixels, double imageSampleDistance)
{
  return std::max(1, static_cast<int>(std::lround(pixels / imageSampleDistance)));
}

void InteractiveSampling::measured(
  const Coarseness& drawn, double rays, double marching, double other)
{
  if (!(rays > 0.0) || !(marching > 0.0))
  {
    return;
  }
  const double perRay = marching / rays * speedOf(drawn.stepGrowth);
  this->Other = this->SecondsPerRay ? mean(this->Other, other) : other;
  this->SecondsPerRay = this->SecondsPerRay ? mean(*this->SecondsPerRay, perRay) : perRay;
}

Coarseness InteractiveSampling::choose(double seconds, double pixels, const Limits& limits) const
{
  const double most = std::max(limits.least, limits.most);
  if (!this->SecondsPerRay)
  {
    return { most, 1.0 };
  }
  const double allowed = std::max(seconds - this->Other, LeastPartOfMarching * seconds);
  const double wanted = std::sqrt(pixels * *this->SecondsPerRay / std::max(allowed, 1e-9));
  Coarseness chosen;
  chosen.imageSampleDistance = std::clamp(wanted, limits.least, most);
  if (wanted > most)
  {
    const double speed = wanted * wanted / (most * most);
    chosen.stepGrowth = std::min(std::exp2((speed - 1.0) / 0.3), GreatestGrowth);
  }
  return chosen;
}
}
