// SPDX-License-Identifier: BSD-3-Clause
#include "Core/SamplingSearch.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace
{
constexpr int FewestPixels = 100;
constexpr double LeastScale = 1.0 / 64.0;
// At which errors fall with the step: kinks of the field and of the transfer function keep it below
// the two that theory has for smooth ones.
constexpr double Order = 1.7;
// A picture's error beside its difference to the one at half the step.
constexpr double ErrorPerDifference = 1.15;
constexpr int Rounds = 4;
constexpr double Near = 1.1; // A step that would change by less is taken as it is.
// Of the tolerance, the most that levels left out may err by: what they do is left for the steps,
// which would get too short beyond.
constexpr double MostForLevels = 0.6;
// Steps in cells beside those of one level more, where to begin.
constexpr double StepsForCoarser = 0.8;

// It always begins in the same place: what it finds depends on the view alone, not on what was
// drawn before, so that the same view has the same picture.
class Search
{
public:
  Search(double tolerance, SparsePictures& pictures)
    : Tolerance(tolerance)
    , Pictures(pictures)
  {
  }

  std::optional<Sampling> find()
  {
    const std::optional<double> full = this->FindFullStepScale(1.0, 1.0);
    if (!full)
    {
      return std::nullopt;
    }
    this->Truth = { 0, 0.5 * *full };
    this->Cheapest = { 0, *full };
    for (int levels = 1; this->Suffices(levels); ++levels)
    {
    }
    if (this->Cheapest.levelsLeftOut == 0)
    {
      this->Cheapest.stepScale = this->FindFullStepScale(*full, GreatestStepScale).value_or(*full);
    }
    return this->Cheapest;
  }

private:
  // Root mean squares over the drawn pixels; none of so few that chance would say it.
  std::vector<std::optional<double>> Compare(const std::vector<SparsePictures::Pair>& pairs)
  {
    std::vector<std::optional<double>> means;
    for (const std::optional<SparsePictures::Difference>& difference :
      this->Pictures.compare(pairs))
    {
      const bool known = difference && difference->drawn >= FewestPixels;
      means.push_back(known
          ? std::make_optional(std::sqrt(difference->squares / (4.0 * difference->drawn)))
          : std::nullopt);
    }
    return means;
  }

  // With all levels. None, if too little is drawn to know.
  std::optional<double> FindFullStepScale(double first, double greatest)
  {
    double scale = first;
    double lastScale = scale;
    double lastError = 0.0;
    for (int round = 0; round < Rounds; ++round)
    {
      const std::optional<double> difference =
        this->Compare({ { { 0, scale }, { 0, 0.5 * scale } } }).front();
      if (!difference)
      {
        return std::nullopt;
      }
      double error = ErrorPerDifference * *difference;
      if (scale > lastScale)
      {
        // Steps longer than regions all look alike, which hides their error.
        error = std::max(error, lastError * scale / lastScale);
      }
      const double change =
        error > 0.0 ? std::pow(this->Tolerance / error, 1.0 / Order) : greatest / LeastScale;
      const double next = std::clamp(scale * change, LeastScale, greatest);
      if (std::max(change, 1.0 / change) <= Near || next == scale)
      {
        break;
      }
      lastScale = scale;
      lastError = error;
      scale = next;
    }
    return scale;
  }

  // Whether so many levels can be left out; takes that for the cheapest sampling if so.
  bool Suffices(int levels)
  {
    double scale = StepsForCoarser * this->Cheapest.stepScale;
    const std::vector<std::optional<double>> errors = this->Compare(
      { { { levels, 0.5 * scale }, this->Truth }, { { levels, scale }, this->Truth } });
    const std::optional<double>& fine = errors[0];
    const std::optional<double>& coarse = errors[1];
    if (!fine || !coarse || *fine > MostForLevels * this->Tolerance)
    {
      return false;
    }
    // Both have what the levels err in them, beside what the steps do, which falls with the order.
    const double squares = (*coarse * *coarse - *fine * *fine) / (1.0 - std::pow(0.5, 2.0 * Order));
    const double ofSteps = std::sqrt(std::max(squares, 0.0));
    const double forSteps = std::sqrt(this->Tolerance * this->Tolerance - *fine * *fine);
    const double change =
      ofSteps > 0.0 ? std::pow(forSteps / ofSteps, 1.0 / Order) : GreatestStepScale / LeastScale;
    scale = std::clamp(scale * change, LeastScale, GreatestStepScale);
    if (std::max(change, 1.0 / change) > 1.5)
    {
      const std::optional<double> got =
        this->Compare({ { { levels, scale }, this->Truth } }).front();
      if (got && *got > std::pow(Near, Order) * this->Tolerance)
      {
        scale = std::max(scale * std::pow(this->Tolerance / *got, 1.0 / Order), LeastScale);
      }
    }
    this->Cheapest = { levels, scale };
    return true;
  }

  const double Tolerance;
  SparsePictures& Pictures;
  Sampling Truth; // steps of half the length that all levels need
  Sampling Cheapest;
};
}

std::optional<Sampling> findSampling(double tolerance, SparsePictures& pictures)
{
  return Search(tolerance, pictures).find();
}
}
