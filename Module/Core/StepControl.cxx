// SPDX-License-Identifier: BSD-3-Clause
#include "Core/StepControl.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>

namespace exabricks
{
namespace
{
double greatest(const glm::dvec4& v) { return std::max({ v.r, v.g, v.b, v.a }); }

constexpr int FewestPixels = 100;
constexpr double LeastScale = 1.0 / 64.0;
// At which errors fall with the step: kinks of the field and of the transfer function keep it below
// the two that theory has for smooth ones.
constexpr double Order = 1.7;
// A picture's error beside its difference to the one at half the step.
constexpr double ErrorPerDifference = 1.15;
constexpr int Rounds = 4;
constexpr double Near = 1.1; // no further round for a change of the step by less
// Of the tolerance, the most that levels left out may err by: what they do is left for the steps,
// which would get too short beyond.
constexpr double MostForLevels = 0.6;
// Steps in cells beside those of one level more, where to begin.
constexpr double StepsForCoarser = 0.8;

// Root mean square over the drawn pixels; none of so few that chance would say it.
std::optional<double> differenceOfDrawn(
  const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b)
{
  double sum = 0.0;
  int drawn = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    if (std::max(a[i].a, b[i].a) >= 1.0f / 255.0f)
    {
      const glm::dvec4 off = glm::dvec4(a[i]) - glm::dvec4(b[i]);
      sum += off.r * off.r + off.g * off.g + off.b * off.b + off.a * off.a;
      ++drawn;
    }
  }
  return drawn >= FewestPixels ? std::make_optional(std::sqrt(sum / (4.0 * drawn))) : std::nullopt;
}

// Finds the effort for a tolerance. Each picture is drawn once. It always begins in the same place:
// what it finds depends on the view alone, not on what was drawn before, so that the same view has
// the same picture.
class Pilot
{
public:
  Pilot(double tolerance, const DrawPilot& draw)
    : Tolerance(tolerance)
    , Draw(draw)
  {
  }

  std::optional<Effort> find()
  {
    const double full = this->FindFullStepScale(1.0, 1.0);
    this->Truth = this->Picture(0, 0.5 * full);
    if (!differenceOfDrawn(*this->Truth, *this->Truth))
    {
      return std::nullopt;
    }
    this->Least = { 0, full };
    for (int levels = 1; this->Suffices(levels); ++levels)
    {
    }
    if (this->Least.levelsLeftOut == 0)
    {
      this->Least.stepScale = this->FindFullStepScale(full, GreatestStepScale);
    }
    return this->Least;
  }

private:
  using Pixels = std::vector<glm::vec4>;

  // Null: there are not so many levels to leave out.
  const Pixels* Picture(int levelsLeftOut, double stepScale)
  {
    const auto [at, isNew] = this->Pictures.try_emplace({ levelsLeftOut, stepScale });
    if (isNew && !this->Draw(levelsLeftOut, stepScale, at->second))
    {
      this->Pictures.erase(at);
      return nullptr;
    }
    return &at->second;
  }

  // With all levels.
  double FindFullStepScale(double first, double greatest)
  {
    double scale = first;
    double lastScale = scale;
    double lastError = 0.0;
    for (int round = 0; round < Rounds; ++round)
    {
      const std::optional<double> difference =
        differenceOfDrawn(*this->Picture(0, scale), *this->Picture(0, 0.5 * scale));
      if (!difference)
      {
        break;
      }
      double error = ErrorPerDifference * *difference;
      if (scale > lastScale)
      {
        // Steps longer than regions all look alike, which hides their error.
        error = std::max(error, lastError * scale / lastScale);
      }
      const double change =
        error > 0.0 ? std::pow(this->Tolerance / error, 1.0 / Order) : greatest / LeastScale;
      const double next = glm::clamp(scale * change, LeastScale, greatest);
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

  // Whether so many levels can be left out; makes it the least effort if so.
  bool Suffices(int levels)
  {
    const auto error = [&](double stepScale)
    {
      const Pixels* picture = this->Picture(levels, stepScale);
      return picture ? differenceOfDrawn(*picture, *this->Truth) : std::nullopt;
    };
    const auto accept = [&](double stepScale)
    {
      this->Least.levelsLeftOut = levels;
      this->Least.stepScale = stepScale;
      return true;
    };
    double scale = StepsForCoarser * this->Least.stepScale;
    const std::optional<double> fine = error(0.5 * scale);
    if (!fine || *fine > MostForLevels * this->Tolerance)
    {
      return false;
    }
    const std::optional<double> coarse = error(scale);
    if (!coarse)
    {
      return false;
    }
    // Both have what the levels err in them, beside what the steps do, which falls with the order.
    const double squares = (*coarse * *coarse - *fine * *fine) / (1.0 - std::pow(0.5, 2.0 * Order));
    const double ofSteps = std::sqrt(std::max(squares, 0.0));
    const double forSteps = std::sqrt(this->Tolerance * this->Tolerance - *fine * *fine);
    const double change =
      ofSteps > 0.0 ? std::pow(forSteps / ofSteps, 1.0 / Order) : GreatestStepScale / LeastScale;
    scale = glm::clamp(scale * change, LeastScale, GreatestStepScale);
    if (std::max(change, 1.0 / change) > 1.5)
    {
      const std::optional<double> got = error(scale);
      if (got && *got > std::pow(Near, Order) * this->Tolerance)
      {
        scale = std::max(scale * std::pow(this->Tolerance / *got, 1.0 / Order), LeastScale);
      }
    }
    return accept(scale);
  }

  const double Tolerance;
  const DrawPilot& Draw;
  std::map<std::pair<int, double>, Pixels> Pictures;
  const Pixels* Truth = nullptr;
  Effort Least;
};
}

StepWeights::StepWeights(const TransferTable& table)
{
  this->Variation.reserve(table.bins.size() + 1);
  glm::dvec4 sum(0.0);
  glm::dvec4 before(0.0);
  const auto pass = [&](const glm::vec4& lower, const glm::vec4& upper, bool first)
  {
    sum += first ? glm::dvec4(0.0) : glm::abs(glm::dvec4(lower) - before);
    sum += glm::abs(glm::dvec4(upper) - glm::dvec4(lower));
    before = upper;
  };
  for (std::size_t i = 0; i < table.bins.size(); ++i)
  {
    this->Variation.push_back(sum);
    const layout::TransferBin& bin = table.bins[i];
    if (bin.lower.a >= 0.0f)
    {
      pass(bin.lower, bin.upper, i == 0);
      continue;
    }
    for (int k = 0; k < bin.integral.y; ++k)
    {
      const layout::TransferKnot& knot = table.knots[bin.integral.x + k];
      pass(knot.lower, knot.upper, i == 0 && k == 0);
    }
  }
  this->Variation.push_back(sum);
  this->Whole = greatest(sum);
}

glm::dvec4 StepWeights::VariationUpTo(double value) const
{
  const double bins = static_cast<double>(this->Variation.size() - 1);
  const double x = glm::clamp(value, 0.0, 1.0) * bins;
  const std::size_t i = static_cast<std::size_t>(std::min(x, bins - 1.0));
  return glm::mix(this->Variation[i], this->Variation[i + 1], x - static_cast<double>(i));
}

double StepWeights::step(const ValueRange& range, double width) const
{
  const double variation =
    greatest(this->VariationUpTo(range.max) - this->VariationUpTo(range.min));
  const double weight = variation * width;
  constexpr double longest = LongestStep * LongestStep * LongestStep;
  return weight * longest > this->Whole ? std::cbrt(this->Whole / weight) : LongestStep;
}

std::optional<Effort> findEffort(double tolerance, const DrawPilot& draw)
{
  return Pilot(tolerance, draw).find();
}
}
