// SPDX-License-Identifier: BSD-3-Clause
// A volume without its finest level, for pictures in which that is too fine to be seen.
#ifndef ExaBricksCoreCoarsening_h
#define ExaBricksCoreCoarsening_h

#include "Core/Volume.h"

#include <glm/mat4x4.hpp>
#include <memory>

namespace exabricks
{
struct CoarserVolume
{
  RegionTree tree;
  std::vector<Brick> bricks;
  std::vector<std::int64_t> cellWidth;
  Scalars scalars; // normalised as those of the volume it was made from
  ValueRanges ranges;
  /// From half cells of the volume it was made from to its own.
  glm::dmat4 fromHalfCells{ 1.0 };

  Volume volume() const
  {
    return { &this->tree, &this->bricks, &this->cellWidth, &this->scalars, &this->ranges };
  }
};

/// The cells of the finest level give way to those of the next one, each with the mean of all that
/// lies in it; absent cells do not count. Completed, if the volume is. Null if it has
/// one level alone.
std::unique_ptr<const CoarserVolume> coarsen(const Volume& volume);
}

#endif
