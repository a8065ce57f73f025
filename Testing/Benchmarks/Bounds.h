// SPDX-License-Identifier: BSD-3-Clause
// What every run has to keep, on any machine: structure and accuracy. Times are not judged.
#ifndef ExaBricksBenchmarksBounds_h
#define ExaBricksBenchmarksBounds_h

#include "Results.h"

namespace exabricks
{
namespace benchmarks
{
/// Bricks hold the leaf cells, each once; regions fill the bounds, each once.
std::vector<std::string> findBrokenStructure(const Scene& scene);
/// Of the methods that are ours; one line for each bound that is not kept.
std::vector<std::string> findBrokenBounds(const Results& results);
}
}

#endif
