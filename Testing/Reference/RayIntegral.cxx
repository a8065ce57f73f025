// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/RayIntegral.h"

#include <glm/common.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
// Gauss-Legendre quadrature on [0, 1]: nodes, weights, and the integrals from 0 to each node of the
// polynomials that are 1 at one node and 0 at the others.
constexpr int nodes = 5;

struct Quadrature
{
  std::array<double, nodes> at;
  std::array<double, nodes> weight;
  std::array<std::array<double, nodes>, nodes> upTo; // [node][polynomial]

  Quadrature()
  {
    const double inner = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
    const double outer = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
    const double innerWeight = (322.0 + 13.0 * std::sqrt(70.0)) / 900.0;
    const double outerWeight = (322.0 - 13.0 * std::sqrt(70.0)) / 900.0;
    const std::array<double, nodes> x{ -outer, -inner, 0.0, inner, outer };
    const std::array<double, nodes> w{ outerWeight, innerWeight, 128.0 / 225.0, innerWeight,
      outerWeight };
    for (int i = 0; i < nodes; ++i)
    {
      this->at[i] = 0.5 * (1.0 + x[i]);
      this->weight[i] = 0.5 * w[i];
    }
    // The polynomials have degree 4, so that the quadrature itself integrates them exactly.
    for (int i = 0; i < nodes; ++i)
    {
      for (int j = 0; j < nodes; ++j)
      {
        this->upTo[i][j] = 0.0;
        for (int n = 0; n < nodes; ++n)
        {
          double lagrange = 1.0;
          for (int k = 0; k < nodes; ++k)
          {
            if (k != j)
            {
              lagrange *= (this->at[i] * this->at[n] - this->at[k]) / (this->at[j] - this->at[k]);
            }
          }
          this->upTo[i][j] += this->at[i] * this->weight[n] * lagrange;
        }
      }
    }
  }
};

const Quadrature quadrature;
}

struct RayIntegral::Part
{
  const Cubic& numerator;
  const Cubic& denominator;
  const TransferFunction::Point& lower; // the transfer function is the line between these
  const TransferFunction::Point& upper;
  double begin; // of the piece, in [0, 1]
  double end;
  double length; // of the whole piece

  double units(double unit) const { return (this->end - this->begin) * this->length / unit; }
  glm::dvec4 colorAt(double s) const
  {
    if (this->lower.value == this->upper.value)
    {
      return this->lower.color;
    }
    const double value = this->numerator(s) / this->denominator(s);
    const double share = (value - this->lower.value) / (this->upper.value - this->lower.value);
    return glm::mix(this->lower.color, this->upper.color, glm::clamp(share, 0.0, 1.0));
  }
};

void RayIntegral::addConstant(double value, double length)
{
  const glm::dvec4 color = this->Transfer.evaluate(value);
  const double kept = std::pow(1.0 - color.a, length / this->UnitDistance);
  this->Color += this->Transmittance * (1.0 - kept) * glm::dvec4(color.r, color.g, color.b, 1.0);
  this->Transmittance *= kept;
}

void RayIntegral::add(
  const Cubic& numerator, const Cubic& denominator, double least, double most, double length)
{
  const std::vector<TransferFunction::Point>& points = this->Transfer.points();
  std::vector<double> cuts{ 0.0, 1.0 };
  auto point = std::lower_bound(points.begin(), points.end(), least,
    [](const TransferFunction::Point& p, double value) { return p.value < value; });
  for (double before = std::nan(""); point != points.end() && point->value <= most; ++point)
  {
    if (point->value == before)
    {
      continue; // a jump
    }
    before = point->value;
    Cubic off = numerator;
    for (int i = 0; i < 4; ++i)
    {
      off.c[i] -= point->value * denominator.c[i];
    }
    std::array<double, 3> found;
    const int count = findSignChanges(off, found);
    cuts.insert(cuts.end(), found.begin(), found.begin() + count);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size() && !this->opaque(); ++i)
  {
    if (!(cuts[i] < cuts[i + 1]))
    {
      continue;
    }
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    const double value = numerator(middle) / denominator(middle);
    const auto upper = std::upper_bound(points.begin(), points.end(), value,
      [](double v, const TransferFunction::Point& p) { return v < p.value; });
    const TransferFunction::Point& a = upper == points.begin() ? *upper : *(upper - 1);
    const TransferFunction::Point& b = upper == points.end() ? a : *upper;
    if (a.color.a > 0.0 || b.color.a > 0.0)
    {
      this->AddPart({ numerator, denominator, a, b, cuts[i], cuts[i + 1], length }, 0);
    }
  }
}

RayIntegral::Sum RayIntegral::Integrate(const Part& part) const
{
  const double units = part.units(this->UnitDistance);
  std::array<glm::dvec4, nodes> colors; // and optical depth of the part at this extinction
  for (int i = 0; i < nodes; ++i)
  {
    const double s = part.begin + (part.end - part.begin) * quadrature.at[i];
    colors[i] = part.colorAt(s);
    colors[i].a = -std::log1p(-std::min(colors[i].a, 1.0 - 1e-16)) * units; // finite
  }
  Sum sum;
  double opacity = 0.0;
  for (int i = 0; i < nodes; ++i)
  {
    double before = 0.0;
    for (int j = 0; j < nodes; ++j)
    {
      before += quadrature.upTo[i][j] * colors[j].a;
    }
    const double share = quadrature.weight[i] * colors[i].a * std::exp(-before);
    sum.color += share * glm::dvec3(colors[i]);
    sum.depth += quadrature.weight[i] * colors[i].a;
    opacity += share;
  }
  // The opacity is known from the depth; a sum over too few nodes for a dense part misses it.
  sum.error = std::abs(opacity + std::expm1(-sum.depth));
  return sum;
}

void RayIntegral::AddPart(const Part& part, int depth)
{
  if (part.lower.color.a >= 1.0 && part.upper.color.a >= 1.0)
  {
    const glm::dvec4 color = part.colorAt(part.begin);
    this->Color += this->Transmittance * glm::dvec4(color.r, color.g, color.b, 1.0);
    this->Transmittance = 0.0;
    return;
  }
  const double middle = 0.5 * (part.begin + part.end);
  Part first = part;
  first.end = middle;
  Part second = part;
  second.begin = middle;
  const Sum whole = this->Integrate(part);
  const Sum a = this->Integrate(first);
  const Sum b = this->Integrate(second);
  const double between = std::exp(-a.depth);
  const glm::dvec3 color = a.color + between * b.color;
  const glm::dvec3 difference = glm::abs(color - whole.color);
  const double error = this->Transmittance *
    std::max({ difference.r, difference.g, difference.b, a.error + between * b.error,
      std::abs(std::expm1(whole.depth - a.depth - b.depth)) * std::exp(-whole.depth) });
  constexpr int deepest = 50;
  if (!(error <= this->Tolerance * (part.end - part.begin) * part.length) && depth < deepest)
  {
    this->AddPart(first, depth + 1);
    if (!this->opaque())
    {
      this->AddPart(second, depth + 1);
    }
    return;
  }
  const double kept = std::exp(-a.depth - b.depth);
  this->Color += this->Transmittance * glm::dvec4(color, 1.0 - kept);
  this->Transmittance *= kept;
  this->Error += std::isnan(error) ? 1.0 : error;
}
}
}
