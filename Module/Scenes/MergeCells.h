// SPDX-License-Identifier: BSD-3-Clause
// Marked cells as few boxes.
#ifndef ExaBricksScenesMergeCells_h
#define ExaBricksScenesMergeCells_h

#include "Core/Box.h"

#include <vector>

namespace exabricks
{
/// Makes disjoint boxes of at most `most` cells along each side of the cells of `box` whose mark is
/// 1 (x fastest). They grow along x, then y, then z. Clears the marks.
std::vector<Box> mergeCells(const Box& box, std::vector<unsigned char>& marks, std::int64_t most);
}

#endif
