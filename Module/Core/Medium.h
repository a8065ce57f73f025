// SPDX-License-Identifier: BSD-3-Clause
// What several components of a volume look like together.
#ifndef ExaBricksCoreMedium_h
#define ExaBricksCoreMedium_h

#include "Core/TransferFunction2D.h"

#include <algorithm>

namespace exabricks
{
/// As vtkVolumeProperty's independent components, and its dependent ones: two or four of them.
enum class Mixing
{
  Independent,     // each has a function and a weight: extinctions add up
  ColorAndOpacity, // the first component has a colour, the second one an opacity
  RGBA,            // the first three are red, green and blue, the fourth one has an opacity
  /// A function of two variables: of one component and the magnitude of its gradient, as a part of
  /// layout::GREATEST_GRADIENT; or of two components.
  Planar
};

struct Medium
{
  Mixing mixing = Mixing::Independent;
  /// Independent: of each component. ColorAndOpacity: the colours, with an opacity of 1, and the
  /// opacities, in white. RGBA: the opacities alone, in white.
  std::vector<TransferFunction> functions;
  glm::dvec4 weights{ 1.0 }; // of independent components: by which extinctions are multiplied
  /// RGBA: from normalised values to red, green and blue in [0, 1].
  glm::dvec4 colorScale{ 1.0 };
  glm::dvec4 colorOffset{ 0.0 };
  TransferFunction2D planar; // of Mixing::Planar, in place of functions
};

/// Whether both let the same light through.
inline bool areAsOpaque(const Medium& a, const Medium& b)
{
  return a.mixing == b.mixing && a.weights == b.weights && a.planar == b.planar &&
    std::equal(a.functions.begin(), a.functions.end(), b.functions.begin(), b.functions.end(),
      [](const TransferFunction& x, const TransferFunction& y) { return x.isAsOpaqueAs(y); });
}
}

#endif
