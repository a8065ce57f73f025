// SPDX-License-Identifier: BSD-3-Clause
// Cubic polynomials on [0, 1]: what trilinear interpolation is along a straight line.
#ifndef ExaBricksReferencePolynomial_h
#define ExaBricksReferencePolynomial_h

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

namespace exabricks
{
namespace reference
{
/// c[0] + c[1] s + c[2] s^2 + c[3] s^3
struct Cubic
{
  std::array<double, 4> c{};

  double operator()(double s) const
  {
    return this->c[0] + s * (this->c[1] + s * (this->c[2] + s * this->c[3]));
  }
  Cubic& operator+=(const Cubic& other)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->c[i] += other.c[i];
    }
    return *this;
  }
};

/// Trilinear interpolation of the corners (x fastest) along the line from `begin` to `end`, in
/// shares of the cell.
inline Cubic trilinearAlong(
  const std::array<double, 8>& corners, const glm::dvec3& begin, const glm::dvec3& end)
{
  // a + w(s) (b - a) with w linear raises the degree by one.
  const auto mix = [](const Cubic& a, const Cubic& b, double w0, double w1)
  {
    Cubic result = a;
    for (int i = 0; i < 4; ++i)
    {
      const double d = b.c[i] - a.c[i];
      result.c[i] += w0 * d;
      if (i < 3)
      {
        result.c[i + 1] += (w1 - w0) * d;
      }
    }
    return result;
  };
  Cubic x[4];
  for (int i = 0; i < 4; ++i)
  {
    x[i] = mix({ { corners[2 * i] } }, { { corners[2 * i + 1] } }, begin.x, end.x);
  }
  return mix(mix(x[0], x[1], begin.y, end.y), mix(x[2], x[3], begin.y, end.y), begin.z, end.z);
}

/// Where the cubic changes its sign between 0 and 1, in ascending order. `found`: room for three.
inline int findSignChanges(const Cubic& cubic, std::array<double, 3>& found)
{
  // Between the places where its slope is 0 it changes its sign once at most.
  const double a = 3.0 * cubic.c[3];
  const double b = 2.0 * cubic.c[2];
  const double d = cubic.c[1];
  std::array<double, 4> ends{ 0.0 };
  int last = 0;
  const double discriminant = b * b - 4.0 * a * d;
  if (discriminant > 0.0)
  {
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    double flat[2] = { q / a, d / q };
    if (!(flat[0] < flat[1]))
    {
      std::swap(flat[0], flat[1]);
    }
    for (const double s : flat)
    {
      if (s > 0.0 && s < 1.0)
      {
        ends[++last] = s;
      }
    }
  }
  ends[++last] = 1.0;
  int count = 0;
  for (int i = 0; i < last; ++i)
  {
    double lo = ends[i];
    double hi = ends[i + 1];
    const double atLo = cubic(lo);
    if (!(atLo * cubic(hi) < 0.0))
    {
      continue;
    }
    // Newton's steps, and bisection where they leave the bracket.
    double s = 0.5 * (lo + hi);
    for (int step = 0; step < 64 && hi - lo > 1e-15; ++step)
    {
      const double value = cubic(s);
      (value * atLo > 0.0 ? lo : hi) = s;
      const double slope = d + s * (b + s * a);
      const double next = s - value / slope;
      const double before = s;
      s = next > lo && next < hi ? next : 0.5 * (lo + hi);
      if (std::abs(s - before) < 1e-16)
      {
        break;
      }
    }
    found[count++] = s;
  }
  return count;
}
}
}

#endif
