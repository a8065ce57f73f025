// SPDX-License-Identifier: BSD-3-Clause
// Wind: the wake of a wind turbine, vortices of the three blades' tips in a helix that breaks up
// downstream. Large blocks.
#include "Scenes/Makers.h"
#include "Scenes/Noise.h"
#include "Scenes/Refinement.h"

namespace exabricks
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
const glm::dvec3 SceneSize{ 3.0, 1.0, 1.0 };
const glm::dvec3 Hub{ 0.4, 0.5, 0.26 };
constexpr double Blade = 0.15;
constexpr double Pitch = 0.36; // of one blade's helix

double wakeRadius(double behind) { return Blade * (1.0 + 0.1 * std::max(behind, 0.0)); }

double windValue(const glm::dvec3& position, double width)
{
  const double broken = smoothStep(0.5, 1.8, position.x - Hub.x);
  const glm::dvec3 p = position - Hub +
    randomDisplacement(position * 5.0, 0.012 + 0.06 * broken, 51) +
    randomDisplacement(position * 13.0, 0.03 * broken, 52);
  const double behind = p.x;
  const double r = std::hypot(p.y, p.z);
  const double edge = r - wakeRadius(behind);
  const double start = smoothStep(-0.03, 0.03, behind);

  // Distance along x to the next of the three helices.
  const double turns = std::atan2(p.z, p.y) / (2.0 * Pi) + behind / Pitch;
  const double toBlade = (turns * 3.0 - std::round(turns * 3.0)) / 3.0 * Pitch;
  const double tips =
    gaussian(std::hypot(edge, toBlade), 0.024 + 0.01 * behind) * (1.0 - 0.45 * broken);
  const double sheet = 0.35 * gaussian(toBlade, 0.02) * smoothStep(0.03, 0.07, r) *
    gaussian(r, 0.7 * Blade) * gaussian(behind, 0.8);
  const double hub = 0.8 * gaussian(r, 0.028 + 0.016 * behind) * gaussian(behind, 1.6);
  const double rough = turbulence(position * 8.0, octavesFor(1.0 / 8.0, width), 53);
  const double filament = filaments(position, 14.0, 0.16, 54);
  const double wake =
    smoothStep(0.05, -0.05, edge) * broken * (0.15 * rough + 0.75 * filament * rough);
  return 0.04 * smoothNoise(position * 6.0, 55) + start * (std::max({ tips, sheet, hub }) + wake);
}

double windCriterion(const glm::dvec3& position, int level)
{
  const glm::dvec3 p = position - Hub;
  const double edge = std::hypot(p.y, p.z) - wakeRadius(p.x);
  const double before = std::max(-p.x, 0.0);
  const double near =
    gaussian(std::max(edge, 0.0), level == 0 ? 0.22 : 0.12) * gaussian(before, 0.12);
  const double far = std::exp(-std::max(p.x, 0.0) / (level == 0 ? 4.0 : 1.6));
  return near * far * (level == 0 ? 1.0 : 0.6 + 0.4 * gaussian(edge, 0.1));
}
}

StandIn makeWind(std::uint64_t leafCells)
{
  Recipe recipe;
  recipe.size = SceneSize;
  recipe.levels = 3;
  recipe.criterion = windCriterion;
  recipe.noiseLength = 1.5;
  recipe.seed = 3;
  StandIn made =
    standInOf(StandInKind::Wind, refineBlocks(recipe, 25, { 0.3, 0.3 }, 0.7, leafCells), windValue);
  made.transfer =
    TransferFunction({ { 0.0, { 0.1, 0.1, 0.3, 0.0 } }, { 0.12, { 0.1, 0.2, 0.6, 0.0 } },
      { 0.16, { 0.1, 0.4, 0.8, 0.03 } }, { 0.22, { 0.1, 0.6, 0.8, 0.0 } },
      { 0.35, { 0.2, 0.8, 0.6, 0.0 } }, { 0.4, { 0.3, 0.9, 0.5, 0.2 } },
      { 0.45, { 0.6, 0.9, 0.4, 0.03 } }, { 0.6, { 1.0, 0.8, 0.2, 0.3 } },
      { 0.8, { 1.0, 0.4, 0.1, 0.8 } }, { 1.0, { 0.9, 0.1, 0.1, 0.95 } } });
  made.opacityUnitDistance = 0.03;
  made.camera.position = { 0.1, 1.05, 2.15 };
  made.camera.focalPoint = { 1.2, 0.46, 0.26 };
  made.camera.viewAngle = 34.0;
  return made;
}
}
