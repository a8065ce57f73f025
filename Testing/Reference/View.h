// SPDX-License-Identifier: BSD-3-Clause
// A picture to take: the camera as matrices, without VTK and Vulkan.
#ifndef ExaBricksReferenceView_h
#define ExaBricksReferenceView_h

#include "Core/Hierarchy.h"

#include <glm/mat4x4.hpp>

namespace exabricks
{
namespace reference
{
/// Pixel (i, j) is the ray from z = -1 to z = 1 at NDC (2 (i + 0.5) / width - 1,
/// 2 (j + 0.5) / height - 1).
struct View
{
  glm::dmat4 ndcToLogical{ 1.0 };
  glm::dmat4 ndcToWorld{ 1.0 };
  int width = 0;
  int height = 0;
  std::vector<float> depth; // window depth in [0, 1] where rays end, per pixel; empty: at z = 1
};

/// Logical to world coordinates.
glm::dmat4 logicalToWorld(const Hierarchy& hierarchy);

/// Looks along `direction` (world) at the middle of `bounds` (logical), so that all of it is seen.
/// `viewAngle` in degrees; 0: parallel.
View lookAt(const Hierarchy& hierarchy, const Box& bounds, const glm::dvec3& direction,
  double viewAngle, int width, int height);
}
}

#endif
