// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExaBricksBenchmarksBrickSizes_h
#define ExaBricksBenchmarksBrickSizes_h

#include "Core/Hierarchy.h"

#include <string>

namespace exabricks
{
namespace benchmarks
{
/// Names of the columns, as CSV.
extern const char* const BrickSizesHeader;
/// Prints CSV: time (medians of so many runs) and memory of bricks and regions for several greatest
/// sizes of bricks and lengths of lists. It is what the defaults were chosen by.
void printBrickSizes(const std::string& name, const Hierarchy& hierarchy, int runs);
}
}

#endif
