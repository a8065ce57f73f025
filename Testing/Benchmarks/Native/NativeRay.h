// SPDX-License-Identifier: BSD-3-Clause
// Shaders/Ray.glsl in C++: the ray of a pixel, in half cells.
#ifndef ExaBricksBenchmarksNativeRay_h
#define ExaBricksBenchmarksNativeRay_h

#include "Core/View.h"
#include "Core/Volume.h"
#include "NativeVector.h"

#include <glm/geometric.hpp>

namespace exabricks
{
namespace benchmarks
{
namespace native
{
struct Ray
{
  // Arrays, as the tree takes one axis at a time.
  int base[4];
  float fraction[4];
  float inverse[4];
  Vec4 origin; // the fraction
  Vec4 direction;
  float begin;
  float end;
  float dataPerHalfCell;
};

constexpr float RebaseDistance = 1024.0f;

inline float planeDistance(const Ray& ray, int plane, unsigned axis)
{
  return (static_cast<float>(plane - ray.base[axis]) - ray.fraction[axis]) * ray.inverse[axis];
}

/// The ray of a pixel from `skip` half cells behind its entry into the bounds on. False: a miss.
inline bool makeRay(const View& view, const glm::ivec3& size, int x, int y, double skip, Ray& ray)
{
  const glm::dvec2 ndc(
    2.0 * (x + 0.5) / view.target.width - 1.0, 2.0 * (y + 0.5) / view.target.height - 1.0);
  double far = 1.0;
  if (view.target.depth)
  {
    far = 2.0 * view.target.depth[static_cast<std::size_t>(y) * view.target.width + x] - 1.0;
  }
  const glm::dvec4 a = view.camera.ndcToHalfCells * glm::dvec4(ndc, -1.0, 1.0);
  const glm::dvec4 b = view.camera.ndcToHalfCells * glm::dvec4(ndc, far, 1.0);
  const glm::dvec3 origin = glm::dvec3(a) / a.w;
  const glm::dvec3 path = glm::dvec3(b) / b.w - origin;
  const double pathLength = glm::length(path);
  if (!(pathLength > 0.0))
  {
    return false;
  }
  glm::dvec3 direction = path / pathLength;
  double start = 0.0;
  double end = pathLength;
  for (int axis = 0; axis < 3; ++axis)
  {
    // No component is 0, so that every distance is finite.
    if (std::abs(direction[axis]) < 1e-12)
    {
      direction[axis] = direction[axis] >= 0.0 ? 1e-12 : -1e-12;
    }
    const double toLower = -origin[axis] / direction[axis];
    const double toUpper = (size[axis] - origin[axis]) / direction[axis];
    start = std::max(start, std::min(toLower, toUpper));
    end = std::min(end, std::max(toLower, toUpper));
  }
  start += skip;
  if (!(start < end))
  {
    return false;
  }
  const glm::dvec3 position = origin + start * direction;
  ray.origin = broadcast(0.0f);
  ray.direction = ray.origin;
  ray.base[3] = 0;
  ray.begin = 0.0f;
  ray.end = static_cast<float>(pathLength - start);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    ray.base[axis] = static_cast<int>(std::floor(position[axis]));
    ray.fraction[axis] = static_cast<float>(position[axis] - ray.base[axis]);
    ray.origin[axis] = ray.fraction[axis];
    ray.direction[axis] = static_cast<float>(direction[axis]);
    ray.inverse[axis] = 1.0f / ray.direction[axis];
    const float low = planeDistance(ray, 0, axis);
    const float high = planeDistance(ray, size[axis], axis);
    ray.begin = std::max(ray.begin, std::min(low, high));
    ray.end = std::min(ray.end, std::max(low, high));
  }
  ray.dataPerHalfCell = static_cast<float>(glm::length(view.camera.halfCellsToData * direction));
  return ray.begin < ray.end;
}

/// Two units in the last place less.
inline float beforeRounding(float distance)
{
  return std::nextafter(std::nextafter(distance, 0.0f), 0.0f);
}
}
}
}

#endif
