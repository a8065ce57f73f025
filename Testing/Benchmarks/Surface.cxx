// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

namespace exabricks
{
namespace benchmarks
{
namespace
{
double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// `corners`: pixels and window depth.
void drawTriangle(
  const std::array<glm::dvec3, 3>& corners, int width, int height, std::vector<float>& depth)
{
  const glm::dvec2 a(corners[0]);
  const glm::dvec2 b(corners[1]);
  const glm::dvec2 c(corners[2]);
  const double area = cross(b - a, c - a);
  const glm::dvec2 lo = glm::min(a, glm::min(b, c));
  const glm::dvec2 hi = glm::max(a, glm::max(b, c));
  // NaN does not get in here either.
  if (!(std::abs(area) > 0.0) || !(hi.x > 0.0 && hi.y > 0.0 && lo.x < width && lo.y < height))
  {
    return;
  }
  const auto first = [](double least) { return std::max(0, static_cast<int>(std::floor(least))); };
  const int endX = static_cast<int>(std::min<double>(width, std::ceil(hi.x)));
  const int endY = static_cast<int>(std::min<double>(height, std::ceil(hi.y)));
  for (int y = first(lo.y); y < endY; ++y)
  {
    for (int x = first(lo.x); x < endX; ++x)
    {
      const glm::dvec2 p(x + 0.5, y + 0.5);
      const double u = cross(b - p, c - p) / area;
      const double v = cross(c - p, a - p) / area;
      const double w = 1.0 - u - v;
      if (u >= 0.0 && v >= 0.0 && w >= 0.0)
      {
        float& nearest = depth[x + static_cast<std::size_t>(width) * y];
        const double z = u * corners[0].z + v * corners[1].z + w * corners[2].z;
        nearest = std::min(nearest, static_cast<float>(std::max(z, 0.0)));
      }
    }
  }
}
}

std::vector<float> drawDepth(const Surface& surface, const reference::View& view)
{
  std::vector<float> depth(static_cast<std::size_t>(view.width) * view.height, 1.0f);
  const glm::dmat4 worldToNdc = glm::inverse(view.ndcToWorld);
  const glm::dvec3 pixels(0.5 * view.width, 0.5 * view.height, 0.5);
  for (const glm::ivec3& triangle : surface.triangles)
  {
    std::array<glm::dvec3, 3> corners;
    bool before = true;
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec4 clip = worldToNdc * glm::dvec4(surface.points[triangle[i]], 1.0);
      before = before && clip.w > 0.0;
      corners[i] = pixels * (glm::dvec3(clip) / clip.w + 1.0);
    }
    if (before)
    {
      drawTriangle(corners, view.width, view.height, depth);
    }
  }
  return depth;
}
}
}
