// SPDX-License-Identifier: BSD-3-Clause
// The range of values that the reconstruction can take in each region, and in parts of long ones: a
// brick is a box of many cells, of which the transfer function may show few.
#ifndef ExaBricksCoreValueRanges_h
#define ExaBricksCoreValueRanges_h

#include "Core/Regions.h"

#include <limits>

namespace exabricks
{
struct Structure;
struct Values;

/// Least and greatest normalised value; min > max where there is none.
struct ValueRange
{
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();

  bool empty() const { return !(this->min <= this->max); }
  void add(const ValueRange& other)
  {
    this->min = std::min(this->min, other.min);
    this->max = std::max(this->max, other.max);
  }
};

/// Longest side of a macrocell, in cells of the region's finest brick.
constexpr int MacrocellCells = 8;

/// A region cut into boxes of equal sides from its lower corner on; the last ones may be shorter.
struct MacrocellGrid
{
  std::uint32_t region;
  int side;               // half cells
  std::size_t firstRange; // x runs fastest

  glm::ivec3 count(const layout::Region& box) const
  {
    return (box.hi - box.lo - 1) / this->side + 1;
  }
  /// Where macrocell `i` of a region begins, and with i + 1 where it ends.
  glm::ivec3 corner(const layout::Region& box, const glm::ivec3& i) const
  {
    // The sum may be more than an int holds.
    return glm::ivec3(glm::min(Int3(box.lo) + Int3(i) * std::int64_t(this->side), Int3(box.hi)));
  }
};

/// Each is the range of the cells whose tents reach into the region or macrocell. The
/// reconstruction is a weighted mean of them, so it leaves the range by no more than its own
/// rounding.
struct ValueRanges
{
  std::vector<ValueRange> regions;    // [region]
  std::vector<MacrocellGrid> grids;   // of regions longer than a macrocell, in ascending order
  std::vector<ValueRange> macrocells; // [MacrocellGrid::firstRange ...]
  /// [i]: of all regions below the node of the tree whose children are nodes 2 i + 1 and 2 i + 2,
  /// so that what shows nothing is passed by as a whole.
  std::vector<ValueRange> splits;

  std::uint64_t bytes() const
  {
    return (this->regions.capacity() + this->macrocells.capacity() + this->splits.capacity()) *
      sizeof(ValueRange) +
      this->grids.capacity() * sizeof(MacrocellGrid);
  }
};

/// Of a structure and its values, which need no ranges yet.
ValueRanges findValueRanges(
  const Structure& structure, const Values& values, int macrocellCells = MacrocellCells);
}

#endif
