// SPDX-License-Identifier: BSD-3-Clause
// What shaded pictures ought to be (Core/Lighting.h), and those with opacity by gradients: brute
// force, by many samples along each ray and differences of the field in double precision.
#ifndef ExaBricksReferenceShaded_h
#define ExaBricksReferenceShaded_h

#include "Core/TransferFunction.h"
#include "Reference/Image.h"
#include "Reference/Lit.h"
#include "Reference/View.h"

#include <functional>
#include <optional>

namespace exabricks
{
namespace reference
{
struct ShadedSettings
{
  std::optional<Lighting> lighting; // none: colours as they are
  /// By what the extinction is multiplied, of the magnitude of the gradient in normalised values
  /// over the mean width of a finest cell; null: by 1.
  std::function<double(double)> gradientOpacity;
  double opacityUnitDistance = 1.0; // world
  double step = 1.0 / 32.0;         // in the finest cells
  double shadowStep = 1.0 / 4.0;    // of rays to lights
};

/// `logicalToWorld`: affine. The view's depth and cut do not count. `field` may be asked from
/// several threads.
Image renderShaded(const FieldFunction& field, const Box& bounds, const View& view,
  const glm::dmat4& logicalToWorld, const TransferFunction& transfer,
  const ShadedSettings& settings);
}
}

#endif
