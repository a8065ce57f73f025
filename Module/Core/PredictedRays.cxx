// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PredictedRays.h"

#include "CheckedPixels.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace
{
constexpr double FewestPixels = 40000.0; // of a picture that keeps a tolerance
constexpr double Blocks = 4000.0;
constexpr int FewestDrawn = 200; // of checked pixels
// Of the tolerance: longer steps save less than fewer rays.
constexpr double ShareOfPredictions = 0.7;

bool mayPredict(const Quality& quality, double pixels)
{
  return quality.errorTolerance > 0.0 && quality.reconstruction != Reconstruction::Nearest &&
    !quality.jittered && pixels >= FewestPixels;
}
}

double toleranceOfPredictions(const View& view)
{
  const double pixels = static_cast<double>(view.target.width) * view.target.height;
  return !view.target.whole && !view.target.nearDepth && mayPredict(view.quality, pixels)
    ? ShareOfPredictions * view.quality.errorTolerance
    : 0.0;
}

double toleranceOfSteps(const View& view)
{
  const double pixels = view.target.whole
    ? static_cast<double>(view.target.whole->width) * view.target.whole->height
    : static_cast<double>(view.target.width) * view.target.height;
  return mayPredict(view.quality, pixels)
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

std::uint32_t sideOfBlocks(std::uint32_t width, std::uint32_t height, std::uint32_t spacing)
{
  const double columns = std::ceil(static_cast<double>(width) / spacing);
  const double rows = std::ceil(static_cast<double>(height) / spacing);
  const double side = std::round(std::sqrt(columns * rows * spacing / Blocks));
  return static_cast<std::uint32_t>(std::clamp(side, 1.0, std::min(columns, rows)));
}

float findThreshold(std::vector<layout::RayCheck> checks, double tolerance, bool isLastGrid)
{
  std::sort(checks.begin(), checks.end(),
    [](const layout::RayCheck& a, const layout::RayCheck& b) { return a.estimate < b.estimate; });
  const auto drawn = std::count_if(
    checks.begin(), checks.end(), [](const layout::RayCheck& check) { return check.drawn != 0; });
  if (drawn < (isLastGrid ? FewestDrawn : FewestDrawn / 2))
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
      return std::min(check.estimate, layout::UNPREDICTABLE);
    }
  }
  return layout::UNPREDICTABLE;
}
}
