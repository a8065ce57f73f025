// SPDX-License-Identifier: BSD-3-Clause
// Where a ray first sees something of a volume, for pickers.
#ifndef ExaBricksAdaptersFirstSeen_h
#define ExaBricksAdaptersFirstSeen_h

#include "Vulkan/VolumeRenderer.h"

#include <optional>

namespace exabricks
{
/// A place of a picture, in normalised device coordinates; what is behind `depth` is not seen.
struct PlaceInPicture
{
  glm::dvec2 ndc{ 0.0 };
  double depth = 1.0; // of the window, in [0, 1]
};

/// Where the opacity from the viewer on comes to `opacity`, or, where the greatest or the least
/// value of a ray is shown, where that value is; in half cells, a 2^-24th of the ray's way through
/// the bounds behind it. `size`: of the bounds, half cells. None: nowhere. `fault`: what went
/// wrong.
std::optional<glm::dvec3> findFirstSeen(VolumeRenderer& renderer, View view,
  const PlaceInPicture& place, const glm::dvec3& size, double opacity, std::string& fault);
}

#endif
