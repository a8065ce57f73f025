// SPDX-License-Identifier: BSD-3-Clause
// The two tables of the method's source (Wald et al. 2020), with our numbers beside theirs.
#ifndef ExaBricksBenchmarksSourceTables_h
#define ExaBricksBenchmarksSourceTables_h

#include "Results.h"

namespace exabricks
{
namespace benchmarks
{
/// A frame by cell location, by regions, and their ratio. Empty if no such scene was measured.
std::string sourceTimesTable(const Results& results);
/// Scalars, bricks, regions (ours on host and device), acceleration structure, surface, all.
/// Likewise.
std::string sourceMemoryTable(const Results& results);

// For all tables. "-" for what was not measured.
std::string number(double value, const char* format);
std::string milliseconds(double seconds);
std::string row(const std::vector<std::string>& cells);
std::string rule(int columns);
}
}

#endif
