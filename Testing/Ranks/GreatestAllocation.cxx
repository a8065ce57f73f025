// SPDX-License-Identifier: BSD-3-Clause
#include "GreatestAllocation.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace
{
std::atomic<std::size_t> greatest{ std::numeric_limits<std::size_t>::max() };

void* allocate(std::size_t bytes)
{
  void* const memory = bytes > greatest.load(std::memory_order_relaxed)
    ? nullptr
    : std::malloc(std::max<std::size_t>(bytes, 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}
}

void* operator new(std::size_t bytes) { return allocate(bytes); }
void* operator new[](std::size_t bytes) { return allocate(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

test::GreatestAllocation::GreatestAllocation(std::size_t bytes) { greatest = bytes; }

test::GreatestAllocation::~GreatestAllocation()
{
  greatest = std::numeric_limits<std::size_t>::max();
}
