// SPDX-License-Identifier: BSD-3-Clause
// Where rays first see something of a volume, for pickers and selectors.
#ifndef ExaBricksAdaptersFirstSeen_h
#define ExaBricksAdaptersFirstSeen_h

#include "Vulkan/VolumeRenderer.h"

#include <optional>
#include <vector>

namespace exabricks
{
/// A place of a picture, in normalised device coordinates; what is behind `depth` is not seen.
struct PlaceInPicture
{
  int width = 0;  // of the picture, pixels
  int height = 0; // pixels
  glm::dvec2 ndc{ 0.0 };
  double depth = 1.0; // of the window, in [0, 1]
};

/// The middle of pixel `i` of a view's picture, [height][width].
PlaceInPicture middleOfPixel(const View& view, std::size_t i);

/// The part of a place's line of sight that is in the bounds, half cells.
struct LineOfSight
{
  glm::dvec3 from;
  glm::dvec3 to;
};

/// `size`: of the bounds, half cells. None: it passes them by.
std::optional<LineOfSight> findLine(
  const View& view, const PlaceInPicture& place, const glm::dvec3& size);

/// In half cells.
struct FirstSeen
{
  glm::dvec3 place;  // a 2^-24th of the ray's way through the bounds behind the exact one
  glm::dvec3 inCell; // so far behind it that it is in the cell that is seen there, whatever rounds
};

/// Where the opacity from the viewer on comes to `opacity`, or, where the greatest or the least
/// value of a ray is shown, where that value is. `size`: of the bounds, half cells. None: nowhere.
/// `fault`: what went wrong. Levels and steps are those of a picture without geometry.
std::optional<FirstSeen> findFirstSeen(VolumeRenderer& renderer, View view,
  const PlaceInPicture& place, const glm::dvec3& size, double opacity, std::string& fault);

/// The same for each pixel of a view, [height][width], to a 2^-20th of the depth of the bounds.
std::vector<std::optional<FirstSeen>> findFirstSeen(
  VolumeRenderer& renderer, View view, const glm::dvec3& size, double opacity, std::string& fault);
}

#endif
