// SPDX-License-Identifier: BSD-3-Clause
// How long intervals may be in one region beside another, for both to err alike.
#ifndef ExaBricksCoreStepWeights_h
#define ExaBricksCoreStepWeights_h

#include "Core/TransferTable.h"

#include <algorithm>

#include <glm/vec4.hpp>

namespace exabricks
{
/// Steps at which all regions err alike, for their cost. Between samples the field is taken for
/// straight: where it is not, extinction errs by its slope over values, at most by its variation
/// V over the region's range of values. Over a length, intervals of h cells of width w then err by
/// V w^(1/2) h^(5/2), signs being random, at a cost of 1 / (h w): least cost for an error is at
/// h ~ (V w)^(-1/3).
class StepWeights
{
public:
  explicit StepWeights(const TransferTable& table);

  /// Step in cells `width` finest cells wide, beside one of 1 in finest cells over whose range
  /// extinction goes through all its variation. At most LongestStep.
  double step(const ValueRange& range, double width) const;

  static constexpr double LongestStep = 8.0; // cells: values of a box say little of what is between
  /// With weights, steps grow along a ray with transmittance to the power of minus this, as an
  /// error behind something opaque is seen less.
  static constexpr float TransmittanceExponent = 1.0f / 3.0f;
  /// The opacity at which rays end where pictures may err by `tolerance`.
  static double terminationOpacity(double tolerance)
  {
    return std::max(1.0 - 0.25 * tolerance, 0.5);
  }

private:
  glm::dvec4 VariationUpTo(double value) const;

  std::vector<glm::dvec4> Variation; // of extinction's channels, from 0 to each bin's lower end
  double Whole = 0.0;
};
}

#endif
