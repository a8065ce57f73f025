// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/BoundedRay.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
glm::dvec3 unproject(const glm::dmat4& matrix, const glm::dvec3& ndc)
{
  const glm::dvec4 place = matrix * glm::dvec4(ndc, 1.0);
  return glm::dvec3(place) / place.w;
}
}

std::optional<BoundedRay> findBoundedRay(const View& view, const Box& bounds, int x, int y)
{
  const glm::dvec3 begin(
    2.0 * (x + 0.5) / view.width - 1.0, 2.0 * (y + 0.5) / view.height - 1.0, -1.0);
  const glm::dvec3 end(begin.x, begin.y, 1.0);
  const glm::dvec3 near = unproject(view.ndcToLogical, begin);
  const glm::dvec3 far = unproject(view.ndcToLogical, end);
  const glm::dvec3 a = (glm::dvec3(bounds.lo) - near) / (far - near);
  const glm::dvec3 b = (glm::dvec3(bounds.hi) - near) / (far - near);
  const glm::dvec3 enter = glm::min(a, b);
  const glm::dvec3 leave = glm::max(a, b);
  const double first = std::max({ 0.0, enter.x, enter.y, enter.z });
  const double last = std::min({ 1.0, leave.x, leave.y, leave.z });
  if (!(first < last))
  {
    return std::nullopt;
  }
  const double whole =
    glm::length(unproject(view.ndcToWorld, end) - unproject(view.ndcToWorld, begin));
  return BoundedRay{ glm::mix(near, far, first), glm::mix(near, far, last),
    (last - first) * whole };
}

Image drawRays(
  const View& view, const Box& bounds, const std::function<glm::dvec4(const BoundedRay& ray)>& look)
{
  Image image{ view.width, view.height, {} };
  image.pixels.resize(static_cast<std::size_t>(view.width) * view.height);
#pragma omp parallel for schedule(dynamic)
  for (int y = 0; y < view.height; ++y)
  {
    for (int x = 0; x < view.width; ++x)
    {
      if (const std::optional<BoundedRay> ray = findBoundedRay(view, bounds, x, y))
      {
        image.pixels[static_cast<std::size_t>(y) * view.width + x] = look(*ray);
      }
    }
  }
  return image;
}
}
}
