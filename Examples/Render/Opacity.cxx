// SPDX-License-Identifier: BSD-3-Clause

#include "Opacity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace render
{

namespace
{

constexpr int Intervals = 20; // of the opacity function
constexpr double BackgroundShare = 0.8;
constexpr double MeanOpticalDepth = 1.2;
constexpr double MeanPath = 50.0;         // in unit distances
constexpr double LargestExtinction = 5.0; // per unit distance: opacity 0.993
constexpr double SmallestExtinction = 0.02;

// 0 in the background, up to 1 at the rarest values that are farthest from the most common one.
std::vector<double> interestOf(const std::vector<vtkIdType>& counts, bool belowToo)
{
  const int bins = static_cast<int>(counts.size());
  std::vector<int> byCount(bins);
  std::iota(byCount.begin(), byCount.end(), 0);
  std::stable_sort(
    byCount.begin(), byCount.end(), [&](int a, int b) { return counts[a] > counts[b]; });

  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  double covered = 0.0;
  double threshold = 0.0;
  for (int bin : byCount)
  {
    if (covered >= BackgroundShare * total || counts[bin] == 0)
    {
      break;
    }
    covered += counts[bin];
    threshold = counts[bin];
  }

  const int peak = byCount.front();
  const double farthest = std::max(peak, bins - 1 - peak);
  std::vector<double> interest(bins, 0.0);
  for (int i = 0; i < bins; ++i)
  {
    const double rarity = std::max(0.0, 1.0 - counts[i] / threshold);
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
    const int begin = std::max(0, (p - 1) * bins / Intervals);
    const int end = std::min(bins, (p + 1) * bins / Intervals);
    const auto first = interest.begin() + begin, last = interest.begin() + end;
    if (*std::min_element(first, last) > 0.0)
    {
      points[p] = std::accumulate(first, last, 0.0) / (end - begin);
    }
  }
  return points;
}

// Mean over all cells of the line through the points.
double meanOverCells(const std::vector<double>& points, const std::vector<vtkIdType>& counts)
{
  const double bins = static_cast<double>(counts.size());
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const double t = (i + 0.5) / bins * Intervals;
    const int p = static_cast<int>(t);
    sum += counts[i] * (points[p] + (t - p) * (points[p + 1] - points[p]));
    total += counts[i];
  }
  return sum / total;
}

}

double defaultOpacityUnit(const double bounds[6])
{
  return std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]) / 100.0;
}

std::vector<OpacityPoint> opacityFromHistogram(
  const std::vector<vtkIdType>& counts, const double range[2], bool belowToo)
{
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  if (!(range[0] < range[1]) || total <= 0.0)
  {
    return { { range[0], 1.0 - std::exp(-MeanOpticalDepth / MeanPath) } };
  }

  std::vector<double> points = atPoints(interestOf(counts, belowToo));
  double mean = meanOverCells(points, counts);
  if (!(mean > 0.0))
  {
    for (int p = 0; p <= Intervals; ++p)
    {
      points[p] = std::max(0.0, (p - 0.25 * Intervals) / (0.75 * Intervals));
    }
    mean = std::max(meanOverCells(points, counts), 1e-12);
  }

  const double extinction =
    std::clamp(MeanOpticalDepth / (MeanPath * mean), SmallestExtinction, LargestExtinction);
  std::vector<OpacityPoint> opacity;
  for (int p = 0; p <= Intervals; ++p)
  {
    // Between equal neighbours a point says nothing.
    if (p > 0 && p < Intervals && points[p] == points[p - 1] && points[p] == points[p + 1])
    {
      continue;
    }
    const double value = p == Intervals
      ? range[1]
      : range[0] + p * (range[1] - range[0]) / static_cast<double>(Intervals);
    opacity.push_back({ value, 1.0 - std::exp(-extinction * points[p]) });
  }
  return opacity;
}

}
