// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/View.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace exabricks
{
namespace reference
{
glm::dmat4 logicalToWorld(const Hierarchy& hierarchy)
{
  return glm::scale(glm::translate(glm::dmat4(1.0), hierarchy.origin), hierarchy.spacing);
}

View lookAt(const Hierarchy& hierarchy, const Box& bounds, const glm::dvec3& direction,
  double viewAngle, int width, int height)
{
  const glm::dvec3 lo = hierarchy.origin + hierarchy.spacing * glm::dvec3(bounds.lo);
  const glm::dvec3 hi = hierarchy.origin + hierarchy.spacing * glm::dvec3(bounds.hi);
  const glm::dvec3 center = 0.5 * (lo + hi);
  const double radius = 0.5 * glm::length(hi - lo);
  const double aspect = static_cast<double>(width) / height;
  const glm::dvec3 forward = glm::normalize(direction);
  const glm::dvec3 up =
    std::abs(forward.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);

  double distance = 2.0 * radius;
  glm::dmat4 projection;
  if (viewAngle > 0.0)
  {
    const double half = 0.5 * glm::radians(viewAngle);
    distance = radius / std::sin(std::min(half, std::atan(std::tan(half) * aspect)));
    projection = glm::perspectiveRH_NO(2.0 * half, aspect, distance - radius, distance + radius);
  }
  else
  {
    const double halfHeight = radius / std::min(aspect, 1.0);
    projection = glm::orthoRH_NO(-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight,
      distance - radius, distance + radius);
  }
  const glm::dmat4 camera = glm::lookAtRH(center - distance * forward, center, up);

  View view;
  view.ndcToWorld = glm::inverse(projection * camera);
  view.ndcToLogical = glm::inverse(projection * camera * logicalToWorld(hierarchy));
  view.width = width;
  view.height = height;
  return view;
}
}
}
