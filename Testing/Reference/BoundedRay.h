// SPDX-License-Identifier: BSD-3-Clause
// The part of a pixel's ray that lies in a box.
#ifndef ExaBricksReferenceBoundedRay_h
#define ExaBricksReferenceBoundedRay_h

#include "Reference/View.h"

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
}
}

#endif
