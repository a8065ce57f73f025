// SPDX-License-Identifier: BSD-3-Clause
// What pictures of several components ought to be (Core/Medium.h): brute force, by many samples
// along each ray in double precision, at equal distances.
#ifndef ExaBricksReferenceMixture_h
#define ExaBricksReferenceMixture_h

#include "Core/Blending.h"
#include "Core/Medium.h"
#include "Reference/Lit.h"

namespace exabricks
{
namespace reference
{
struct MixtureSettings
{
  Blending blending = Blending::Composite; // all but Isosurface and Slice
  AverageRanges averageRanges = wholeAverageRanges();
  std::optional<Lighting> lighting; // none: colours as they are
  /// As ShadedSettings has it, of each function of opacity; empty: by 1.
  std::vector<std::function<double(double)>> gradientOpacity;
  glm::dmat4 logicalToWorld{ 1.0 }; // affine
  double opacityUnitDistance = 1.0; // world
  double step = 1.0 / 32.0;         // in the finest cells
};

/// `components`: of each, in their order; asked from several threads. `bounds`: logical; outside of
/// them nothing is sampled. The view's depth and cut do not count.
Image drawMixture(const std::vector<FieldFunction>& components, const Box& bounds, const View& view,
  const Medium& medium, const MixtureSettings& settings);
}
}

#endif
