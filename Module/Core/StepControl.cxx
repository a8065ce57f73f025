// SPDX-License-Identifier: BSD-3-Clause
#include "Core/StepControl.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

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

std::optional<double> findStepScale(double tolerance, double first, const DrawAtStepScale& draw)
{
  std::vector<glm::vec4> picture;
  std::vector<glm::vec4> finer;
  double scale = std::min(first, 1.0);
  double lastScale = scale;
  double lastError = 0.0;
  for (int round = 0; round < Rounds; ++round)
  {
    draw(scale, picture);
    draw(0.5 * scale, finer);
    const std::optional<double> difference = differenceOfDrawn(picture, finer);
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
      error > 0.0 ? std::pow(tolerance / error, 1.0 / Order) : GreatestStepScale / LeastScale;
    const double next = glm::clamp(scale * change, LeastScale, GreatestStepScale);
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
}
