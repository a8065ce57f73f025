// SPDX-License-Identifier: BSD-3-Clause
// A range of values in the data's own units, and how it maps them to [0, 1].
#ifndef ExaBricksCoreRange_h
#define ExaBricksCoreRange_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace exabricks
{
struct Range
{
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(this->min <= this->max); }
  void add(double value)
  {
    this->min = std::min(this->min, value);
    this->max = std::max(this->max, value);
  }
  void add(const Range& other)
  {
    this->min = std::min(this->min, other.min);
    this->max = std::max(this->max, other.max);
  }
  /// 0 at min, 1 at max; for any finite range, from the widest to that of the least two denormals.
  /// 0 for a range of one value.
  double normalize(double value) const
  {
    const double width = this->max - this->min;
    if (!std::isfinite(width))
    {
      return (0.5 * value - 0.5 * this->min) / (0.5 * this->max - 0.5 * this->min);
    }
    return width > 0.0 ? (value - this->min) / width : value - this->min;
  }
};
}

#endif
