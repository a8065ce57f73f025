// SPDX-License-Identifier: BSD-3-Clause
// Volumes are exact up to the largest boxes that there can be, which need more than 64 bits.
#include "Core/Box.h"

#include <gtest/gtest.h>
#include <limits>

using namespace exabricks;

namespace
{
constexpr std::int64_t Two30 = std::int64_t(1) << 30;
constexpr std::int64_t Two31 = std::int64_t(1) << 31;

LatticeVolume volumeOf(std::int64_t x, std::int64_t y, std::int64_t z)
{
  return Box{ Int3(0), Int3(x, y, z) }.volume();
}

LatticeVolume sum(LatticeVolume a, const LatticeVolume& b)
{
  a += b;
  return a;
}
}

TEST(LatticeVolume, OfSmallBoxesIsTheNumberOfCells)
{
  EXPECT_EQ(static_cast<int>(volumeOf(3, 4, 5)), 60);
  EXPECT_EQ(volumeOf(3, 4, 5), LatticeVolume(60));
  EXPECT_EQ(static_cast<std::uint64_t>(volumeOf(Two31 - 1, Two31 - 1, 1)),
    static_cast<std::uint64_t>(Two31 - 1) * static_cast<std::uint64_t>(Two31 - 1));
}

TEST(LatticeVolume, OfEmptyBoxesIsNone)
{
  EXPECT_TRUE(LatticeVolume().empty());
  EXPECT_TRUE(volumeOf(0, Two30, Two30).empty());
  EXPECT_TRUE(volumeOf(Two30, Two30, -1).empty());
  EXPECT_TRUE((Box{ Int3(5), Int3(4) }).volume().empty());
  EXPECT_FALSE(volumeOf(Two30, Two30, Two30).empty()); // though its lowest 64 bits are 0
}

TEST(LatticeVolume, IsTheSumOfParts)
{
  // The largest lattice, and the largest in half cells; cut at all kinds of places, on each axis.
  for (const std::int64_t side : { Two30 - 1, Two30, Two31 - 2, Two31 })
  {
    const Box whole{ Int3(-side / 2), Int3(-side / 2 + side) };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const std::int64_t cut :
        { std::int64_t(1), std::int64_t(3), side / 3, side / 2, side / 2 + 1, side - 1 })
      {
        const auto parts = split(whole, axis, whole.lo[axis] + cut);
        const LatticeVolume both = sum(parts.first.volume(), parts.second.volume());
        EXPECT_EQ(both, whole.volume()) << side << " at " << cut;
        EXPECT_LT(parts.first.volume(), whole.volume());
      }
    }
  }
}

TEST(LatticeVolume, KnowsTheEdgeValues)
{
  // (2^30)^3 = 2^90 is 2^26 times 2^64, and so is the sum of so many volumes of 2^64.
  LatticeVolume total;
  const LatticeVolume two64 = volumeOf(Two31, Two31, 4);
  for (int i = 0; i < 1 << 26; ++i)
  {
    total += two64;
  }
  EXPECT_EQ(total, volumeOf(Two30, Two30, Two30));
  // ((2^31)^3 - 1) + 1
  const LatticeVolume most = volumeOf(Two31, Two31, Two31);
  LatticeVolume less = volumeOf(Two31 - 1, Two31, Two31);
  less += volumeOf(1, Two31 - 1, Two31);
  less += volumeOf(1, 1, Two31 - 1);
  EXPECT_LT(less, most);
  EXPECT_EQ(sum(less, LatticeVolume(1)), most);
  // A carry out of the lower 64 bits.
  const LatticeVolume full(std::numeric_limits<std::uint64_t>::max());
  EXPECT_LT(full, two64);
  EXPECT_EQ(sum(full, LatticeVolume(1)), two64);
}

TEST(LatticeVolume, TellsApartWhatDiffersInTheHighBitsAlone)
{
  // Data that fill all of a box but a hole of 2^64 cells do not fill it.
  const LatticeVolume box = volumeOf(Two30, Two30, Two30);
  const LatticeVolume rest = volumeOf(Two30, Two30, Two30 - 16);
  EXPECT_NE(rest, box);
  EXPECT_EQ(sum(rest, volumeOf(Two31, Two31, 4)), box);
}
