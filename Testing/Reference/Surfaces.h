// SPDX-License-Identifier: BSD-3-Clause
// What pictures of iso-surfaces ought to be: brute force, by many samples along each ray in double
// precision, at equal distances. Between two of them surfaces are passed where the value is on the
// other side.
#ifndef ExaBricksReferenceSurfaces_h
#define ExaBricksReferenceSurfaces_h

#include "Core/TransferFunction.h"
#include "Reference/FieldFunction.h"

namespace exabricks
{
namespace reference
{
/// Unlit, each with the colour and opacity of its value. `isoValues`: normalised, ascending;
/// `step`: of the samples, in the finest cells. `bounds`: logical; outside of them nothing is
/// sampled. The view's depth and cut do not count.
Image drawSurfaces(const FieldFunction& field, const Box& bounds, const View& view,
  const TransferFunction& transfer, const std::vector<double>& isoValues, double step = 1.0 / 64.0);
}
}

#endif
