// SPDX-License-Identifier: BSD-3-Clause
// Noise that is equal on every machine.
#ifndef ExaBricksScenesNoise_h
#define ExaBricksScenesNoise_h

#include "Core/Box.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
inline double smoothStep(double from, double to, double x)
{
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

inline double mix(double a, double b, double fraction) { return a + (b - a) * fraction; }

/// 1 at 0, 1/e at `width`.
inline double gaussian(double x, double width) { return std::exp(-(x * x) / (width * width)); }

/// The lattice points around a position: random bits of each, and how much it weighs.
struct NoiseCorners
{
  std::uint32_t bits[8];
  double weight[8];

  NoiseCorners(const glm::dvec3& p, std::uint32_t seed)
  {
    // Rounded down by hand, as floor() is a call without SSE4.1.
    const auto below = [](double x)
    {
      const std::int64_t n = static_cast<std::int64_t>(x);
      return n - (x < static_cast<double>(n) ? 1 : 0);
    };
    const Int3 c(below(p.x), below(p.y), below(p.z));
    const glm::dvec3 f = p - glm::dvec3(c);
    const glm::dvec3 t = f * f * (3.0 - 2.0 * f);
    const std::uint32_t x = static_cast<std::uint32_t>(c.x) * 0x9e3779b1u + seed * 0x27d4eb2fu;
    const std::uint32_t y = static_cast<std::uint32_t>(c.y) * 0x85ebca77u;
    const std::uint32_t z = static_cast<std::uint32_t>(c.z) * 0xc2b2ae3du;
    for (unsigned int i = 0; i < 8; ++i)
    {
      std::uint32_t h = (x + (i & 1) * 0x9e3779b1u) ^ (y + ((i >> 1) & 1) * 0x85ebca77u) ^
        (z + (i >> 2) * 0xc2b2ae3du);
      h = (h ^ (h >> 15)) * 0x2c1b3c6du;
      h = (h ^ (h >> 12)) * 0x297a2d39u;
      this->bits[i] = h ^ (h >> 15);
      this->weight[i] =
        ((i & 1) ? t.x : 1.0 - t.x) * ((i & 2) ? t.y : 1.0 - t.y) * ((i & 4) ? t.z : 1.0 - t.z);
    }
  }
};

/// In [0, 1], smooth, correlated over a length of 1.
inline double smoothNoise(const glm::dvec3& p, std::uint32_t seed)
{
  const NoiseCorners corners(p, seed);
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    sum += corners.weight[i] * corners.bits[i];
  }
  return sum / 4294967295.0;
}

/// How many octaves of turbulence, whose longest waves are `length`, cells of `width` can hold.
inline int octavesFor(double length, double width)
{
  return std::clamp(static_cast<int>(std::log2(length / (2.0 * width))) + 1, 1, 7);
}

/// In [0, 1], around 0.5: waves of length 1 and shorter.
inline double turbulence(glm::dvec3 p, int octaves, std::uint32_t seed)
{
  double sum = 0.0;
  double weight = 0.0;
  double amplitude = 1.0;
  for (int octave = 0; octave < octaves; ++octave)
  {
    sum += amplitude * smoothNoise(p, seed + octave);
    weight += amplitude;
    amplitude *= 0.55;
    // Each octave is turned, so that their lattices do not show.
    p = glm::dvec3(1.6 * p.x + 1.2 * p.y, 1.6 * p.y - 1.2 * p.x, 2.0 * p.z) + 17.3;
  }
  return sum / weight;
}

/// Up to 1 where two sheets of noise meet: threads in space, `waves` in a unit length.
inline double filaments(const glm::dvec3& p, double waves, double width, std::uint32_t seed)
{
  const double a = smoothNoise(p * waves, seed) - 0.5;
  const double b = smoothNoise(p * waves + 5.5, seed + 50) - 0.5;
  return std::exp(-(a * a + b * b) / (width * width));
}

/// A displacement of up to `amount` along each axis.
inline glm::dvec3 randomDisplacement(const glm::dvec3& p, double amount, std::uint32_t seed)
{
  const NoiseCorners corners(p, seed);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < 8; ++i)
  {
    const std::uint32_t h = corners.bits[i];
    sum += corners.weight[i] * glm::dvec3(h & 1023, (h >> 10) & 1023, (h >> 20) & 1023);
  }
  return amount * (2.0 / 1023.0 * sum - 1.0);
}
}

#endif
