// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Image.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
double psnrAbove(const Image& a, const Image& b, double opacity)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
  {
    if (std::max(a.pixels[i].a, b.pixels[i].a) >= opacity)
    {
      const glm::dvec4 difference = a.pixels[i] - b.pixels[i];
      sum += glm::dot(difference, difference);
      ++count;
    }
  }
  return -10.0 * std::log10(count > 0 ? sum / (4.0 * static_cast<double>(count)) : 0.0);
}
}

double psnr(const Image& a, const Image& b) { return psnrAbove(a, b, 0.0); }

double psnrOfDrawn(const Image& a, const Image& b) { return psnrAbove(a, b, 1.0 / 255.0); }
}
}
