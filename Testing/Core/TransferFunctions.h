// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions for tests.
#ifndef ExaBricksTestingTransferFunctions_h
#define ExaBricksTestingTransferFunctions_h

#include "Core/TransferFunction.h"

#include <algorithm>
#include <random>

namespace exabricks
{
namespace testing
{
inline TransferFunction::Point gray(double value, double opacity)
{
  return { value, glm::dvec4(value, value, value, opacity) };
}

// Points on multiples of 2^-12, so that floats hold them, with flat parts of no opacity and jumps.
inline TransferFunction makeRandom(std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto share = [&] { return static_cast<double>(random() % 1001) / 1000.0; };
  std::vector<double> values;
  const unsigned count = random() % 40 + 1;
  for (unsigned i = 0; i < count; ++i)
  {
    values.push_back((static_cast<double>(random() % 5000) - 400.0) / 4096.0);
    if (random() % 4 == 0)
    {
      values.push_back(values.back());
    }
  }
  std::sort(values.begin(), values.end());
  std::vector<TransferFunction::Point> points;
  for (const double value : values)
  {
    const double opacity = random() % 2 ? share() : 0.0;
    points.push_back({ value, glm::dvec4(share(), share(), share(), opacity) });
  }
  return TransferFunction(points);
}
}
}

#endif
