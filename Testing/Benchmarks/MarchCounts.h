// SPDX-License-Identifier: BSD-3-Clause
// What a march does: the instruments by which it is made faster.
#ifndef ExaBricksBenchmarksMarchCounts_h
#define ExaBricksBenchmarksMarchCounts_h

#include "Scene.h"

namespace exabricks
{
namespace benchmarks
{
/// Names of the columns, as CSV.
extern const char* const MarchCountsHeader;
/// Prints a line of CSV: of a picture by the k-d tree with such steps, for each ray that takes any
/// sample, samples of the field, halves of intervals that show nothing, intervals, regions and
/// steps down the tree; and how many lanes of a subgroup are on in a round of the loop of
/// intervals, and in a step down the tree, on the device in use, which needs
/// ballots of subgroups.
void printMarchCounts(const Scene& scene, const Size& size, double stepScale);
}
}

#endif
