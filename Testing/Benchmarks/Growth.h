// SPDX-License-Identifier: BSD-3-Clause
// Time and memory against the number of leaf cells.
#ifndef ExaBricksBenchmarksGrowth_h
#define ExaBricksBenchmarksGrowth_h

#include "Results.h"
#include "SceneTable.h"

namespace exabricks
{
namespace benchmarks
{
/// The scene from 10^5 leaf cells to `largest`, by factors of 10; appends to
/// `results.growth`. Sizes that memory does not suffice for are left out, and said so.
void measureGrowth(const SceneKind& kind, double largest, const Size& size, Results& results);
}
}

#endif
