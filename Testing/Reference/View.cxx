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

Camera frame(const Hierarchy& hierarchy, const Box& bounds, const glm::dvec3& direction,
  double viewAngle, double aspect)
{
  const glm::dvec3 lo = hierarchy.spacing * glm::dvec3(bounds.lo);
  const glm::dvec3 hi = hierarchy.spacing * glm::dvec3(bounds.hi);
  const double radius = 0.5 * glm::length(hi - lo);
  const glm::dvec3 forward = glm::normalize(direction);

  Camera camera;
  camera.focalPoint = 0.5 * (lo + hi);
  camera.viewUp = std::abs(forward.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  camera.viewAngle = viewAngle;
  double distance = 2.0 * radius;
  if (viewAngle > 0.0)
  {
    const double half = 0.5 * glm::radians(viewAngle);
    distance = radius / std::sin(std::min(half, std::atan(std::tan(half) * aspect)));
  }
  else
  {
    camera.parallelScale = radius / std::min(aspect, 1.0);
  }
  camera.position = camera.focalPoint - distance * forward;
  camera.nearest = distance - radius;
  camera.farthest = distance + radius;
  return camera;
}

View makeView(const Hierarchy& hierarchy, const Camera& camera, int width, int height)
{
  const double aspect = static_cast<double>(width) / height;
  const double halfHeight = camera.parallelScale;
  const glm::dmat4 projection = camera.viewAngle > 0.0
    ? glm::perspectiveRH_NO(glm::radians(camera.viewAngle), aspect, camera.nearest, camera.farthest)
    : glm::orthoRH_NO(-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight,
        camera.nearest, camera.farthest);
  const glm::dmat4 looking = glm::lookAtRH(camera.position, camera.focalPoint, camera.viewUp);

  View view;
  const glm::dmat4 ndcFromOrigin = glm::inverse(projection * looking);
  view.ndcToWorld = glm::translate(glm::dmat4(1.0), hierarchy.origin) * ndcFromOrigin;
  view.ndcToLogical = glm::scale(glm::dmat4(1.0), 1.0 / hierarchy.spacing) * ndcFromOrigin;
  view.width = width;
  view.height = height;
  return view;
}

View lookAt(const Hierarchy& hierarchy, const Box& bounds, const glm::dvec3& direction,
  double viewAngle, int width, int height)
{
  const double aspect = static_cast<double>(width) / height;
  return makeView(hierarchy, frame(hierarchy, bounds, direction, viewAngle, aspect), width, height);
}
}
}
