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
/// Distance along each axis of the rays that are marched first, pixels. The grids of every fourth
/// pixel, of every second one and of all of them follow.
constexpr int FirstSpacing = 8;

/// What predictions of the view's picture may err by, as a root mean square over the channels of
/// its drawn pixels; 0: all pixels are marched. So are those of pictures of less than 40 000
/// pixels, where checks would be most of it; of parts of a picture, which would be predicted
/// otherwise than the next part; and where samples are jittered, as noise tells nothing of its
/// neighbours.
double toleranceOfPredictions(const View& view);

/// What is left of the view's error tolerance for steps and levels, beside predictions. All parts
/// of a picture have the steps of the whole, and err by less, as they have all rays.
double toleranceOfSteps(const View& view);

/// Pixels of the grid of `spacing` that have rays to check predictions by, x + width * y: one in
/// each block of side x side places of the grid, unless that place has a ray already.
std::vector<std::uint32_t> listCheckedPixels(
  std::uint32_t width, std::uint32_t height, std::uint32_t spacing, std::uint32_t side);

/// Blocks of this side have about as many checked pixels as it takes: the fewer, the fewer pixels
/// are predicted by them.
std::uint32_t sideOfBlocks(std::uint32_t width, std::uint32_t height, std::uint32_t spacing);

/// Predictions stand whose estimate is below: so many that they err together by `tolerance`, as a
/// root mean square over the channels of the drawn pixels, or by half of it on the grids before the
/// last one, of which others are predicted. 0: none stands, as where fewer than 200 of the checked
/// pixels are drawn, or 100 on these grids, which tell nothing: all is small then, and most rays
/// pass it by.
float findThreshold(std::vector<layout::RayCheck> checks, double tolerance, bool isLastGrid);
}

#endif
