// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Cut.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
bool Cut::leaves(const glm::dvec3& logical) const
{
  int region = 0;
  for (int axis = 0, weight = 1; axis < 3; ++axis, weight *= 3)
  {
    region += weight *
      (logical[axis] < this->lower[axis]      ? 0
          : logical[axis] < this->upper[axis] ? 1
                                              : 2);
  }
  return (!this->cropped || (this->shownRegions >> region & 1u)) &&
    std::all_of(this->planes.begin(), this->planes.end(),
      [&](const glm::dvec4& plane) { return glm::dot(plane, glm::dvec4(logical, 1.0)) >= 0.0; });
}

std::vector<Span> Cut::partsOf(const glm::dvec3& begin, const glm::dvec3& direction) const
{
  std::vector<double> crossings{ 0.0, 1.0 };
  const auto addCrossing = [&](const glm::dvec4& plane)
  {
    const double slope = glm::dot(glm::dvec3(plane), direction);
    const double t = -glm::dot(plane, glm::dvec4(begin, 1.0)) / slope;
    if (t > 0.0 && t < 1.0) // not so where the slope is 0
    {
      crossings.push_back(t);
    }
  };
  for (const glm::dvec4& plane : this->planes)
  {
    addCrossing(plane);
  }
  for (int axis = 0; axis < 3 && this->cropped; ++axis)
  {
    for (const double at : { this->lower[axis], this->upper[axis] })
    {
      glm::dvec4 plane(0.0, 0.0, 0.0, -at);
      plane[axis] = 1.0;
      addCrossing(plane);
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Span> parts;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i)
  {
    if (this->leaves(begin + 0.5 * (crossings[i] + crossings[i + 1]) * direction))
    {
      parts.push_back({ crossings[i], crossings[i + 1] });
    }
  }
  return parts;
}
}
}
