// SPDX-License-Identifier: BSD-3-Clause
// Which leaf cell holds a place.
#ifndef ExaBricksCoreCellSearch_h
#define ExaBricksCoreCellSearch_h

#include "Core/Structure.h"

#include <optional>

namespace exabricks
{
struct LeafCell
{
  std::size_t brick;
  std::size_t number; // in its brick, x fastest
  Int3 lo;            // its lower corner, logical
};

/// `halfCells`: from the lower corner of the bounds; cells end before their upper faces. None where
/// no leaf cell holds it.
std::optional<LeafCell> findLeafCell(const Structure& structure, const glm::dvec3& halfCells);
}

#endif
