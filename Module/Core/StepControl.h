// SPDX-License-Identifier: BSD-3-Clause
// Work from the error: how long intervals may be in one region beside another, and with how few
// levels, for the picture to err by as much as asked for.
#ifndef ExaBricksCoreStepControl_h
#define ExaBricksCoreStepControl_h

#include "Core/TransferTable.h"

#include <functional>
#include <glm/vec4.hpp>
#include <optional>

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

private:
  glm::dvec4 VariationUpTo(double value) const;

  std::vector<glm::dvec4> Variation; // of extinction's channels, from 0 to each bin's lower end
  double Whole = 0.0;
};

/// What a picture is drawn with.
struct Effort
{
  int levelsLeftOut = 0; // of the finest, see Coarsening
  double stepScale = 1.0;
};

/// Draws some pixels of a picture, premultiplied. False: there are not so many levels to leave out.
using DrawPilot =
  std::function<bool(int levelsLeftOut, double stepScale, std::vector<glm::vec4>& picture)>;

constexpr double GreatestStepScale = 4.0;

/// The least effort, up to GreatestStepScale, with which pictures err by `tolerance`, as a root
/// mean square over the channels of the pixels that are drawn (opacity of at least 1/255), found
/// from a sparse picture: the difference to half the step tells the error, the order at which it
/// falls tells the step; the difference to all levels tells what those left out are worth. Depends
/// on what `draw` draws alone. None if fewer than 100 pixels are drawn.
std::optional<Effort> findEffort(double tolerance, const DrawPilot& draw);
}

#endif
