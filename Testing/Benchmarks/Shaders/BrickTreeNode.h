// SPDX-License-Identifier: BSD-3-Clause
// A node of the tree over bricks (CellLocation/BrickTree.h): included by C++ and by GLSL.
#ifndef EXABRICKS_BRICK_TREE_NODE_H
#define EXABRICKS_BRICK_TREE_NODE_H

#include "Layout.h"

#ifdef __cplusplus
namespace exabricks
{
namespace layout
{
#endif

// A bounding-interval hierarchy: along one axis, the boxes below the lower child end at lowerEnd,
// those below the upper one begin at upperBegin (half cells); the two may overlap, or leave a gap.
// link = 4 * index + axis for a split (the index is that of the lower child; the upper one follows
// it), 4 * brick + BRICK_TREE_LEAF for a leaf. 12 bytes.
struct BrickTreeNode
{
  int lowerEnd;
  int upperBegin;
  uint link;
};
EXABRICKS_CONST uint BRICK_TREE_LEAF = 3u;
EXABRICKS_CONST int BRICK_TREE_DEPTH = 32; // most splits above a leaf, and of the shaders' stack

// The lattice of the cells of one level, for the walk through the hierarchy. 16 bytes.
struct LevelLattice
{
  ivec3 origin; // of its first cells in the data's bounds, half cells
  int width;    // of a cell, finest cells
};

#ifdef __cplusplus
static_assert(sizeof(BrickTreeNode) == 12, "as in GLSL's scalar layout");
static_assert(sizeof(LevelLattice) == 16, "as in GLSL's scalar layout");
} // namespace layout
} // namespace exabricks
#endif

#endif
