// SPDX-License-Identifier: BSD-3-Clause
// What is thrown in a parallel region arrives behind it.
#include "Core/FirstException.h"
#include "Core/Structures.h"

#include <gtest/gtest.h>
#include <new>
#include <omp.h>

using namespace exabricks;
using namespace exabricks::testing;

namespace
{
// A cube of enough cells for several threads, in many bricks.
Built manyCells()
{
  reference::Scene scene;
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(64) } } };
  return build(std::move(scene), 8);
}

// Zeros, until `failAfter` reads have been made: then each read throws.
template <typename Exception>
class FailingSource : public CellSource
{
public:
  explicit FailingSource(int failAfter, const Exception& exception)
    : Left(failAfter)
    , Thrown(exception)
  {
  }

  void read(int, const Box& cells, double* values) const override
  {
    if (this->Left.fetch_sub(1) <= 0)
    {
      this->Workers = this->Workers || omp_get_thread_num() > 0;
      throw this->Thrown;
    }
    std::fill_n(values, static_cast<std::size_t>(cells.volume()), 0.0);
  }

  bool failedInWorker() const { return this->Workers; }

private:
  mutable std::atomic<int> Left;
  mutable std::atomic<bool> Workers{ false };
  const Exception Thrown;
};

class Threads
{
public:
  explicit Threads(int count) { omp_set_num_threads(count); }
  ~Threads() { omp_set_num_threads(this->Before); }

private:
  const int Before = omp_get_max_threads();
};
}

TEST(FirstException, IsThrownBehindTheRegion)
{
  const Threads threads(4);
  FirstException failure;
  std::atomic<int> done{ 0 };
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < 1000; ++i)
  {
    failure.guard(
      [&]
      {
        if (i >= 10)
        {
          throw std::out_of_range("too far");
        }
        ++done;
      });
  }
  EXPECT_THROW(failure.rethrow(), std::out_of_range);
  EXPECT_LE(done, 10); // what was left has been skipped
}

TEST(FirstException, IsNoneWhereNothingIsThrown)
{
  FirstException failure;
  int done = 0;
  failure.guard([&] { ++done; });
  failure.guard([&] { ++done; });
  EXPECT_NO_THROW(failure.rethrow());
  EXPECT_EQ(done, 2);
}

TEST(FirstException, OfASourceReachesTheCallerOfGatherValues)
{
  const Threads threads(4);
  const Built built = manyCells();
  bool inWorker = false;
  for (const int failAfter : { 0, 1, 100, 511, 512, 600, 1023 }) // 512 bricks are read twice
  {
    SCOPED_TRACE(failAfter);
    const FailingSource<std::bad_alloc> noMemory(failAfter, std::bad_alloc());
    EXPECT_THROW(gatherValues(*built.structure, noMemory), std::bad_alloc);
    const FailingSource<std::runtime_error> broken(failAfter, std::runtime_error("broken"));
    try
    {
      gatherValues(*built.structure, broken);
      FAIL() << "expected an exception";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(error.what(), std::string("broken"));
    }
    inWorker = inWorker || noMemory.failedInWorker() || broken.failedInWorker();
  }
  EXPECT_TRUE(inWorker);
  // And with a source that works, it works.
  const FailingSource<std::bad_alloc> works(1024, std::bad_alloc());
  EXPECT_EQ(gatherValues(*built.structure, works).normalized.size(), 64u * 64u * 64u);
}

TEST(FirstException, OfProgressReachesTheCallerOfGatherValues)
{
  const Threads threads(4);
  const Built built = manyCells();
  const FailingSource<std::bad_alloc> works(1024, std::bad_alloc());
  const auto progress = [](double done) -> bool
  {
    if (done > 0.0)
    {
      throw std::runtime_error("no more");
    }
    return true;
  };
  EXPECT_THROW(gatherValues(*built.structure, works, progress), std::runtime_error);
}
