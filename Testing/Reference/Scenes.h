// SPDX-License-Identifier: BSD-3-Clause
// Small AMR hierarchies made by code, with values whose pictures show structure.
#ifndef ExaBricksReferenceScenes_h
#define ExaBricksReferenceScenes_h

#include "Core/CellSource.h"
#include "Core/Hierarchy.h"
#include "Core/TransferFunction.h"

#include <functional>
#include <string>
#include <vector>

namespace exabricks
{
namespace reference
{
/// Values of each block's cells in an array of their own, x fastest.
class ArraySource : public CellSource
{
public:
  std::vector<Box> blocks; // in cells of the block's level
  std::vector<std::vector<double>> values;
  std::vector<std::vector<unsigned char>> duplicates; // [block]; empty: it has none

  void read(int block, const Box& cells, double* values) const override;
  bool hasDuplicates(int block) const override;
  void readDuplicates(int block, const Box& cells, unsigned char* duplicate) const override;
};

struct Scene
{
  std::string name;
  Hierarchy hierarchy;
  ArraySource cells;
};

/// Value of the cell of `level` at `cell` (in cells of the level).
using CellField = std::function<double(int level, const Int3& cell)>;
/// Values for all blocks; blocks of a level that overlap get the same in common cells.
ArraySource fillCells(const Hierarchy& hierarchy, const CellField& field);
/// Marks the cells that several blocks of a level hold as duplicates, in all of them but the first
/// (or the last), and spoils their values there.
void markDuplicates(const Hierarchy& hierarchy, bool firstIsReal, ArraySource& cells);

/// A shell with two blobs in it, around the middle of `bounds` (logical); between about 0 and 1.
double shellAndBlobs(const Box& bounds, const glm::dvec3& logical);
/// A few translucent layers and a dense one, with colours, for such values.
TransferFunction layeredTransfer();
/// Repeatable noise in [0, 1).
double noise(int level, const Int3& cell, std::uint32_t seed);

/// `coarseCells` cells of the coarsest level along each axis and `ratios` between the levels,
/// refined where the shell is; all levels in blocks of `blockCells` of their cells along each axis,
/// which ratios and `coarseCells` have to fit.
Hierarchy refinedAtShell(const std::vector<int>& ratios, int coarseCells, int blockCells);
/// The lattice box around all blocks, logical.
Box boundsOf(const Hierarchy& hierarchy);
Scene makeShellScene(const std::string& name, const Hierarchy& hierarchy);

Scene uniform();       // one level
Scene twoLevels();     // ratio 2
Scene ratio4();        // two levels
Scene mixedRatios();   // 3, then 2
Scene anisotropic();   // spacing 1, 1, 2 and an origin off 0
Scene holes();         // missing blocks and absent cells
Scene partlyCovered(); // fine blocks that end inside coarse cells
std::vector<Scene> allScenes();

/// Two copies of a scene, so many finest cells apart along each axis: the second one's coordinates
/// are large, counted from the corner of the bounds.
Scene repeatFarAway(const Scene& scene, std::int64_t distance);

/// 1 to 4 levels, ratios 2, 3 and 4, at most about 50 finest cells along an axis, on negative and
/// positive coordinates; with missing blocks, blocks that skip a level, misaligned blocks that
/// cover coarse cells in part, and overlapping blocks of one level.
Hierarchy randomHierarchy(std::uint32_t seed);
/// It, with noise, absent cells (NaN, infinite) and duplicates.
Scene randomScene(std::uint32_t seed);
}
}

#endif
