// SPDX-License-Identifier: BSD-3-Clause
// A picture to take: the camera as matrices, without VTK and Vulkan.
#ifndef ExaBricksReferenceView_h
#define ExaBricksReferenceView_h

#include "Core/Hierarchy.h"
#include "Reference/Cut.h"

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
  Cut cut;
};

/// Logical to world coordinates.
glm::dmat4 logicalToWorld(const Hierarchy& hierarchy);

/// A camera as VTK has it. Positions are world lengths from the hierarchy's origin, so that they
/// keep their digits however far away that is.
struct Camera
{
  glm::dvec3 position{ 0.0, 0.0, 1.0 };
  glm::dvec3 focalPoint{ 0.0 };
  glm::dvec3 viewUp{ 0.0, 1.0, 0.0 };
  double viewAngle = 30.0;    // degrees, of the picture's height; 0: parallel
  double parallelScale = 1.0; // half the height that a parallel projection shows
  double nearest = 0.01;      // clipping range
  double farthest = 1000.0;
};

/// Looks along `direction` (world) at the middle of `bounds` (logical), so that all of it is seen
/// in a picture of this aspect (width to height).
Camera frame(const Hierarchy& hierarchy, const Box& bounds, const glm::dvec3& direction,
  double viewAngle, double aspect);
View makeView(const Hierarchy& hierarchy, const Camera& camera, int width, int height);

/// The two together. Looks along `direction` (world) at the middle of `bounds` (logical), so that
/// all of it is seen. `viewAngle` in degrees; 0: parallel.
View lookAt(const Hierarchy& hierarchy, const Box& bounds, const glm::dvec3& direction,
  double viewAngle, int width, int height);
}
}

#endif
