// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PredictedRays.h"

#include "CheckedPixels.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace
{
constexpr double Blocks = 4000.0;
constexpr int FewestDrawn = 200; // of checked pixels
// Of the tolerance: longer steps save less than fewer rays.
constexpr double ShareOfPredictions = 0.7;

constexpr double ChecksPerRay = 1.0 / 20.0; // where rays are limited
constexpr float LeastEstimate = 1e-20f;     // above that of what looks empty

bool keepsTolerance(const Quality& quality, double pixels)
{
  return quality.errorTolerance > 0.0 && quality.reconstruction != Reconstruction::Nearest &&
    !quality.jittered && pixels >= FewestPixels;
}

void sortByEstimate(std::vector<layout::RayCheck>& checks)
{
  std::sort(checks.begin(), checks.end(),
    [](const layout::RayCheck& a, const layout::RayCheck& b) { return a.estimate < b.estimate; });
}
}

PredictionLimits limitPredictions(const View& view)
{
  const double pixels = static_cast<double>(view.target.width) * view.target.height;
  PredictionLimits limits;
  if (view.target.whole || view.quality.jittered)
  {
    return limits;
  }
  if (keepsTolerance(view.quality, pixels))
  {
    limits.tolerance = ShareOfPredictions * view.quality.errorTolerance;
  }
  if (pixels >= 0.25 * FewestPixels && view.quality.rays < pixels)
  {
    limits.rays = view.quality.rays;
  }
  return limits;
}

double toleranceOfSteps(const View& view)
{
  const double pixels = view.target.whole
    ? static_cast<double>(view.target.whole->width) * view.target.whole->height
    : static_cast<double>(view.target.width) * view.target.height;
  return keepsTolerance(view.quality, pixels)
    ? std::sqrt(1.0 - ShareOfPredictions * ShareOfPredictions) * view.quality.errorTolerance
    : view.quality.errorTolerance;
}

std::vector<std::uint32_t> listCheckedPixels(
  std::uint32_t width, std::uint32_t height, std::uint32_t spacing, std::uint32_t side)
{
  const std::uint32_t columns = (width - 1) / spacing + 1;
  const std::uint32_t rows = (height - 1) / spacing + 1;
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t row = 0; row * side < rows; ++row)
  {
    for (std::uint32_t column = 0; column * side < columns; ++column)
    {
      const std::uint32_t place = layout::checkedPlace(column, row, side);
      const std::uint32_t x = column * side + place % side;
      const std::uint32_t y = row * side + place / side;
      if (x < columns && y < rows && (x % 2 != 0 || y % 2 != 0))
      {
        pixels.push_back(spacing * (x + width * y));
      }
    }
  }
  return pixels;
}

std::uint32_t sideOfBlocks(
  std::uint32_t width, std::uint32_t height, std::uint32_t spacing, double rays)
{
  const double places = static_cast<double>(width) * height / spacing / spacing;
  const double blocks = rays > 0.0 ? std::min(Blocks, ChecksPerRay * rays) : Blocks;
  return std::max(1u, static_cast<std::uint32_t>(std::sqrt(places / blocks)));
}

float findThreshold(std::vector<layout::RayCheck> checks, double tolerance, bool isLastGrid)
{
  sortByEstimate(checks);
  const auto drawn = std::count_if(
    checks.begin(), checks.end(), [](const layout::RayCheck& check) { return check.drawn != 0; });
  if (drawn < FewestDrawn)
  {
    return 0.0f;
  }
  const double share = isLastGrid ? 1.0 : 0.25; // of squares
  double left = 4.0 * tolerance * tolerance * share * static_cast<double>(drawn);
  for (const layout::RayCheck& check : checks)
  {
    left -= check.drawn != 0 ? static_cast<double>(check.squares) : 0.0;
    if (!(left >= 0.0))
    {
      return check.estimate;
    }
  }
  return layout::UNPREDICTABLE;
}

float findThresholdOfShare(std::vector<layout::RayCheck> checks, double share)
{
  sortByEstimate(checks);
  const double count = static_cast<double>(checks.size());
  const auto stand = static_cast<std::size_t>(std::clamp(1.0 - share, 0.0, 1.0) * count);
  return stand < checks.size() ? std::max(checks[stand].estimate, LeastEstimate)
                               : layout::UNPREDICTABLE;
}
}
