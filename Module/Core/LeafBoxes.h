// SPDX-License-Identifier: BSD-3-Clause
// The visible part of a hierarchy: disjoint boxes of leaf cells, those that no finer block covers.
#ifndef ExaBricksCoreLeafBoxes_h
#define ExaBricksCoreLeafBoxes_h

#include "Core/Hierarchy.h"

namespace exabricks
{
struct LeafBox
{
  int level = 0; // of its cells
  Box box;       // logical; it consists of whole cells of its level
};

struct LeafBoxes
{
  std::vector<LeafBox> boxes; // disjoint
  Box bounds;                 // logical, around all boxes
  std::uint64_t cells = 0;    // in all boxes
  /// How many of the boxes are what is left of coarse cells that finer blocks cover in part. Such a
  /// box is cut into cells of the first level whose cells fit, each with the coarse cell's value.
  std::size_t partlyCoveredBoxes = 0;
};

/// A cell is covered where a finer one of `hierarchy.blocks` is really there. Where blocks of one
/// level overlap, each cell is taken once. Returns no boxes if `progress` aborts.
LeafBoxes findLeafBoxes(const Hierarchy& hierarchy, const Progress& progress = {});

/// Appends to `rest` disjoint boxes that make up `box` without `cutters`.
void subtract(const Box& box, const std::vector<Box>& cutters, std::vector<Box>& rest);
}

#endif
