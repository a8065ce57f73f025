// SPDX-License-Identifier: BSD-3-Clause
// A transfer function that is exact at its control points: piecewise linear on normalised values.
#ifndef ExaBricksCoreTransferFunction_h
#define ExaBricksCoreTransferFunction_h

#include "Core/ValueRanges.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace exabricks
{
class TransferFunction
{
public:
  struct Point
  {
    double value;     // normalised
    glm::dvec4 color; // red, green, blue, opacity of the unit distance, all in [0, 1]
  };

  /// Shows nothing.
  TransferFunction()
    : TransferFunction(std::vector<Point>())
  {
  }
  /// `points` are in ascending order; two of equal value make a jump. Values before the first and
  /// after the last point have the colour of that point.
  explicit TransferFunction(std::vector<Point> points);

  const std::vector<Point>& points() const { return this->Points; }
  glm::dvec4 evaluate(double value) const;

  /// Whether any value in [range.min, range.max] has an opacity above 0. Decided on the control
  /// points themselves.
  bool visible(const ValueRange& range) const
  {
    if (!(range.min <= range.max))
    {
      return false;
    }
    for (const glm::dvec2& interval : this->Transparent)
    {
      if (range.min >= interval.x && range.max <= interval.y)
      {
        return false;
      }
    }
    return true;
  }

  /// Whether both show the same values, so that the active regions can be kept.
  bool showsTheSame(const TransferFunction& other) const;
  /// Whether both have the same opacities, at the same points.
  bool isAsOpaqueAs(const TransferFunction& other) const;

private:
  std::vector<Point> Points;
  std::vector<glm::dvec2> Transparent; // maximal intervals of no opacity, in ascending order
};
}

#endif
