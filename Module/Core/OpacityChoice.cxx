// SPDX-License-Identifier: BSD-3-Clause
#include "Core/OpacityChoice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace exabricks
{
namespace
{
constexpr int Intervals = 20; // of the function
constexpr double BackgroundShare = 0.8;

// 0 in the background, up to 1 at the rarest values that are farthest from the most common one.
std::vector<double> interestOfBins(const std::vector<std::uint64_t>& cells, bool belowToo)
{
  const int bins = static_cast<int>(cells.size());
  std::vector<int> byCount(bins);
  std::iota(byCount.begin(), byCount.end(), 0);
  std::stable_sort(
    byCount.begin(), byCount.end(), [&](int a, int b) { return cells[a] > cells[b]; });

  const double total = std::accumulate(cells.begin(), cells.end(), 0.0);
  double covered = 0.0;
  double threshold = 0.0;
  for (const int bin : byCount)
  {
    if (covered >= BackgroundShare * total || cells[bin] == 0)
    {
      break;
    }
    covered += static_cast<double>(cells[bin]);
    threshold = static_cast<double>(cells[bin]);
  }

  const int peak = byCount.front();
  const double farthest = std::max(peak, bins - 1 - peak);
  std::vector<double> interest(bins, 0.0);
  for (int i = 0; i < bins; ++i)
  {
    const double rarity = std::max(0.0, 1.0 - static_cast<double>(cells[i]) / threshold);
    const double distance = std::abs(i - peak) / farthest;
    interest[i] = belowToo || i >= peak ? rarity * (0.1 + 0.9 * distance) : 0.0;
  }
  return interest;
}

// At the ends of the intervals: the mean of the bins beside, or 0 if the background reaches into
// them, so that the line between two points is 0 over the background too.
std::vector<double> atPoints(const std::vector<double>& interest)
{
  const int bins = static_cast<int>(interest.size());
  std::vector<double> points(Intervals + 1, 0.0);
  for (int p = 0; p <= Intervals; ++p)
  {
    const auto first = interest.begin() + std::max(0, (p - 1) * bins / Intervals);
    const auto last = interest.begin() + std::min(bins, (p + 1) * bins / Intervals);
    if (*std::min_element(first, last) > 0.0)
    {
      points[p] = std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
    }
  }
  return points;
}
}

double Interest::at(double t) const
{
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(this->points.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(place), this->points.size() - 2);
  const double part = place - static_cast<double>(lower);
  return (1.0 - part) * this->points[lower] + part * this->points[lower + 1];
}

Interest chooseInterest(const std::vector<std::uint64_t>& cells, bool belowToo)
{
  Interest interest{ std::vector<double>(Intervals + 1, 0.0) };
  if (std::any_of(cells.begin(), cells.end(), [](std::uint64_t count) { return count > 0; }))
  {
    interest.points = atPoints(interestOfBins(cells, belowToo));
  }
  const auto bins = static_cast<double>(cells.size());
  double shown = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    shown += static_cast<double>(cells[i]) * interest.at((static_cast<double>(i) + 0.5) / bins);
  }
  if (!(shown > 0.0))
  {
    for (int p = 0; p <= Intervals; ++p)
    {
      interest.points[p] = std::max(0.0, (p - 0.25 * Intervals) / (0.75 * Intervals));
    }
  }
  return interest;
}
}
