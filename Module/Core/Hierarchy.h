// SPDX-License-Identifier: BSD-3-Clause
// The AMR hierarchy as the core sees it: levels of cells on one integer lattice, and the blocks
// that are really there.
//
// *Logical* coordinates count cells of the finest level; a cell of level l is cellWidth[l] of them
// wide. World coordinates are origin + spacing * logical, per axis, so anisotropic spacing never
// enters the reconstruction.
#ifndef ExaBricksCoreHierarchy_h
#define ExaBricksCoreHierarchy_h

#include "Core/Box.h"

#include <functional>
#include <string>
#include <vector>

namespace exabricks
{
struct Block
{
  int level = 0;
  Box cells; // in cells of its own level

  bool operator==(const Block& other) const
  {
    return this->level == other.level && this->cells == other.cells;
  }
};

struct Hierarchy
{
  std::vector<std::int64_t> cellWidth; // [level], finest cells; each a multiple of the next, last 1
  std::vector<Block> blocks;           // null blocks are left out
  glm::dvec3 origin{ 0.0 };            // world position of logical (0, 0, 0)
  glm::dvec3 spacing{ 1.0 };           // world size of a finest cell

  Box logicalBox(const Block& block) const
  {
    return scaled(block.cells, this->cellWidth[block.level]);
  }
  int levels() const { return static_cast<int>(this->cellWidth.size()); }
  /// Same lattice and same blocks: bricks and regions can be kept.
  bool sameStructure(const Hierarchy& other) const
  {
    return this->cellWidth == other.cellWidth && this->blocks == other.blocks;
  }
};

/// Cells of a level have to be less than this many finest cells wide, and so has the lattice: half
/// cells have to fit 32 bits on the device.
constexpr std::int64_t LatticeLimit = std::int64_t(1) << 30;

/// What is said of levels whose cells would be too wide: the ratio of level `coarse` to `fine`,
/// whose own cells are `width` finest cells wide. For ratios of any size.
std::string describeWideRatio(double ratio, int coarse, int fine, std::int64_t width);

/// Empty if the hierarchy can be used, else what was expected, what was found and what to do.
std::string findFault(const Hierarchy& hierarchy);

/// Told the done fraction in [0, 1] of a stage, always from the calling thread; returns false to
/// abort.
using Progress = std::function<bool(double)>;
}

#endif
