// SPDX-License-Identifier: BSD-3-Clause
// Exajet: a jet with its surface. Four levels around a thin body, on a lattice whose coordinates
// are about 1.2 million, with cells 8 to 64 units of the lattice wide; the world counts these
// units.
#include "Scenes/Body.h"
#include "Scenes/Makers.h"
#include "Scenes/Noise.h"
#include "Scenes/Refinement.h"

namespace exabricks
{
namespace
{
const glm::dvec3 SceneSize{ 2.0, 1.4, 0.7 };
constexpr double Negligible = 0.002; // a wake so weak is left out, to save time
constexpr double FinestCell = 8.0;
const glm::dvec3 Corner{ 1200000.0, 1190400.0, 1209600.0 }; // whole coarse cells of 64

constexpr double Axis = 0.7; // the plane of symmetry, y
constexpr double Height = 0.33;

// The wind blows along x, z is up.
Body makeJetBody()
{
  Body body;
  body.rods = {
    { { 0.36, Axis, Height }, { 0.95, Axis, Height }, 0.052, 0.055 }, // fuselage
    { { 0.28, Axis, Height - 0.012 }, { 0.36, Axis, Height }, 0.024, 0.052 },
    { { 0.95, Axis, Height }, { 1.26, Axis, Height + 0.03 }, 0.055, 0.014 },
  };
  for (const double side : { -1.0, 1.0 })
  {
    const auto at = [&](double x, double y, double z)
    { return glm::dvec3(x, Axis + side * y, Height + z); };
    body.rods.push_back({ at(0.60, 0.19, -0.055), at(0.74, 0.19, -0.05), 0.028, 0.022, false });
    body.wings.push_back({ at(0.70, 0.03, -0.02), at(0.92, 0.52, 0.02), 0.12, 0.035, 0.012 });
    body.wings.push_back({ at(1.17, 0.01, 0.03), at(1.25, 0.17, 0.045), 0.055, 0.025, 0.007 });
  }
  body.wings.push_back(
    { { 1.12, Axis, Height + 0.03 }, { 1.24, Axis, Height + 0.22 }, 0.07, 0.035, 0.008 });
  return body;
}

// The vortices of the wings' tips, which roll in downstream, in [0, 1].
double tipVortices(const glm::dvec3& p, double width)
{
  const double behind = p.x - 0.92;
  const double y = std::abs(p.y - Axis) - 0.52 + 0.05 * smoothStep(0.0, 1.0, behind);
  const double z = p.z - Height - 0.02 + 0.03 * behind;
  return smoothStep(-0.02, 0.02, behind) *
    gaussian(std::hypot(y, z), width * (1.0 + 0.8 * std::max(behind, 0.0)));
}

// The hot air of the two engines, in [0, 1].
double jets(const glm::dvec3& p, double width)
{
  const double behind = p.x - 0.73;
  const double r = std::hypot(std::abs(p.y - Axis) - 0.19, p.z - Height + 0.05);
  return smoothStep(0.0, 0.03, behind) * gaussian(r, width * (1.0 + 1.6 * std::max(behind, 0.0))) *
    std::exp(-std::max(behind, 0.0) / 0.9);
}

// The wake of the wings' trailing edges and of the fuselage, in [0, 1].
double wake(const glm::dvec3& p, double width)
{
  const double across = std::abs(p.y - Axis);
  const double edge = 0.82 + 0.3 * across;
  const double sheet = smoothStep(edge - 0.02, edge + 0.04, p.x) * smoothStep(0.56, 0.48, across) *
    gaussian(p.z - Height - 0.03 * across, width) * std::exp(-std::max(p.x - edge, 0.0) / 0.35);
  const double tail = smoothStep(1.1, 1.25, p.x) *
    gaussian(std::hypot(across, p.z - Height - 0.05), 2.5 * width) *
    std::exp(-std::max(p.x - 1.2, 0.0) / 0.4);
  return std::max(sheet, tail);
}

double jetValue(const Body& body, const glm::dvec3& position, double width)
{
  const double distance = body.distance(position);
  if (distance <= 0.0)
  {
    return 0.0;
  }
  const glm::dvec3 p = position + randomDisplacement(position * 16.0, 0.01, 71) +
    randomDisplacement(position * 37.0, 0.006, 72);
  const double air = 0.04 * smoothNoise(position * 5.0, 75) + 0.6 * gaussian(distance, 0.009) +
    0.95 * tipVortices(p, 0.012) * std::exp(-std::max(p.x - 0.92, 0.0) / 0.9);
  const double hot = jets(p, 0.03);
  const double slow = wake(p, 0.022);
  if (hot + slow < Negligible)
  {
    return air;
  }
  const double rough = turbulence(position * 20.0, octavesFor(1.0 / 20.0, width), 73);
  const double filament = filaments(p, 26.0, 0.17, 74);
  return air + hot * (0.2 + 0.5 * rough + 0.5 * filament) +
    slow * (0.15 + 0.3 * rough + 0.7 * filament);
}

double jetCriterion(const Body& body, const glm::dvec3& p, int level)
{
  const double reach[] = { 0.16, 0.1, 0.06 };
  const double ofLevel[] = { 0.55, 0.5, 0.5 };
  const double near = reach[level];
  const double most = std::max({ gaussian(body.distance(p), near), tipVortices(p, 0.6 * near),
    jets(p, 0.6 * near), wake(p, 0.5 * near) });
  return ofLevel[level] * smoothStep(0.15, 0.8, most);
}

// Moves and scales the scene to units of the lattice.
void moveToLattice(StandIn& made)
{
  const double scale = FinestCell / made.hierarchy.spacing.x;
  const auto toWorld = [&](glm::dvec3& p) { p = Corner + scale * p; };
  made.hierarchy.origin = Corner;
  made.hierarchy.spacing = glm::dvec3(FinestCell);
  made.opacityUnitDistance *= scale;
  toWorld(made.camera.position);
  toWorld(made.camera.focalPoint);
  std::for_each(made.mesh.points.begin(), made.mesh.points.end(), toWorld);
}
}

StandIn makeJet(StandInKind kind, std::uint64_t leafCells)
{
  const auto body = std::make_shared<const Body>(makeJetBody());
  Recipe recipe;
  recipe.size = SceneSize;
  recipe.levels = 4;
  recipe.criterion = [body](const glm::dvec3& p, int level)
  { return jetCriterion(*body, p, level); };
  recipe.blockingFactor = 3;
  recipe.noiseLength = 1.1;
  recipe.seed = 5;
  StandIn made = standInOf(kind, refineCells(recipe, 5.29, leafCells),
    [body](const glm::dvec3& p, double width) { return jetValue(*body, p, width); });
  made.mesh = body->mesh();
  made.transfer =
    TransferFunction({ { 0.0, { 0.1, 0.1, 0.3, 0.0 } }, { 0.1, { 0.2, 0.3, 0.7, 0.0 } },
      { 0.13, { 0.3, 0.5, 0.9, 0.04 } }, { 0.16, { 0.3, 0.6, 0.9, 0.0 } },
      { 0.26, { 0.2, 0.7, 0.8, 0.0 } }, { 0.3, { 0.2, 0.9, 0.7, 0.2 } },
      { 0.34, { 0.5, 0.9, 0.4, 0.02 } }, { 0.5, { 1.0, 0.8, 0.2, 0.25 } },
      { 0.75, { 1.0, 0.4, 0.1, 0.7 } }, { 1.0, { 1.0, 0.95, 0.9, 0.95 } } });
  made.opacityUnitDistance = 0.02;
  made.camera.viewUp = { 0.0, 0.0, 1.0 };
  if (kind == StandInKind::ExajetRear)
  {
    made.camera.position = { 3.1, 1.25, 0.95 };
    made.camera.focalPoint = { 1.15, 0.7, 0.3 };
    made.camera.viewAngle = 30.0;
  }
  else
  {
    made.camera.position = { 1.75, 1.75, 0.65 };
    made.camera.focalPoint = { 0.95, 1.1, 0.33 };
    made.camera.viewAngle = 30.0;
  }
  moveToLattice(made);
  return made;
}
}
