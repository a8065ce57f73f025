// SPDX-License-Identifier: BSD-3-Clause
// Procedural stand-ins for the models that the ExaBricks paper measures, which are not free or too
// large to ship: the same kind of structure for its bricks and regions, in any size.
//
// What a stand-in shares with its original are the mean cells per brick and the kind of hierarchy
// (octrees of small fragments, large blocks, four levels around a thin body). How many levels the
// others have and how many cells lie on each level, the paper does not say: those are this
// project's choice, the same at every size. No file is read, and equal calls give equal results.
#ifndef ExaBricksScenesStandIn_h
#define ExaBricksScenesStandIn_h

#include "Core/CellSource.h"
#include "Core/Hierarchy.h"
#include "Core/Range.h"
#include "Core/TransferFunction.h"

#include <memory>
#include <string>
#include <vector>

namespace exabricks
{
enum class StandInKind
{
  Cloud,      // molecular cloud: filaments of turbulence, octree
  Impact5K,   // asteroid in deep water, just after entry: a narrow plume, octree
  Impact20K,  // the same later: a crown splash
  Impact46K,  // the same later: a wide wave and a mushroom of steam
  Wind,       // wake of a wind turbine, large blocks
  Gear,       // landing gear with its surface, large blocks nested around struts
  ExajetRear, // a jet with its surface, on a lattice far from 0, seen from behind
  ExajetWing  // the same data, seen along a wing
};
constexpr int StandInKinds = 8;

/// What is known of a stand-in before it is made.
struct StandInDescription
{
  const char* name;     // "Impact-5K"
  double cellsPerBrick; // of the original, from the memory of scalars and bricks in the paper
  std::vector<double> fractions; // [level], of the leaf cells, to within 0.07: not from the paper
  /// With fewer leaf cells there would be too few blocks to tell the levels apart; so many are
  /// made.
  std::uint64_t leastLeafCells;
  bool hasMesh;
};

const StandInDescription& describe(StandInKind kind);

struct TriangleMesh
{
  std::vector<glm::dvec3> points; // world
  std::vector<glm::ivec3> triangles;
};

struct StandInCamera
{
  glm::dvec3 position{ 0.0 }; // world
  glm::dvec3 focalPoint{ 0.0 };
  glm::dvec3 viewUp{ 0.0, 1.0, 0.0 };
  double viewAngle = 30.0; // degrees, of the picture's height
};

struct StandIn
{
  StandInKind kind = StandInKind::Cloud;
  /// Blocks of a level are disjoint, those of a finer level cover whole cells of the coarser.
  Hierarchy hierarchy;
  /// Evaluates the field at the centres of the cells that are asked for. Its detail ends at the
  /// width of these cells, as that of a simulation does.
  std::shared_ptr<const CellSource> cells;
  /// All values lie in it, though they need not reach its ends; `transfer` is normalised to it.
  Range range;
  TransferFunction transfer;
  double opacityUnitDistance = 1.0; // world length
  StandInCamera camera;
  TriangleMesh mesh; // empty for scenes without

  /// `transfer` for values that are normalised to another range, such as Values::range.
  TransferFunction transferFor(const Range& other) const;
};

/// With about `leafCells` leaf cells, at least StandInDescription::leastLeafCells.
StandIn makeStandIn(StandInKind kind, std::uint64_t leafCells);
}

#endif
