// SPDX-License-Identifier: BSD-3-Clause
// The part of a pixel's ray that lies in a box, and pictures of what such parts look like.
#ifndef ExaBricksReferenceBoundedRay_h
#define ExaBricksReferenceBoundedRay_h

#include "Reference/Image.h"
#include "Reference/View.h"

#include <functional>
#include <optional>

namespace exabricks
{
namespace reference
{
struct BoundedRay
{
  glm::dvec3 from; // logical
  glm::dvec3 to;
  double worldLength;
};

/// None where the ray misses `bounds` (logical). The view's depth and cut do not count.
std::optional<BoundedRay> findBoundedRay(const View& view, const Box& bounds, int x, int y);

/// Pixels of rays that miss `bounds` are 0. Calls `look` from several threads.
Image drawRays(const View& view, const Box& bounds,
  const std::function<glm::dvec4(const BoundedRay& ray)>& look);
}
}

#endif
