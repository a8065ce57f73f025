// SPDX-License-Identifier: BSD-3-Clause
// What pictures ought to be where blending is not by absorption (Core/Blending.h): brute force, by
// many samples along each ray in double precision, at equal distances.
#ifndef ExaBricksReferenceProjection_h
#define ExaBricksReferenceProjection_h

#include "Core/Blending.h"
#include "Reference/FieldFunction.h"

namespace exabricks
{
namespace reference
{
struct ProjectionSettings
{
  Blending blending = Blending::Maximum;
  double opacityUnitDistance = 1.0;    // world
  glm::dvec2 averageRange{ 0.0, 1.0 }; // normalised
  double step = 1.0 / 32.0;            // in the finest cells
};

/// `bounds`: logical; outside of them nothing is sampled. The view's depth and cut do not count.
Image project(const FieldFunction& field, const Box& bounds, const View& view,
  const TransferFunction& transfer, const ProjectionSettings& settings);
}
}

#endif
