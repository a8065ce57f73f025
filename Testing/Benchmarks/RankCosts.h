// SPDX-License-Identifier: BSD-3-Clause
// What several processes cost that draw a part each: how a structure is cut is found as they do,
// for any number of them; of times the parts' sizes times what was measured for one.
#ifndef ExaBricksBenchmarksRankCosts_h
#define ExaBricksBenchmarksRankCosts_h

#include "Scene.h"

namespace exabricks
{
namespace benchmarks
{
/// Names of the columns, as CSV. Of cells the most and the mean of a process that has any.
extern const char* const RankCostsHeader;
/// Prints CSV for 1, 2, 4 and so on up to `most` processes: cells that one draws, cells that it
/// holds, with those around its part that count there; blocks, whose boxes all of them have; bytes
/// of one array that come from others, where blocks were dealt in turn; bytes that a process holds
/// on the host and on the device; samples of the model's picture, as if nothing hid anything; and
/// seconds: of cutting, which each process does and which is measured here, of the exchange, of the
/// part's structure, of the picture, and of putting pictures one over the other. Only the model's
/// hierarchy and camera count.
void printRankCosts(const Model& model, const Size& size, int most);
}
}

#endif
