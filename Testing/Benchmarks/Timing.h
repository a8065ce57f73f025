// SPDX-License-Identifier: BSD-3-Clause
// Wall and processor time of repeated work, and medians of them.
#ifndef ExaBricksBenchmarksTiming_h
#define ExaBricksBenchmarksTiming_h

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <vector>

namespace exabricks
{
namespace benchmarks
{
/// NaN of none.
inline double median(std::vector<double> values)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

/// Seconds of each run. Processor time is that of all threads of the process: it hardly grows when
/// other programs take the machine, as wall time does.
struct Costs
{
  std::vector<double> wall;
  std::vector<double> cpu;

  template <typename Work>
  void measure(const Work& work)
  {
    const std::clock_t cpuBegin = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    work();
    this->wall.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    this->cpu.push_back(static_cast<double>(std::clock() - cpuBegin) / CLOCKS_PER_SEC);
  }
};
}
}

#endif
