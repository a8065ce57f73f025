// SPDX-License-Identifier: BSD-3-Clause
// Impact: an asteroid falls into deep water. Three times of one scene: a narrow plume just after
// entry, a crown splash, and a wide wave under a mushroom of steam.
#include "Scenes/Makers.h"
#include "Scenes/Noise.h"
#include "Scenes/Refinement.h"

namespace exabricks
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
const glm::dvec3 SceneSize{ 2.0, 1.2, 1.4 };
const glm::dvec3 Entry{ 1.0, 0.35, 0.7 }; // where it hits the surface
constexpr double Sea = 0.35;

struct Phase
{
  double craterRadius;
  double craterDepth;
  double crownHeight;
  double crownFlare; // how far the crown leans outward
  double plumeRadius;
  double plumeHeight;
  double capRadius;  // of the mushroom
  double waveRadius; // how far the waves have come
  double waveHeight;
  double trail;       // strength of the asteroid's trail through the air
  double stir;        // displacement by turbulence
  double noiseLength; // of the refinement
  double reach;       // of the refinement around what is seen
  double leavesPerCoarseCell;
};

const Phase phases[3] = {
  { 0.10, 0.12, 0.10, 0.05, 0.045, 0.45, 0.0, 0.16, 0.01, 1.0, 0.014, 0.82, 1.5, 3.8 },
  { 0.30, 0.20, 0.34, 0.14, 0.090, 0.70, 0.12, 0.42, 0.03, 0.4, 0.022, 0.85, 1.0, 4.90 },
  { 0.12, 0.05, 0.05, 0.10, 0.130, 0.60, 0.33, 0.85, 0.07, 0.0, 0.035, 1.85, 1.0, 4.43 },
};

// How far a place is from each part, in units of the scene; below 0 it is inside.
struct Distances
{
  double water;
  double crown;
  double plume;
  double trail;
};

Distances findDistances(const Phase& phase, const glm::dvec3& position)
{
  const glm::dvec3 p = position - Entry;
  const double r = std::hypot(p.x, p.z);
  const double h = position.y - Sea;
  const double turn = std::atan2(p.z, p.x);
  const glm::dvec3 around(3.0 * std::cos(turn), 3.0 * std::sin(turn), 0.0);
  const double ragged = smoothNoise(around * 2.0 + 9.0, 5) - 0.5;

  Distances distances;
  const double crater = -phase.craterDepth * gaussian(r, phase.craterRadius);
  const double waves = phase.waveHeight * std::cos(2.0 * Pi * (r / phase.waveRadius) * 2.5) *
    smoothStep(phase.waveRadius * 1.05, phase.waveRadius * 0.9, r) *
    smoothStep(0.0, phase.craterRadius * 1.5, r);
  const double swell = 0.006 * (smoothNoise(position * 9.0, 6) - 0.5);
  distances.water = h - crater - waves - swell;

  // A sheet of water that leans outward and gets thinner, with fingers at its rim.
  const double up = std::max(h, 0.0) / phase.crownHeight;
  const double top = 1.0 + 0.8 * ragged;
  const double wall = phase.craterRadius * (1.05 + 0.25 * ragged) + phase.crownFlare * up * up;
  distances.crown = std::max({ std::abs(r - wall) - 0.022 * (1.3 - std::min(up, 1.2)),
    (up - top) * phase.crownHeight, -h - 0.02 });

  const double fraction = std::clamp(h / phase.plumeHeight, -0.2, 2.0);
  const double column = phase.plumeRadius * (0.75 + 0.5 * std::max(fraction, 0.0));
  distances.plume = std::max({ r - column, h - phase.plumeHeight, -h - 0.5 * phase.craterDepth });
  if (phase.capRadius > 0.0)
  {
    const glm::dvec3 fromCap = glm::dvec3(r, 1.9 * (h - phase.plumeHeight), 0.0);
    distances.plume = std::min(distances.plume, glm::length(fromCap) - phase.capRadius);
  }

  // It came along this line.
  const glm::dvec3 line = glm::normalize(glm::dvec3(-0.8, 0.75, 0.1));
  const double along = glm::dot(p, line);
  distances.trail =
    along > 0.0 && phase.trail > 0.0 ? glm::length(p - along * line) - 0.018 - 0.03 * along : 1.0;
  return distances;
}

// From 1 inside to 0 outside, over a width.
double inside(double distance, double width) { return smoothStep(width, -width, distance); }

double impactValue(const Phase& phase, const glm::dvec3& p, double width)
{
  const double length = 0.16;
  const double rough = turbulence(p / length, octavesFor(length, width), 41);
  const Distances distances = findDistances(phase,
    p + randomDisplacement(p * 9.0, phase.stir, 42) +
      randomDisplacement(p * 23.0, 0.5 * phase.stir, 43));
  const double sharp = std::max(1.2 * width, 0.004);
  double value = 0.05 + 0.04 * smoothNoise(p * 5.0, 8);
  value = mix(value, 0.2 + 0.1 * rough, phase.trail * inside(distances.trail, 0.02));
  value = mix(value, 0.34 - 0.08 * (Sea - p.y) / Sea, inside(distances.water, sharp));
  value = mix(value, 0.42 + 0.16 * rough, inside(distances.crown, sharp));
  const double heat = smoothStep(0.0, -0.9 * phase.plumeRadius, distances.plume);
  return mix(value, 0.5 + 0.38 * heat + 1.1 * (rough - 0.5), inside(distances.plume, 3.0 * sharp));
}

double impactCriterion(const Phase& phase, const glm::dvec3& p, int level)
{
  const Distances distances = findDistances(phase, p);
  const double reach[] = { 0.13, 0.09, 0.07 };
  const double near = phase.reach * reach[level];
  const double surface = 0.75 * gaussian(distances.water, 0.6 * near);
  const double splash = gaussian(std::max(distances.crown, 0.0), near);
  const double steam = gaussian(std::max(distances.plume, 0.0), near);
  const double trail = 0.8 * phase.trail * gaussian(std::max(distances.trail, 0.0), 0.5 * near);
  const double most = std::max(std::max(surface, splash), std::max(steam, trail));
  return 0.45 * smoothStep(0.2, 0.8, most);
}
}

StandIn makeImpact(StandInKind kind, std::uint64_t leafCells)
{
  const Phase& phase = phases[static_cast<int>(kind) - static_cast<int>(StandInKind::Impact5K)];
  Recipe recipe;
  recipe.size = SceneSize;
  recipe.levels = 4;
  recipe.criterion = [&phase](const glm::dvec3& p, int level)
  { return impactCriterion(phase, p, level); };
  recipe.blockingFactor = 2;
  recipe.noiseLength = phase.noiseLength;
  recipe.seed = 2;
  StandIn made = standInOf(kind, refineCells(recipe, phase.leavesPerCoarseCell, leafCells),
    [&phase](const glm::dvec3& p, double width) { return impactValue(phase, p, width); });
  made.transfer =
    TransferFunction({ { 0.0, { 0.1, 0.1, 0.3, 0.0 } }, { 0.14, { 0.5, 0.5, 0.5, 0.0 } },
      { 0.2, { 0.7, 0.65, 0.6, 0.05 } }, { 0.23, { 0.3, 0.5, 0.8, 0.02 } },
      { 0.26, { 0.1, 0.3, 0.7, 0.02 } }, { 0.33, { 0.1, 0.4, 0.8, 0.04 } },
      { 0.345, { 0.2, 0.6, 0.9, 0.25 } }, { 0.37, { 0.4, 0.8, 0.9, 0.0 } },
      { 0.42, { 0.8, 0.9, 1.0, 0.1 } }, { 0.5, { 0.9, 0.95, 1.0, 0.35 } },
      { 0.6, { 0.9, 0.8, 0.6, 0.02 } }, { 0.72, { 1.0, 0.5, 0.1, 0.2 } },
      { 0.85, { 1.0, 0.8, 0.2, 0.8 } }, { 1.0, { 1.0, 1.0, 0.8, 0.95 } } });
  made.opacityUnitDistance = 0.03;
  made.camera.position = { 2.1, 1.15, 3.6 };
  made.camera.focalPoint = { 1.0, 0.5, 0.7 };
  made.camera.viewAngle = 28.0;
  return made;
}
}
