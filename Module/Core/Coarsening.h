// SPDX-License-Identifier: BSD-3-Clause
// A volume without its finest level, for pictures in which that is too fine to be seen.
#ifndef ExaBricksCoreCoarsening_h
#define ExaBricksCoreCoarsening_h

#include "Core/Volume.h"

#include <glm/mat4x4.hpp>
#include <optional>

namespace exabricks
{
struct CoarserStructure
{
  /// Its hierarchy has no blocks, as nothing is read for it.
  std::shared_ptr<const Structure> structure;
  /// From half cells of the structure it was made from to its own.
  glm::dmat4 fromHalfCells{ 1.0 };
};

/// The cells of the finest level give way to those of the next one. None if there is one level
/// alone. The result depends on the boxes alone, and serves every array and time step on them.
std::optional<CoarserStructure> coarsen(const Structure& finer);

/// The values of the structure that coarsen() made of the volume's: each cell has the mean of all
/// that lies in it; absent cells do not count. Normalised as those of the volume, and completed if
/// they are.
std::shared_ptr<const Values> coarsen(const Volume& finer, const Structure& coarser);
}

#endif
