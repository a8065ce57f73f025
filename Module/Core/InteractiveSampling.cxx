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

// How much faster a picture is without one more level, as long as that was not measured.
constexpr double SpeedOfLevel = 1.3;

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
  this->Other = this->knows() ? mean(this->Other, other) : other;
  const auto level = static_cast<std::size_t>(drawn.levelsLeftOut);
  this->SecondsPerRay.resize(std::max(this->SecondsPerRay.size(), level + 1));
  std::optional<double>& known = this->SecondsPerRay[level];
  known = known ? mean(*known, perRay) : perRay;
}

// Where it was not measured, that of the next number of levels that was.
double InteractiveSampling::FindSecondsPerRay(int levelsLeftOut) const
{
  const int count = static_cast<int>(this->SecondsPerRay.size());
  for (int off = 0;; ++off)
  {
    for (const int level : { levelsLeftOut - off, levelsLeftOut + off })
    {
      if (level >= 0 && level < count && this->SecondsPerRay[static_cast<std::size_t>(level)])
      {
        return *this->SecondsPerRay[static_cast<std::size_t>(level)] *
          std::pow(SpeedOfLevel, level - levelsLeftOut);
      }
    }
  }
}

Coarseness InteractiveSampling::ChooseRays(
  double seconds, double pixels, const Limits& limits, int levelsLeftOut) const
{
  const double most = std::max(limits.least, limits.most);
  const double allowed = std::max(seconds - this->Other, LeastPartOfMarching * seconds);
  const double wanted =
    std::sqrt(pixels * this->FindSecondsPerRay(levelsLeftOut) / std::max(allowed, 1e-9));
  Coarseness chosen;
  chosen.levelsLeftOut = levelsLeftOut;
  chosen.imageSampleDistance = std::clamp(wanted, limits.least, most);
  if (wanted > most)
  {
    const double speed = wanted * wanted / (most * most);
    chosen.stepGrowth = std::min(std::exp2((speed - 1.0) / 0.3), GreatestGrowth);
  }
  return chosen;
}

Coarseness InteractiveSampling::choose(double seconds, double pixels, const Limits& limits) const
{
  if (!this->knows())
  {
    return { std::max(limits.least, limits.most), 1.0 };
  }
  for (std::size_t level = limits.cells.size(); level-- > 1;)
  {
    const Coarseness chosen = this->ChooseRays(seconds, pixels, limits, static_cast<int>(level));
    if (limits.cells[level] <= chosen.imageSampleDistance)
    {
      return chosen;
    }
  }
  return this->ChooseRays(seconds, pixels, limits, 0);
}
}
