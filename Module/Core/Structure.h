// SPDX-License-Identifier: BSD-3-Clause
// All that depends on the hierarchy's boxes alone, and not on values: it is kept as long as the
// boxes stay the same, and serves plain values and completed ones alike.
#ifndef ExaBricksCoreStructure_h
#define ExaBricksCoreStructure_h

#include "Core/Regions.h"

namespace exabricks
{
struct Structure
{
  Hierarchy hierarchy;
  std::uint64_t leafCells = 0;
  std::size_t partlyCoveredBoxes = 0; // see LeafBoxes
  std::vector<Brick> bricks;
  RegionTree tree;

  /// Width of the brick's cells, in finest cells.
  std::int64_t width(const Brick& brick) const { return this->hierarchy.cellWidth[brick.level]; }
  /// Logical.
  Box box(const Brick& brick) const { return brick.box(this->width(brick)); }
  /// What is shown, in half cells from the lower corner of the bounds.
  Box shown() const
  {
    const Int3 corner = this->tree.bounds.lo * std::int64_t(2);
    const std::optional<Box>& part = this->hierarchy.shown;
    return part ? Box{ part->lo - corner, part->hi - corner }
                : Box{ Int3(0), Int3(this->tree.size) };
  }
  /// Of bricks, regions, lists and tree.
  std::uint64_t bytes() const
  {
    return this->bricks.capacity() * sizeof(Brick) +
      this->tree.regions.capacity() * sizeof(layout::Region) +
      this->tree.brickLists.capacity() * sizeof(std::uint32_t) +
      this->tree.nodes.capacity() * sizeof(layout::KdNode);
  }
};

/// Leaf boxes, bricks and regions. No regions if `progress` aborts.
Structure buildStructure(Hierarchy hierarchy, const Progress& progress = {});
}

#endif
