// SPDX-License-Identifier: BSD-3-Clause
// Gear: the landing gear of an aeroplane in the wind, vortices behind its struts and wheels. Large
// blocks nested around the struts, and the opaque surface of the gear.
#include "Scenes/Body.h"
#include "Scenes/Makers.h"
#include "Scenes/Noise.h"
#include "Scenes/Refinement.h"

namespace exabricks
{
namespace
{
constexpr double Negligible = 0.002; // a wake so weak is left out, to save time
const glm::dvec3 SceneSize{ 1.5, 1.0, 1.0 };

// The wind blows along x, the aeroplane is above (z).
Body makeGearBody()
{
  Body body;
  body.rods = {
    { { 0.40, 0.32, 0.98 }, { 0.40, 0.32, 0.55 }, 0.040, 0.040 }, // strut
    { { 0.40, 0.32, 0.60 }, { 0.40, 0.32, 0.22 }, 0.026, 0.026 },
    { { 0.40, 0.18, 0.22 }, { 0.40, 0.46, 0.22 }, 0.024, 0.024 },          // axle
    { { 0.40, 0.145, 0.22 }, { 0.40, 0.225, 0.22 }, 0.115, 0.115, false }, // wheels
    { { 0.40, 0.415, 0.22 }, { 0.40, 0.495, 0.22 }, 0.115, 0.115, false },
    { { 0.42, 0.32, 0.58 }, { 0.66, 0.32, 0.96 }, 0.018, 0.018 }, // braces
    { { 0.40, 0.32, 0.62 }, { 0.42, 0.04, 0.96 }, 0.016, 0.016 },
    { { 0.44, 0.32, 0.52 }, { 0.51, 0.32, 0.41 }, 0.012, 0.012 }, // torque links
    { { 0.51, 0.32, 0.41 }, { 0.43, 0.32, 0.29 }, 0.012, 0.012 },
  };
  return body;
}

double wakes(const Body& body, const glm::dvec3& p, double length)
{
  double sum = 0.0;
  for (const Rod& rod : body.rods)
  {
    sum = std::max(sum, wakeOf(rod, p, length));
  }
  return sum;
}

double gearValue(const Body& body, const glm::dvec3& position, double width)
{
  const double distance = body.distance(position);
  if (distance <= 0.0)
  {
    return 0.0;
  }
  const double air = 0.03 * smoothNoise(position * 6.0, 66) + 0.75 * gaussian(distance, 0.012);
  const double behind = smoothStep(0.4, 1.0, position.x);
  const glm::dvec3 p = position + randomDisplacement(position * 7.0, 0.01 + 0.06 * behind, 61) +
    randomDisplacement(position * 19.0, 0.012, 62);
  const double wake = wakes(body, p, 0.4);
  if (wake < Negligible)
  {
    return air;
  }
  const double rough = turbulence(position * 14.0, octavesFor(1.0 / 14.0, width), 63);
  const double filament =
    std::max(filaments(p, 16.0, 0.15, 64), 0.8 * filaments(p, 34.0, 0.17, 65));
  return air + wake * (0.1 + 0.25 * rough + 1.2 * filament * rough);
}

double gearCriterion(const Body& body, const glm::dvec3& p, int level)
{
  const double reach[] = { 0.25, 0.15, 0.09 };
  return gaussian(body.distance(p), reach[level]) + 0.8 * wakes(body, p, 0.4);
}
}

StandIn makeGear(std::uint64_t leafCells)
{
  const auto body = std::make_shared<const Body>(makeGearBody());
  Recipe recipe;
  recipe.size = SceneSize;
  recipe.levels = 4;
  recipe.criterion = [body](const glm::dvec3& p, int level)
  { return gearCriterion(*body, p, level); };
  recipe.noiseLength = 1.5;
  recipe.seed = 4;
  StandIn made =
    standInOf(StandInKind::Gear, refineBlocks(recipe, 27, { 0.3, 0.25, 0.25 }, 0.3, leafCells),
      [body](const glm::dvec3& p, double width) { return gearValue(*body, p, width); });
  made.mesh = body->mesh();
  made.transfer =
    TransferFunction({ { 0.0, { 0.1, 0.1, 0.3, 0.0 } }, { 0.14, { 0.1, 0.2, 0.6, 0.0 } },
      { 0.18, { 0.1, 0.4, 0.9, 0.05 } }, { 0.22, { 0.1, 0.6, 0.9, 0.0 } },
      { 0.36, { 0.2, 0.8, 0.6, 0.0 } }, { 0.4, { 0.4, 0.9, 0.4, 0.25 } },
      { 0.44, { 0.7, 0.9, 0.3, 0.02 } }, { 0.6, { 1.0, 0.8, 0.2, 0.3 } },
      { 0.8, { 1.0, 0.4, 0.1, 0.7 } }, { 1.0, { 0.9, 0.1, 0.1, 0.95 } } });
  made.opacityUnitDistance = 0.02;
  made.camera.position = { 0.1, -1.6, 0.75 };
  made.camera.focalPoint = { 0.68, 0.32, 0.5 };
  made.camera.viewUp = { 0.0, 0.0, 1.0 };
  made.camera.viewAngle = 32.0;
  return made;
}
}
