// SPDX-License-Identifier: BSD-3-Clause
// How what lies along a ray becomes a colour.
#ifndef ExaBricksCoreBlending_h
#define ExaBricksCoreBlending_h

#include "Core/TransferFunction.h"
#include "Layout.h"

#include <array>
#include <glm/vec2.hpp>

namespace exabricks
{
/// As vtkVolumeMapper's blend modes of these names. v is the normalised value, o(v) its opacity.
enum class Blending
{
  Composite,  // absorption and emission, front to back
  Maximum,    // colour and opacity of the greatest value, at whatever length
  Minimum,    // and of the least
  Average,    // grey: the mean of o(v) v over the length on which v lies in a range; opaque
  Additive,   // grey: the integral of o(v) v over length in unit distances; opaque
  Isosurface, // surfaces of some values, of their colour and opacity; of several components of
              // those of the first one
  Slice       // a plane, of the colour and opacity of the values there
};

/// Whether what is seen is at places along the ray, which have a gradient: extremes and sums are
/// not.
inline bool isOfPlaces(Blending blending)
{
  return blending == Blending::Composite || blending == Blending::Isosurface ||
    blending == Blending::Slice;
}

/// Whether cells without a value can show, in a colour of their own.
inline bool mayShowUndefined(Blending blending)
{
  return blending == Blending::Composite || blending == Blending::Slice;
}

/// Normalised values that count for Average, of each component.
using AverageRanges = std::array<glm::dvec2, layout::MOST_COMPONENTS>;
inline AverageRanges wholeAverageRanges()
{
  AverageRanges ranges;
  ranges.fill({ 0.0, 1.0 });
  return ranges;
}

/// The function that is looked up along a ray. `averageRange`: normalised values that count for
/// Average.
TransferFunction findLookup(
  const TransferFunction& transfer, Blending blending, const glm::dvec2& averageRange);

/// One that is visible where a value matters to the picture. `isoValues`: normalised, ascending.
TransferFunction findVisibility(const TransferFunction& transfer, Blending blending,
  const glm::dvec2& averageRange, const std::vector<double>& isoValues);
}

#endif
