// SPDX-License-Identifier: BSD-3-Clause
// Between which depths a box lies, as a camera sees it.
#ifndef ExaBricksCoreDepthRange_h
#define ExaBricksCoreDepthRange_h

#include <algorithm>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace exabricks
{
/// In normalised device coordinates.
struct DepthRange
{
  double from = 1.0;
  double to = -1.0;
  bool allBeforeEye = true; // else the range is that of the corners that are
};

/// Of a box from the origin of half cells on.
inline DepthRange findDepthRange(const glm::dmat4& ndcToHalfCells, const glm::dvec3& size)
{
  const glm::dmat4 toNdc = glm::inverse(ndcToHalfCells);
  const double before = ndcToHalfCells[3].w; // its sign is that of all that is before the eye
  DepthRange range;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 place(
      corner & 1 ? size.x : 0.0, corner & 2 ? size.y : 0.0, corner & 4 ? size.z : 0.0);
    const glm::dvec4 seen = toNdc * glm::dvec4(place, 1.0);
    if (!(before * seen.w > 0.0))
    {
      range.allBeforeEye = false;
      continue;
    }
    range.from = std::min(range.from, seen.z / seen.w);
    range.to = std::max(range.to, seen.z / seen.w);
  }
  return range;
}
}

#endif
