// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the core share: all that is built of a scene, and brute force to compare with.
#ifndef ExaBricksTestingStructures_h
#define ExaBricksTestingStructures_h

#include "Core/Volume.h"
#include "Reference/ForEachPoint.h"
#include "Reference/Scenes.h"

namespace exabricks
{
namespace testing
{
using reference::forEachPoint;

// Random scenes of each property test.
constexpr std::uint32_t RandomScenes = 200;

struct Built
{
  reference::Scene scene;
  LeafBoxes leaves;
  std::shared_ptr<const Structure> structure;

  const Hierarchy& hierarchy() const { return this->scene.hierarchy; }
  const std::vector<std::int64_t>& cellWidth() const { return this->scene.hierarchy.cellWidth; }
  const std::vector<Brick>& bricks() const { return this->structure->bricks; }
  const RegionTree& tree() const { return this->structure->tree; }
  std::int64_t width(const Brick& brick) const { return this->structure->width(brick); }
  Box box(const Brick& brick) const { return this->structure->box(brick); }
  Values gather() const { return gatherValues(*this->structure, this->scene.cells); }
};

inline Built build(
  reference::Scene scene, int brickCells = DefaultBrickCells, const RegionLimits& limits = {})
{
  Built built;
  built.scene = std::move(scene);
  built.leaves = findLeafBoxes(built.hierarchy());
  auto structure = std::make_shared<Structure>();
  structure->hierarchy = built.hierarchy();
  structure->leafCells = built.leaves.cells;
  structure->partlyCoveredBoxes = built.leaves.partlyCoveredBoxes;
  structure->bricks = buildBricks(built.leaves, built.cellWidth(), brickCells);
  structure->tree = buildRegions(structure->bricks, built.leaves.bounds, built.cellWidth(), limits);
  built.structure = std::move(structure);
  return built;
}

/// Random scene number `seed`, with sizes of bricks and lists that vary with it.
inline Built buildRandom(std::uint32_t seed)
{
  constexpr int brickCells[] = { 16, 3, 255, 1, 5 };
  constexpr RegionLimits limits[] = { { 4, 4, 0 }, { 1, 1, 0 }, { 2, 6, 3 }, { 8, 8, 0 }, {} };
  return build(reference::randomScene(seed), brickCells[seed / 5 % 5], limits[seed % 5]);
}

/// Calls visit(brick, corner of the cell, index of its value) for all leaf cells.
template <typename Visitor>
void forEachLeafCell(const Built& built, const Visitor& visit)
{
  std::uint64_t i = 0;
  for (const Brick& brick : built.bricks())
  {
    forEachPoint({ Int3(0), Int3(brick.cells) },
      [&](const Int3& c) { visit(brick, brick.lo + c * built.width(brick), i++); });
  }
}

/// One number for each finest cell of a box.
class Lattice
{
public:
  Lattice(const Box& box, int value)
    : Bounds(box)
    , Values(static_cast<std::size_t>(box.volume()), value)
  {
  }
  const Box& bounds() const { return this->Bounds; }
  int& operator[](const Int3& p)
  {
    const Int3 at = p - this->Bounds.lo;
    const Int3 size = this->Bounds.size();
    return this->Values[at.x + size.x * (at.y + size.y * at.z)];
  }
  void fill(const Box& box, int value)
  {
    forEachPoint(box, [&](const Int3& p) { (*this)[p] = value; });
  }
  std::size_t count(int value) const
  {
    return std::count(this->Values.begin(), this->Values.end(), value);
  }

private:
  Box Bounds;
  std::vector<int> Values;
};

/// Of each finest cell, the finest level that has a block there; -1: none.
inline Lattice finestLevels(const Hierarchy& hierarchy)
{
  Lattice finest(reference::boundsOf(hierarchy), -1);
  for (int level = 0; level < hierarchy.levels(); ++level)
  {
    for (const Block& block : hierarchy.blocks)
    {
      if (block.level == level)
      {
        finest.fill(hierarchy.logicalBox(block), level);
      }
    }
  }
  return finest;
}

/// The region's box in finest cells, rounded outward (it is in half cells from the bounds' corner).
inline Box finestCells(const RegionTree& tree, const layout::Region& region)
{
  const Box cells = outwardToCells({ Int3(region.lo), Int3(region.hi) }, 2);
  return { cells.lo + tree.bounds.lo, cells.hi + tree.bounds.lo };
}
}
}

#endif
