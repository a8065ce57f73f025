// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Similarity.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace exabricks
{
namespace reference
{
namespace
{
constexpr int Window = 11;
using Weights = std::array<double, Window>;

Weights gaussianWeights()
{
  Weights weights;
  double sum = 0.0;
  for (int i = 0; i < Window; ++i)
  {
    const double off = (i - Window / 2) / 1.5;
    weights[i] = std::exp(-0.5 * off * off);
    sum += weights[i];
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

// As in the paper's program. Colours are premultiplied: over black they are what is seen.
double luminance(const glm::dvec4& color)
{
  return glm::dot(glm::dvec3(color), glm::dvec3(0.299, 0.587, 0.114));
}

// Of the two luminances: means, means of squares, mean of the product.
using Moments = std::array<double, 5>;

void add(Moments& to, const Moments& moments, double weight)
{
  for (std::size_t i = 0; i < to.size(); ++i)
  {
    to[i] += weight * moments[i];
  }
}
}

double structuralSimilarity(const Image& a, const Image& b)
{
  if (a.width != b.width || a.height != b.height || a.width < Window || a.height < Window)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const Weights weights = gaussianWeights();
  const int columns = a.width - Window + 1;
  const int rows = a.height - Window + 1;

  // The weights are a product: first along x, then along y.
  std::vector<Moments> alongX(static_cast<std::size_t>(columns) * a.height, Moments{});
  for (int y = 0; y < a.height; ++y)
  {
    for (int x = 0; x < columns; ++x)
    {
      for (int i = 0; i < Window; ++i)
      {
        const double p = luminance(a.at(x + i, y));
        const double q = luminance(b.at(x + i, y));
        add(alongX[x + static_cast<std::size_t>(columns) * y], { p, q, p * p, q * q, p * q },
          weights[i]);
      }
    }
  }

  constexpr double c1 = 0.01 * 0.01;
  constexpr double c2 = 0.03 * 0.03;
  double sum = 0.0;
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < columns; ++x)
    {
      Moments m{};
      for (int i = 0; i < Window; ++i)
      {
        add(m, alongX[x + static_cast<std::size_t>(columns) * (y + i)], weights[i]);
      }
      const double variances = m[2] - m[0] * m[0] + m[3] - m[1] * m[1];
      const double covariance = m[4] - m[0] * m[1];
      sum += (2.0 * m[0] * m[1] + c1) * (2.0 * covariance + c2) /
        ((m[0] * m[0] + m[1] * m[1] + c1) * (variances + c2));
    }
  }
  return sum / (static_cast<double>(columns) * rows);
}
}
}
