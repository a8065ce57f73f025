// SPDX-License-Identifier: BSD-3-Clause
// The stand-ins one by one, and what they share. Positions are in units of the scene, whose corner
// is (0, 0, 0).
#ifndef ExaBricksScenesMakers_h
#define ExaBricksScenesMakers_h

#include "Scenes/StandIn.h"

namespace exabricks
{
/// The value, in [0, 1], of a cell of this width around a position.
using SceneField = std::function<double(const glm::dvec3& position, double width)>;

class FieldSource : public CellSource
{
public:
  /// Takes the place of the cells from the hierarchy as it is now.
  FieldSource(const Hierarchy& hierarchy, SceneField field);
  void read(int block, const Box& cells, double* values) const override;

private:
  std::vector<int> Levels;       // [block]
  std::vector<glm::dvec3> Sizes; // [level], of a cell
  glm::dvec3 Origin;
  SceneField Field;
};

/// A stand-in of values in [0, 1], without camera, transfer function and mesh.
StandIn standInOf(StandInKind kind, Hierarchy hierarchy, SceneField field);

StandIn makeCloud(std::uint64_t leafCells);
StandIn makeImpact(StandInKind kind, std::uint64_t leafCells);
StandIn makeWind(std::uint64_t leafCells);
StandIn makeGear(std::uint64_t leafCells);
StandIn makeJet(StandInKind kind, std::uint64_t leafCells);
}

#endif
