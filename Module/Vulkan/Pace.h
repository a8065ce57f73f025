// SPDX-License-Identifier: BSD-3-Clause
// Work in pieces that take about the same time: a GPU that also drives a display must not be kept
// for long, and whoever waits may want to interrupt.
#ifndef ExaBricksVulkanPace_h
#define ExaBricksVulkanPace_h

#include <algorithm>

namespace exabricks
{
namespace vulkan
{
class Pace
{
public:
  static constexpr double PieceSeconds = 0.03;

  /// `perSecond`: as much as may be expected before anything is known.
  explicit Pace(double perSecond)
    : PerSecond(perSecond)
  {
  }

  /// As much as takes PieceSeconds, by what the last pieces took.
  double wanted() const { return PieceSeconds * this->PerSecond; }

  void took(double seconds, double amount)
  {
    const double rate = amount / std::max(seconds, 1e-6);
    // What a small piece takes is not its work's time alone.
    if (rate > this->PerSecond || amount >= 0.5 * this->wanted())
    {
      this->PerSecond = std::min(rate, GreatestGrowth * this->PerSecond);
    }
  }

private:
  // The next piece may cost more than those before: from one to the next they grow by no more.
  static constexpr double GreatestGrowth = 4.0;

  double PerSecond;
};
}
}

#endif
