// SPDX-License-Identifier: BSD-3-Clause
// Faults that tests bring about, since no driver fails on request.
#ifndef ExaBricksVulkanFaults_h
#define ExaBricksVulkanFaults_h

#include <cstdint>
#include <limits>
#include <optional>

namespace exabricks
{
namespace vulkan
{
struct Faults
{
  int lostSubmits = 0;           // so many next submits fail with "device lost"
  int submitsWithoutMemory = 0;  // and so many with "out of device memory"
  std::optional<void*> mappedAt; // what mapping memory answers, with success
  std::uint64_t availableMemory = std::numeric_limits<std::uint64_t>::max();    // bytes, at most
  std::uint64_t largestValueBuffer = std::numeric_limits<std::uint64_t>::max(); // bytes, at most
};

Faults& faults();
}
}

#endif
