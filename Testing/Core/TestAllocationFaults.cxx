// SPDX-License-Identifier: BSD-3-Clause
// Memory runs out at each allocation in turn: every time std::bad_alloc reaches the caller, on
// whatever thread it was thrown, and nothing is left behind. A program of its own, as its operator
// new is not the usual one.
#include "Core/Coarsening.h"
#include "Core/Completion.h"
#include "Reference/Scenes.h"
#include "Scenes/StandIn.h"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>
#include <omp.h>

namespace
{
constexpr long Never = std::numeric_limits<long>::max();
std::atomic<long> allocationsLeft{ Never };
std::atomic<bool> failsOnce{ false };
std::atomic<long> alive{ 0 };
std::atomic<long> faults{ 0 };

void* allocate(std::size_t bytes)
{
  if (allocationsLeft.load(std::memory_order_relaxed) != Never)
  {
    const long left = allocationsLeft.fetch_sub(1);
    if (left == 0 || (left < 0 && !failsOnce))
    {
      ++faults;
      throw std::bad_alloc();
    }
  }
  void* memory = std::malloc(std::max<std::size_t>(bytes, 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  ++alive;
  return memory;
}

void release(void* memory)
{
  if (memory)
  {
    --alive;
    std::free(memory);
  }
}
}

void* operator new(std::size_t bytes) { return allocate(bytes); }
void* operator new[](std::size_t bytes) { return allocate(bytes); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

using namespace exabricks;

namespace
{
enum class Outcome
{
  Done,
  OutOfMemory,
  Leaked
};

// `work` with no memory from the n-th allocation on, or for that one alone.
template <typename Work>
Outcome runOutOfMemory(const Work& work, long n, bool once)
{
  const long before = alive;
  Outcome outcome = Outcome::Done;
  faults = 0;
  failsOnce = once;
  allocationsLeft = n;
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    outcome = Outcome::OutOfMemory;
  }
  allocationsLeft = Never;
  return alive == before ? outcome : Outcome::Leaked;
}

// Runs `work` with a fault at every allocation, one after another, until it has as many as it
// needs.
template <typename Work>
void expectNoHarm(const Work& work)
{
  for (const bool once : { false, true })
  {
    long n = 0;
    do
    {
      // What is done in spite of a fault is as good as without: vectors may keep what they could
      // give back.
      ASSERT_NE(runOutOfMemory(work, n++, once), Outcome::Leaked)
        << "at allocation " << n << (once ? " alone" : " and all later ones");
    } while (faults > 0);
    EXPECT_GT(n, 3) << "too few faults were brought about";
  }
}

// Two levels of few blocks, so that there are not too many allocations to try; with enough cells
// for several threads, also without the finest level.
class AllocationFaults : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    omp_set_num_threads(4);
    hierarchy.cellWidth = { 2, 1 };
    hierarchy.blocks = { { 0, { Int3(0), Int3(54) } }, { 1, { Int3(40), Int3(56) } } };
    source = reference::fillCells(
      hierarchy, [](int, const Int3& c) { return static_cast<double>(c.x + 2 * c.y + 3 * c.z); });
    volume.structure = std::make_shared<const Structure>(buildStructure(hierarchy));
    volume.values = makeValues(*volume.structure, source);
  }

  static Hierarchy hierarchy;
  static reference::ArraySource source;
  static Volume volume;
};
Hierarchy AllocationFaults::hierarchy;
reference::ArraySource AllocationFaults::source;
Volume AllocationFaults::volume;
}

TEST_F(AllocationFaults, OfTheStructureReachTheCaller)
{
  expectNoHarm([] { buildStructure(hierarchy); });
}

TEST_F(AllocationFaults, OfTheValuesReachTheCaller)
{
  expectNoHarm([] { makeValues(*volume.structure, source); });
}

TEST_F(AllocationFaults, OfTheValueRangesReachTheCaller)
{
  expectNoHarm([] { findValueRanges(*volume.structure, *volume.values); });
}

TEST_F(AllocationFaults, OfTheCompletionReachTheCaller)
{
  expectNoHarm([] { complete(*volume.structure, *volume.values); });
}

TEST_F(AllocationFaults, OfTheCoarseningReachTheCaller)
{
  expectNoHarm(
    []
    {
      const auto coarser = coarsen(*volume.structure);
      coarsen(volume, *coarser->structure);
    });
}

TEST_F(AllocationFaults, OfTheScenesReachTheCaller)
{
  expectNoHarm([] { makeStandIn(StandInKind::Cloud, 20000); });
}
