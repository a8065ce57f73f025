// SPDX-License-Identifier: BSD-3-Clause
// How large cells are in a picture.
#ifndef ExaBricksCoreCellsInPicture_h
#define ExaBricksCoreCellsInPicture_h

#include "Core/View.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace exabricks
{
/// The longest of a half cell's sides at any corner of the bounds, pixels. Infinite where a corner
/// is not before the eye, as then cells are near to it. `size`: of the bounds, half cells.
inline double findLargestHalfCell(const View& view, const glm::dvec3& size)
{
  const glm::dmat4 toNdc = glm::inverse(view.camera.ndcToHalfCells);
  const double before = view.camera.ndcToHalfCells[3].w; // its sign is that of all before the eye
  const glm::dvec2 toPixels(0.5 * view.target.width, 0.5 * view.target.height);
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 place(
      corner & 1 ? size.x : 0.0, corner & 2 ? size.y : 0.0, corner & 4 ? size.z : 0.0);
    const glm::dvec4 seen = toNdc * glm::dvec4(place, 1.0);
    if (!(before * seen.w > 0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // The derivative of the place in the picture along the axis.
      const glm::dvec2 moved =
        (glm::dvec2(toNdc[axis]) - glm::dvec2(seen) / seen.w * toNdc[axis].w) / seen.w;
      largest = std::max(largest, glm::length(moved * toPixels));
    }
  }
  return largest;
}
}

#endif
