// SPDX-License-Identifier: BSD-3-Clause
// Progress of one stage that several threads work at: all of them add to it, and the first one,
// which is the caller's, reports it.
#ifndef ExaBricksCoreSharedProgress_h
#define ExaBricksCoreSharedProgress_h

#include "Core/Hierarchy.h"

#include <algorithm>
#include <atomic>
#include <omp.h>

namespace exabricks
{
class SharedProgress
{
public:
  /// Keeps a reference.
  explicit SharedProgress(const Progress& progress)
    : Report(progress)
  {
  }

  bool aborted() const { return this->Aborted.load(std::memory_order_relaxed); }

  /// A fraction of all work was done.
  void pass(double fraction)
  {
    if (!this->Report)
    {
      return;
    }
    double before = this->Done.load();
    while (!this->Done.compare_exchange_weak(before, before + fraction))
    {
    }
    const double done = std::min(before + fraction, 1.0);
    if (omp_get_thread_num() == 0 && done >= this->Next)
    {
      this->Next = done + Step;
      this->Aborted = this->Aborted || !this->Report(done);
    }
  }

private:
  static constexpr double Step = 1.0 / 256.0;

  const Progress& Report;
  std::atomic<double> Done{ 0.0 };
  std::atomic<bool> Aborted{ false };
  double Next = 0.0; // of the first thread
};
}

#endif
