// SPDX-License-Identifier: BSD-3-Clause
// What a place of the field looks like under lights (Core/Lighting.h), in double precision.
#ifndef ExaBricksReferenceLit_h
#define ExaBricksReferenceLit_h

#include "Core/Box.h"
#include "Core/Lighting.h"
#include "Reference/FieldFunction.h"

#include <glm/matrix.hpp>
#include <vector>

namespace exabricks
{
namespace reference
{
/// By differences, by logical coordinates. One-sided beside places where nothing is; in the
/// outermost half cell, where the field is constant along an axis, its slope goes on.
glm::dvec3 findGradient(const FieldFunction& field, const Box& bounds, const glm::dvec3& place);

/// What lighting with scattering wants to know of a place's medium.
struct LitMedium
{
  double opacityOfUnit = 0.0;
  std::vector<double> shares{}; // how much comes through it, [light]
};

/// Where things are: from logical coordinates to the world of lights, whose origin is the lower
/// corner of the data's bounds.
struct LitSpace
{
  /// `logicalToWorld`: affine, to the data's own coordinates.
  LitSpace(const glm::dmat4& logicalToWorld, const Box& bounds, const glm::dmat3& dataToWorld);

  /// Of the magnitude of gradients: normalised values over the mean width of a finest cell.
  double magnitudeOf(const glm::dvec3& gradient) const;
  /// `color`, lit, of the material. `gradient`: by logical coordinates; `path`: of the ray,
  /// logical.
  glm::dvec3 shade(const glm::dvec3& color, const Lighting& lighting, const Material& material,
    const glm::dvec3& place, const glm::dvec3& gradient, const glm::dvec3& path,
    const LitMedium& medium = {}) const;

  glm::dmat3 logicalToData;
  glm::dmat3 toWorld;
  glm::dmat3 gradientToWorld;
  glm::dvec3 spacing;
  glm::dvec3 corner; // logical
};
}
}

#endif
