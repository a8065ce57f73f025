// SPDX-License-Identifier: BSD-3-Clause
// Measures the wall time since it was made, for the times that users are told.
#ifndef ExaBricksCoreStopwatch_h
#define ExaBricksCoreStopwatch_h

#include <chrono>

namespace exabricks
{
class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}

#endif
