// SPDX-License-Identifier: BSD-3-Clause
// Pictures in double precision, and how far two of them are apart.
#ifndef ExaBricksReferenceImage_h
#define ExaBricksReferenceImage_h

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

namespace exabricks
{
namespace reference
{
/// Premultiplied red, green, blue, opacity; row 0 at the bottom, x fastest.
struct Image
{
  int width = 0;
  int height = 0;
  std::vector<glm::dvec4> pixels;

  const glm::dvec4& at(int x, int y) const
  {
    return this->pixels[x + static_cast<std::size_t>(this->width) * y];
  }
};

/// Peak signal-to-noise ratio in dB, over red, green, blue and opacity of the whole picture, with a
/// peak of 1. Infinite for equal pictures.
double psnr(const Image& a, const Image& b);
/// The same over the pixels that are drawn alone: those with an opacity of at least 1/255 in either
/// picture, which shows on a screen. Infinite if there are none.
double psnrOfDrawn(const Image& a, const Image& b);
}
}

#endif
