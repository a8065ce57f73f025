// SPDX-License-Identifier: BSD-3-Clause
// Adaptive refinement in the picture (Levoy, "Volume rendering by adaptive refinement", The Visual
// Computer 1990): rays of few pixels first, and of the others where the picture is not as these
// predict it. What the predictions err by is measured on some pixels that are drawn to check them,
// so that a picture keeps an error whatever is in it.
#ifndef ExaBricksCorePredictedRays_h
#define ExaBricksCorePredictedRays_h

#include "Core/View.h"

#include <cstdint>
#include <vector>

namespace exabricks
{
/// Of the rays that are marched first, along each axis, pixels. The grids of every second pixel and
/// of all of them follow.
constexpr int FirstSpacing = 4;

/// The pixels of a picture that has so many rays, of which FirstSpacing's grid takes half of them;
/// and at most, where the picture need not be filled in for it, which blurs what is sharp.
constexpr double PixelsPerRay = 8.0;
constexpr double MostPixelsPerRay = 12.0;
/// Of a picture with fewer pixels none is predicted, as checks would be most of it; where its rays
/// are limited, of one with a quarter of them.
constexpr double FewestPixels = 40000.0;

/// Why pixels are marched that could be predicted.
struct PredictionLimits
{
  double tolerance = 0.0; // what predictions may err by; 0: whatever they err by
  double rays = 0.0;      // about so many pixels are marched; 0: as many as the tolerance takes

  bool any() const { return this->tolerance > 0.0 || this->rays > 0.0; }
};

/// Of a view's picture; none: all pixels are marched. So are those of a part of a picture, which
/// would be predicted otherwise than the next part.
PredictionLimits limitPredictions(const View& view);

/// What is left of the view's error tolerance for steps and levels, beside predictions. The same
/// for all parts of a picture.
double toleranceOfSteps(const View& view);

/// Pixels of the grid of `spacing` that have rays to check predictions by, x + width * y: one in
/// each block of side x side places of the grid, unless that place has a ray already.
std::vector<std::uint32_t> listCheckedPixels(
  std::uint32_t width, std::uint32_t height, std::uint32_t spacing, std::uint32_t side);

/// Blocks of this side have about as many checked pixels as it takes. `rays`: of the limits.
std::uint32_t sideOfBlocks(
  std::uint32_t width, std::uint32_t height, std::uint32_t spacing, double rays);

/// Predictions stand whose estimate is below: so many that they err together by `tolerance`, as a
/// root mean square over the channels of the drawn pixels, or by half of it on the grids before the
/// last one, of which others are predicted. 0: none stands, as where fewer than 200 of the checked
/// pixels are drawn, which tell nothing: all is small then, and most rays pass it by.
float findThreshold(std::vector<layout::RayCheck> checks, double tolerance, bool isLastGrid);

/// The same, so that a share of the pixels is marched, but none that looks empty.
float findThresholdOfShare(std::vector<layout::RayCheck> checks, double share);
}

#endif
