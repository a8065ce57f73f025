// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/Body.h"

#include "Scenes/Noise.h"

namespace exabricks
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int AroundRod = 48; // points of a circle

double distanceTo(const Rod& rod, const glm::dvec3& p)
{
  const glm::dvec3 axis = rod.to - rod.from;
  const double length = glm::length(axis);
  const double along = glm::dot(p - rod.from, axis) / length;
  const double fraction = std::clamp(along / length, 0.0, 1.0);
  const double radius = mix(rod.radiusFrom, rod.radiusTo, fraction);
  if (rod.round)
  {
    return std::max(glm::length(p - rod.from - fraction * axis) - radius, 0.0);
  }
  const double across = glm::length(p - rod.from - (along / length) * axis);
  return std::hypot(std::max(across - radius, 0.0), along - fraction * length);
}

// The span without its sweep, and the direction normal to it and to the chord.
struct WingFrame
{
  glm::dvec3 span;
  glm::dvec3 normal;

  explicit WingFrame(const Wing& wing)
  {
    this->span = wing.tip - wing.root;
    this->span.x = 0.0;
    this->normal = glm::normalize(glm::cross(glm::dvec3(1.0, 0.0, 0.0), this->span));
  }
};

double thicknessAt(const Wing& wing, double fraction)
{
  return wing.thickness * mix(1.0, 1.0 / 3.0, fraction);
}

double distanceTo(const Wing& wing, const glm::dvec3& p)
{
  const WingFrame frame(wing);
  const double length = glm::length(frame.span);
  const double along = glm::dot(p - wing.root, frame.span) / length;
  const double fraction = std::clamp(along / length, 0.0, 1.0);
  const glm::dvec3 q = p - wing.root - fraction * (wing.tip - wing.root);
  const double chord = mix(wing.rootChord, wing.tipChord, fraction);
  const double ahead = std::max(std::abs(q.x) - chord, 0.0);
  const double above =
    std::max(std::abs(glm::dot(q, frame.normal)) - thicknessAt(wing, fraction), 0.0);
  return glm::length(glm::dvec3(ahead, above, along - fraction * length));
}

// Adds a band between two rings of points, of which `lower` and `upper` are the first.
void joinRings(TriangleMesh& mesh, int lower, int upper, int points)
{
  for (int i = 0; i < points; ++i)
  {
    const int next = (i + 1) % points;
    mesh.triangles.emplace_back(lower + i, lower + next, upper + next);
    mesh.triangles.emplace_back(lower + i, upper + next, upper + i);
  }
}

void closeRing(TriangleMesh& mesh, int ring, int points, bool reversed)
{
  for (int i = 1; i + 1 < points; ++i)
  {
    mesh.triangles.emplace_back(reversed ? glm::ivec3(ring, ring + i + 1, ring + i)
                                         : glm::ivec3(ring, ring + i, ring + i + 1));
  }
}

void addRod(const Rod& rod, TriangleMesh& mesh)
{
  const glm::dvec3 axis = glm::normalize(rod.to - rod.from);
  const glm::dvec3 other = std::abs(axis.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 v = glm::cross(axis, u);
  const int begin = static_cast<int>(mesh.points.size());
  int rings = 0;
  const auto addRing = [&](const glm::dvec3& center, double radius)
  {
    for (int i = 0; i < AroundRod; ++i)
    {
      const double turn = 2.0 * Pi * i / AroundRod;
      mesh.points.push_back(center + radius * (std::cos(turn) * u + std::sin(turn) * v));
    }
    ++rings;
  };
  constexpr int capRings = 8;
  for (int i = rod.round ? 0 : capRings; i <= capRings; ++i)
  {
    const double turn = 0.5 * Pi * i / capRings;
    const double back = rod.round ? rod.radiusFrom * std::cos(turn) : 0.0;
    addRing(rod.from - back * axis, rod.radiusFrom * std::max(std::sin(turn), 0.02));
  }
  for (int i = capRings; i >= (rod.round ? 0 : capRings); --i)
  {
    const double turn = 0.5 * Pi * i / capRings;
    const double on = rod.round ? rod.radiusTo * std::cos(turn) : 0.0;
    addRing(rod.to + on * axis, rod.radiusTo * std::max(std::sin(turn), 0.02));
  }
  for (int ring = 0; ring + 1 < rings; ++ring)
  {
    joinRings(mesh, begin + ring * AroundRod, begin + (ring + 1) * AroundRod, AroundRod);
  }
  closeRing(mesh, begin, AroundRod, true);
  closeRing(mesh, begin + (rings - 1) * AroundRod, AroundRod, false);
}

void addWing(const Wing& wing, TriangleMesh& mesh)
{
  const WingFrame frame(wing);
  const int begin = static_cast<int>(mesh.points.size());
  constexpr int points = 16;
  for (const double fraction : { 0.0, 1.0 })
  {
    const glm::dvec3 center = wing.root + fraction * (wing.tip - wing.root);
    const double chord = mix(wing.rootChord, wing.tipChord, fraction);
    for (int i = 0; i < points; ++i)
    {
      const double turn = 2.0 * Pi * i / points;
      mesh.points.push_back(center + glm::dvec3(chord * std::cos(turn), 0.0, 0.0) +
        thicknessAt(wing, fraction) * std::sin(turn) * frame.normal);
    }
  }
  joinRings(mesh, begin, begin + points, points);
  closeRing(mesh, begin, points, true);
  closeRing(mesh, begin + points, points, false);
}
}

double Body::distance(const glm::dvec3& p) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Rod& rod : this->rods)
  {
    least = std::min(least, distanceTo(rod, p));
  }
  for (const Wing& wing : this->wings)
  {
    least = std::min(least, distanceTo(wing, p));
  }
  return least;
}

TriangleMesh Body::mesh() const
{
  TriangleMesh mesh;
  for (const Rod& rod : this->rods)
  {
    addRod(rod, mesh);
  }
  for (const Wing& wing : this->wings)
  {
    addWing(wing, mesh);
  }
  return mesh;
}

double wakeOf(const Rod& rod, const glm::dvec3& p, double length)
{
  glm::dvec3 across = rod.to - rod.from;
  across.x = 0.0;
  const double fraction =
    std::clamp(glm::dot(p - rod.from, across) / std::max(glm::dot(across, across), 1e-9), 0.0, 1.0);
  const glm::dvec3 q = p - rod.from - fraction * (rod.to - rod.from);
  const double radius = mix(rod.radiusFrom, rod.radiusTo, fraction);
  if (q.x < -radius)
  {
    return 0.0;
  }
  // Vortices leave the two sides in turn, so that the wake swings.
  const double swing = radius * std::sin(q.x / (1.3 * radius)) * smoothStep(0.0, 4.0 * radius, q.x);
  const double aside = glm::length(glm::dvec3(0.0, q.y - 0.6 * swing, q.z));
  return smoothStep(-radius, radius, q.x) * gaussian(aside, radius + 0.09 * std::max(q.x, 0.0)) *
    std::exp(-std::max(q.x, 0.0) / length);
}
}
