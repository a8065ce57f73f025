// SPDX-License-Identifier: BSD-3-Clause
#include "Core/StepWeights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace exabricks
{
namespace
{
double greatest(const glm::dvec4& v) { return std::max({ v.r, v.g, v.b, v.a }); }

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
}
