// SPDX-License-Identifier: BSD-3-Clause
// A layer of one cell around each brick, for a reconstruction that is exact for linear fields
// across levels: every lattice point of a level next to its leaf cells gets a value, also where
// there is none of them. (Layer cells that are leaf cells of the level have that cell's value, so
// that all bricks of a level agree.)
#ifndef ExaBricksCoreCompletion_h
#define ExaBricksCoreCompletion_h

#include "Core/Values.h"

namespace exabricks
{
/// `values`, which have no layer, with a layer of 1, and their ranges. A layer cell that is no leaf
/// cell of its level gets the mean of what the leaf cells say that hold its centre, each by its
/// plane through the cells across its faces. Beyond the bounds, the value of the next one within:
/// the value stays. In holes, the mean of the nearest cells of its level. Where all of these are
/// absent, so is it. All stay in the range of the data.
std::shared_ptr<const Values> complete(const Structure& structure, const Values& values);
}

#endif
