// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExaBricksAccuracyObservedOrder_h
#define ExaBricksAccuracyObservedOrder_h

#include <cmath>
#include <utility>
#include <vector>

namespace exabricks
{
namespace accuracy
{
/// Order p of errors c h^p from pairs (h, error): slope of the line that fits their logarithms
/// best.
inline double observedOrder(const std::vector<std::pair<double, double>>& errors)
{
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& row : errors)
  {
    const double width = std::log(row.first);
    const double error = std::log(row.second);
    x += width;
    y += error;
    xx += width * width;
    xy += width * error;
  }
  const double n = static_cast<double>(errors.size());
  return (n * xy - x * y) / (n * xx - x * x);
}
}
}

#endif
