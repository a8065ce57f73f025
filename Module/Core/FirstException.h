// SPDX-License-Identifier: BSD-3-Clause
// Exceptions in parallel regions: OpenMP ends the process if one leaves the region. The first one
// is kept, what is left of the work is skipped, and the exception is thrown again after the region.
#ifndef ExaBricksCoreFirstException_h
#define ExaBricksCoreFirstException_h

#include <atomic>
#include <exception>

namespace exabricks
{
class FirstException
{
public:
  /// Runs `body`, unless an earlier one has failed. For any thread of the region.
  template <typename Body>
  void guard(const Body& body) noexcept
  {
    if (this->Failed.load(std::memory_order_relaxed))
    {
      return;
    }
    try
    {
      body();
    }
    catch (...)
    {
      if (!this->Failed.exchange(true))
      {
        this->First = std::current_exception();
      }
    }
  }

  /// After the region: throws what the first body threw that failed, if one did.
  void rethrow() const
  {
    if (this->First)
    {
      std::rethrow_exception(this->First);
    }
  }

private:
  std::atomic<bool> Failed{ false };
  std::exception_ptr First; // written by the one thread that has set Failed
};
}

#endif
