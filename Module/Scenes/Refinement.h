// SPDX-License-Identifier: BSD-3-Clause
// Hierarchies with a requested number of leaf cells: the coarse grid is scaled, and what is refined
// depends on the place in the scene alone, plus noise on the scale of the cells. So the fraction of
// cells on each level and the size of the bricks are those of the recipe, whatever their number.
#ifndef ExaBricksScenesRefinement_h
#define ExaBricksScenesRefinement_h

#include "Core/Hierarchy.h"

namespace exabricks
{
/// How strongly a place of the scene asks to be refined beyond `level`.
using RefinementCriterion = std::function<double(const glm::dvec3& position, int level)>;

struct Recipe
{
  glm::dvec3 size{ 1.0 }; // of the scene, from its corner (0, 0, 0)
  int levels = 1;
  RefinementCriterion criterion;
  /// Cells along each side that are refined together: the smallest fine brick has twice as many.
  int blockingFactor = 1;
  /// The length over which noise is correlated, in such groups of cells, or in blocks where whole
  /// blocks are refined.
  double noiseLength = 1.0;
  std::uint32_t seed = 0;
};

/// Refines cells, blockingFactor^3 of them together, to 2^3 each where the criterion is greater
/// than noise in [0, 1]. `leavesPerCoarseCell` is an estimate, which saves tries. Origin and
/// spacing are in units of the scene.
Hierarchy refineCells(const Recipe& recipe, double leavesPerCoarseCell, std::uint64_t leafCells);

/// Refines whole blocks of `blockCells`^3 cells to 2^3 blocks: of those of level l the fraction
/// refined[l], and those first where the criterion less noise in [0, noise] is greatest.
Hierarchy refineBlocks(const Recipe& recipe, int blockCells, const std::vector<double>& refined,
  double noise, std::uint64_t leafCells);

/// Leaf cells of a hierarchy whose finer blocks lie inside coarser ones.
std::uint64_t countLeafCells(const Hierarchy& hierarchy);
}

#endif
