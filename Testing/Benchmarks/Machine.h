// SPDX-License-Identifier: BSD-3-Clause
// What measurements were taken on, as pairs of a name and what it is.
#ifndef ExaBricksBenchmarksMachine_h
#define ExaBricksBenchmarksMachine_h

#include <string>
#include <utility>
#include <vector>

namespace exabricks
{
namespace benchmarks
{
/// Of the last minute; negative if it is not known.
double loadAverage();
/// Processor, memory, VTK, Vulkan devices.
std::vector<std::pair<std::string, std::string>> describeMachine();
/// Bytes that programs may still take; 0 if it is not known.
double availableMemory();
}
}

#endif
