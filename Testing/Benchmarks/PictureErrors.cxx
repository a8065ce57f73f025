// SPDX-License-Identifier: BSD-3-Clause
#include "PictureErrors.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace exabricks
{
namespace benchmarks
{
namespace
{
double largest(const glm::dvec4& color) { return std::max({ color.r, color.g, color.b }); }

double rootMeanSquareAbove(const reference::Image& a, const reference::Image& b, double least)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
  {
    if (std::max(largest(a.pixels[i]), largest(b.pixels[i])) >= least)
    {
      const glm::dvec3 off(a.pixels[i] - b.pixels[i]);
      sum += glm::dot(off, off);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / (3.0 * static_cast<double>(count))) : 0.0;
}
}

double rootMeanSquare(const reference::Image& a, const reference::Image& b)
{
  return rootMeanSquareAbove(a, b, 0.0);
}

double rootMeanSquareOfDrawn(const reference::Image& a, const reference::Image& b)
{
  return rootMeanSquareAbove(a, b, 1.0 / 255.0);
}

double toDecibels(double error) { return -20.0 * std::log10(error); }

double brightest(const reference::Image& image)
{
  double most = 0.0;
  for (const glm::dvec4& pixel : image.pixels)
  {
    most = std::max(most, largest(pixel));
  }
  return most;
}
}
}
