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
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace exabricks
{
struct Block
{
  int level = 0;
  Box cells; // counted in cells of its own level

  bool operator==(const Block& other) const
  {
    return this->level == other.level && this->cells == other.cells;
  }
};

/// Of which another hierarchy has the cells around the box that it shows.
struct WholeHierarchy
{
  std::vector<Block> blocks;       // all, wherever they are
  bool completed = false;          // whether there are enough cells to complete levels
  std::vector<std::int64_t> reach; // [level]: how far around that box there are cells, finest cells

  bool operator==(const WholeHierarchy& other) const
  {
    return this->blocks == other.blocks && this->completed == other.completed &&
      this->reach == other.reach;
  }
};

struct Hierarchy
{
  std::vector<std::int64_t> cellWidth; // [level], finest cells; each a multiple of the next, last 1
  std::vector<Block> blocks;           // those that are really there
  glm::dvec3 origin{ 0.0 };            // world position of logical (0, 0, 0)
  glm::dvec3 spacing{ 1.0 };           // world size of a finest cell
  /// Half finest cells from logical (0, 0, 0): what is drawn, if not all. Cells beyond it count for
  /// what is in it.
  std::optional<Box> shown{};
  /// Bricks and regions are those of the whole, as far as they are shown, so that samples are where
  /// they are for the whole; null: this is all.
  std::shared_ptr<const WholeHierarchy> whole{};

  Box logicalBox(const Block& block) const
  {
    return scaled(block.cells, this->cellWidth[block.level]);
  }
  int levels() const { return static_cast<int>(this->cellWidth.size()); }
  /// Whether lattice and blocks are the same, so that bricks and regions can be kept.
  bool sameStructure(const Hierarchy& other) const
  {
    return this->cellWidth == other.cellWidth && this->blocks == other.blocks &&
      this->shown == other.shown &&
      (this->whole == other.whole || (this->whole && other.whole && *this->whole == *other.whole));
  }
};

/// Cells of a level have to be less than this many finest cells wide, and so has the lattice: half
/// cells have to fit 32 bits on the device.
constexpr std::int64_t LatticeLimit = std::int64_t(1) << 30;

/// The message for levels whose cells would be too wide. `ratio`: of level `coarse` to level
/// `fine`, whose cells are `width` finest cells wide; it may be of any size.
std::string describeWideRatio(double ratio, int coarse, int fine, std::int64_t width);

/// Returns why the hierarchy cannot be used: what was expected, what was found and what to do.
/// Empty if it can.
std::string findFault(const Hierarchy& hierarchy);

/// Is told which fraction of a stage is done, in [0, 1], always from the calling thread. Returns
/// false to abort the stage.
using Progress = std::function<bool(double)>;
}

#endif
