// SPDX-License-Identifier: BSD-3-Clause
// Bricks: boxes of leaf cells of one level, without holes (Wald et al. 2020, section 4.1).
#ifndef ExaBricksCoreBricks_h
#define ExaBricksCoreBricks_h

#include "Core/LeafBoxes.h"

#include <glm/ext/vector_int3_sized.hpp>
#include <glm/vec3.hpp>

namespace exabricks
{
struct Brick
{
  Int3 lo{ 0 };          // lower corner, logical
  glm::ivec3 cells{ 0 }; // how many along each axis
  int level = 0;

  std::uint64_t numberOfCells() const
  {
    return static_cast<std::uint64_t>(this->cells.x) * this->cells.y * this->cells.z;
  }
  /// Of its cells and of `layer` more on every side.
  std::uint64_t numberOfValues(int layer) const
  {
    const glm::i64vec3 n(this->cells + 2 * layer);
    return static_cast<std::uint64_t>(n.x * n.y * n.z);
  }
  Box box(std::int64_t cellWidth) const
  {
    return { this->lo, this->lo + Int3(this->cells) * cellWidth };
  }
};

/// Most cells of a brick along an axis. Of 8, 16 and 32, 32 took least memory
/// (exabricks-benchmark --structure) and drew fastest by either traversal (a shell of 3.2 M
/// cells, on lavapipe). The device has 8 bits for it.
constexpr int DefaultBrickCells = 32;
constexpr int MaximumBrickCells = 255;

/// Partitions the leaf cells into bricks by a top-down k-d tree over the leaf boxes: a node with
/// more than one level, or holes, is split along its longest axis at a plane where something
/// changes. `maximumCells` is taken into [1, MaximumBrickCells]. Returns no bricks if `progress`
/// aborts.
std::vector<Brick> buildBricks(const LeafBoxes& leaves, const std::vector<std::int64_t>& cellWidth,
  int maximumCells = DefaultBrickCells, const Progress& progress = {});
}

#endif
