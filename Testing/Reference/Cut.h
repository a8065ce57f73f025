// SPDX-License-Identifier: BSD-3-Clause
// What is cut away of a volume, as a question to each place: the parts of a ray are found by asking
// between any two planes that it crosses.
#ifndef ExaBricksReferenceCut_h
#define ExaBricksReferenceCut_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace exabricks
{
namespace reference
{
/// A part of a ray begin + t * direction.
struct Span
{
  double begin = 0.0;
  double end = 1.0;
};

/// In logical coordinates.
struct Cut
{
  /// Clipping planes: a place p is left where dot(plane, (p, 1)) >= 0 for each.
  std::vector<glm::dvec4> planes;
  /// Cropping, where `cropped`: what is below the lower plane of an axis, between the two, and
  /// behind the upper one is region 0, 1 and 2 along it; shown where bit x + 3 y + 9 z is set.
  bool cropped = false;
  glm::dvec3 lower{ 0.0 };
  glm::dvec3 upper{ 0.0 };
  unsigned int shownRegions = 0;

  bool leaves(const glm::dvec3& logical) const;
  /// What is left between t = 0 and 1, front to back.
  std::vector<Span> partsOf(const glm::dvec3& begin, const glm::dvec3& direction) const;
};
}
}

#endif
