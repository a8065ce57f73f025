// SPDX-License-Identifier: BSD-3-Clause
// A transfer function of two variables, as vtkVolumeProperty's: a picture that is looked up.
#ifndef ExaBricksCoreTransferFunction2D_h
#define ExaBricksCoreTransferFunction2D_h

#include "Core/TransferFunction.h"

#include <glm/vec4.hpp>
#include <vector>

namespace exabricks
{
/// Both variables go from 0 to 1 over the picture; between the middles of its pixels colours and
/// opacities are bilinear, outside of them constant, as a texture that is clamped to its edge.
struct TransferFunction2D
{
  int width = 0;  // pixels, along the first variable
  int height = 0; // along the second
  /// [height][width], the first variable runs fastest: red, green, blue, opacity of the unit
  /// distance, in [0, 1].
  std::vector<glm::vec4> pixels;

  bool empty() const { return this->pixels.empty(); }
  glm::dvec4 evaluate(double first, double second) const;
  /// The greatest opacity of each first variable, in white.
  TransferFunction envelope() const;
};

inline bool operator==(const TransferFunction2D& a, const TransferFunction2D& b)
{
  return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}
}

#endif
