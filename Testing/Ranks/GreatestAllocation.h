// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out: allocations of more than so many bytes fail.
#ifndef ExaBricksTestingGreatestAllocation_h
#define ExaBricksTestingGreatestAllocation_h

#include <cstddef>
#include <limits>

namespace test
{
/// What operator new gives at most, on all threads, while the object lives.
class GreatestAllocation
{
public:
  explicit GreatestAllocation(std::size_t bytes = std::numeric_limits<std::size_t>::max());
  ~GreatestAllocation();
  GreatestAllocation(const GreatestAllocation&) = delete;
  GreatestAllocation& operator=(const GreatestAllocation&) = delete;
};
}

#endif
