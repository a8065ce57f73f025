// SPDX-License-Identifier: BSD-3-Clause
// Cloud: a molecular cloud of filaments in a near-empty cube, as of a simulation of star formation.
#include "Scenes/Makers.h"
#include "Scenes/Noise.h"
#include "Scenes/Refinement.h"

namespace exabricks
{
namespace
{
// How much of the cloud is at a place, in [0, 1]: 0 in the empty space around it.
double envelope(const glm::dvec3& p)
{
  const glm::dvec3 q = (p - 0.5) * glm::dvec3(1.0, 1.25, 1.1);
  const double noise = 0.5 * smoothNoise(p * 3.1, 3) + 0.5 * smoothNoise(p * 6.3, 4);
  return smoothStep(0.54, 0.15, glm::length(q) + 0.45 * (noise - 0.5));
}

glm::dvec3 stirred(const glm::dvec3& p)
{
  return p + randomDisplacement(p * 3.0, 0.09, 11) + randomDisplacement(p * 7.0, 0.03, 12);
}

double cloudValue(const glm::dvec3& p, double width)
{
  const double inside = envelope(p);
  if (inside <= 0.0)
  {
    return 0.02 * smoothNoise(p * 4.0, 9);
  }
  const glm::dvec3 q = stirred(p);
  const double gas = turbulence(q * 6.0, octavesFor(1.0 / 6.0, width), 21);
  const double filament =
    std::max(filaments(q, 5.0, 0.09, 31), 0.75 * filaments(q, 11.0, 0.13, 32));
  return inside * (0.75 * filament * (0.45 + 0.8 * gas) + 0.28 * smoothStep(0.3, 0.9, gas)) +
    0.02 * gas;
}

double cloudCriterion(const glm::dvec3& p, int level)
{
  const double inside = envelope(p);
  if (inside <= 0.0)
  {
    return 0.0;
  }
  const double filament = filaments(stirred(p), 5.0, 0.2, 31);
  const double ofLevel[] = { 0.25, 0.28, 0.3 };
  return inside * (ofLevel[level] + 0.35 * filament);
}
}

StandIn makeCloud(std::uint64_t leafCells)
{
  Recipe recipe;
  recipe.levels = 4;
  recipe.criterion = cloudCriterion;
  recipe.blockingFactor = 2;
  recipe.noiseLength = 0.95;
  recipe.seed = 1;
  StandIn made = standInOf(StandInKind::Cloud, refineCells(recipe, 3.4, leafCells), cloudValue);
  made.transfer =
    TransferFunction({ { 0.0, { 0.05, 0.05, 0.2, 0.0 } }, { 0.12, { 0.1, 0.15, 0.5, 0.0 } },
      { 0.16, { 0.2, 0.3, 0.8, 0.03 } }, { 0.2, { 0.2, 0.3, 0.8, 0.0 } },
      { 0.3, { 0.6, 0.25, 0.6, 0.0 } }, { 0.36, { 0.9, 0.35, 0.4, 0.15 } },
      { 0.42, { 0.9, 0.5, 0.3, 0.02 } }, { 0.55, { 1.0, 0.7, 0.3, 0.2 } },
      { 0.75, { 1.0, 0.95, 0.8, 0.7 } }, { 1.0, { 1.0, 1.0, 1.0, 1.0 } } });
  made.opacityUnitDistance = 0.03;
  made.camera.position = { 1.25, 0.9, 2.05 };
  made.camera.focalPoint = { 0.5, 0.49, 0.5 };
  made.camera.viewAngle = 24.0;
  return made;
}
}
