// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Projection.h"

#include "Reference/Mixture.h"

namespace exabricks
{
namespace reference
{
Image project(const FieldFunction& field, const Box& bounds, const View& view,
  const TransferFunction& transfer, const ProjectionSettings& settings)
{
  // A mixture of one component.
  Medium medium;
  medium.functions = { transfer };
  MixtureSettings mixture;
  mixture.blending = settings.blending;
  mixture.averageRanges[0] = settings.averageRange;
  mixture.opacityUnitDistance = settings.opacityUnitDistance;
  mixture.step = settings.step;
  return drawMixture({ field }, bounds, view, medium, mixture);
}
}
}
