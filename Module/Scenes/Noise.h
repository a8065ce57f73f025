// SPDX-License-Identifier: BSD-3-Clause
// Noise that is equal on every machine.
#ifndef ExaBricksScenesNoise_h
#define ExaBricksScenesNoise_h

#include "Core/Box.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
/// In [0, 1), without correlation between lattice points.
inline double whiteNoise(const Int3& p, std::uint32_t seed)
{
  std::uint64_t h = static_cast<std::uint64_t>(p.x) * 0x9e3779b97f4a7c15u ^
    static_cast<std::uint64_t>(p.y) * 0xc2b2ae3d27d4eb4fu ^
    static_cast<std::uint64_t>(p.z) * 0x165667b19e3779f9u ^ (seed * 0xd6e8feb86659fd93u);
  h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
  h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
  return static_cast<double>((h ^ (h >> 32)) >> 11) / 9007199254740992.0;
}

inline double smoothStep(double from, double to, double x)
{
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

inline double mix(double a, double b, double share) { return a + (b - a) * share; }

/// 1 at 0, 1/e at `width`.
inline double bell(double x, double width) { return std::exp(-(x * x) / (width * width)); }

/// In [0, 1], smooth, correlated over a length of 1.
inline double smoothNoise(const glm::dvec3& p, std::uint32_t seed)
{
  const glm::dvec3 floor = glm::floor(p);
  const glm::dvec3 f = p - floor;
  const glm::dvec3 t = f * f * (3.0 - 2.0 * f);
  const Int3 c(floor);
  const auto along = [&](int y, int z)
  { return mix(whiteNoise(c + Int3(0, y, z), seed), whiteNoise(c + Int3(1, y, z), seed), t.x); };
  return mix(mix(along(0, 0), along(1, 0), t.y), mix(along(0, 1), along(1, 1), t.y), t.z);
}

/// Octaves of turbulence whose longest waves are `length` that cells of `width` can hold.
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
    // turned, so that the lattices of the octaves do not show
    p = glm::dvec3(1.6 * p.x + 1.2 * p.y, 1.6 * p.y - 1.2 * p.x, 2.0 * p.z) + 17.3;
  }
  return sum / weight;
}

/// Up to 1 where two sheets of noise meet: threads in space, `waves` in a unit length.
inline double threads(const glm::dvec3& p, double waves, double width, std::uint32_t seed)
{
  const double a = smoothNoise(p * waves, seed) - 0.5;
  const double b = smoothNoise(p * waves + 5.5, seed + 50) - 0.5;
  return std::exp(-(a * a + b * b) / (width * width));
}

/// A displacement of up to `amount` along each axis.
inline glm::dvec3 wander(const glm::dvec3& p, double amount, std::uint32_t seed)
{
  return amount *
    (2.0 *
        glm::dvec3(smoothNoise(p, seed), smoothNoise(p, seed + 101), smoothNoise(p, seed + 202)) -
      1.0);
}
}

#endif
