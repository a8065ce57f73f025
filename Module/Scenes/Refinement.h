// SPDX-License-Identifier: BSD-3-Clause
// Hierarchies of a wanted number of leaf cells: the coarse grid is scaled, and what is refined
// depends on the place in the scene alone, plus noise on the scale of the cells. So the share of
// each level and the size of the bricks are those of the recipe, whatever the number of cells.
#ifndef ExaBricksScenesRefinement_h
#define ExaBricksScenesRefinement_h

#include "Core/Hierarchy.h"

namespace exabricks
{
/// How much a place of the scene wants to be refined beyond `level`.
using Drive = std::function<double(const glm::dvec3& position, int level)>;

struct Recipe
{
  glm::dvec3 size{ 1.0 }; // of the scene, from its corner (0, 0, 0)
  int levels = 1;
  Drive drive;
  /// Cells a side that are refined together: the least fine brick has twice as many.
  int clump = 1;
  /// What noise is correlated over, in clumps, or in blocks for a tree of blocks.
  double grain = 1.0;
  std::uint32_t seed = 0;
};

/// Clump by clump: cells are refined to 2^3 where the drive is greater than noise in [0, 1].
/// `leavesPerCoarseCell` is an estimate, which saves tries. Origin and spacing are in units of the
/// scene.
Hierarchy refineCells(const Recipe& recipe, double leavesPerCoarseCell, std::uint64_t leafCells);

/// Block by block: of the blocks of `blockCells`^3 cells of level l, the share refined[l] is
/// refined to 2^3 blocks, those first where the drive less noise in [0, noise] is greatest.
Hierarchy refineBlocks(const Recipe& recipe, int blockCells, const std::vector<double>& refined,
  double noise, std::uint64_t leafCells);

/// Leaf cells of a hierarchy whose finer blocks lie inside coarser ones.
std::uint64_t countLeafCells(const Hierarchy& hierarchy);
}

#endif
