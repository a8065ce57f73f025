// SPDX-License-Identifier: BSD-3-Clause
// The values of one array at one time step in the cells of a structure's bricks.
#ifndef ExaBricksCoreValues_h
#define ExaBricksCoreValues_h

#include "Core/CellSource.h"
#include "Core/Range.h"
#include "Core/Structure.h"
#include "Core/ValueRanges.h"

#include <memory>

namespace exabricks
{
/// With fewer cells than this, starting the threads takes longer than the work.
constexpr std::uint64_t ParallelCells = 1 << 17;

struct Values
{
  Range range; // of the leaf cells that have a value, or the source's wholeRange()
  std::vector<float> normalized; // brick after brick, in [0, 1] of the range, or layout::ABSENT
                                 // or UNDEFINED
  /// Cells around each brick that have values too: 0, or 1 where levels are completed (Completion).
  int layer = 0;
  /// [bricks + 1]: where in `normalized` each brick begins, and where the last one ends.
  std::vector<std::uint64_t> firstValue;
  std::vector<unsigned char> brickHasAbsentCells;    // [brick], its layer included
  std::vector<unsigned char> brickHasUndefinedCells; // [brick]; empty: none has
  std::uint64_t absentCells = 0;                     // leaf cells without a value
  ValueRanges ranges;

  /// The values of a brick and its layer, [z][y][x].
  const float* ofBrick(std::size_t brick) const
  {
    return this->normalized.data() + this->firstValue[brick];
  }
  std::uint64_t bytes() const
  {
    return this->normalized.capacity() * sizeof(float) +
      this->firstValue.capacity() * sizeof(std::uint64_t) + this->brickHasAbsentCells.capacity() +
      this->brickHasUndefinedCells.capacity() + this->ranges.bytes();
  }
};

/// Values::firstValue for bricks with so many cells around each.
std::vector<std::uint64_t> findFirstValues(const std::vector<Brick>& bricks, int layer);

/// All but the ranges. Reads every leaf cell twice, unless the source has a wholeRange(): for the
/// range, then to normalise in double precision. `source` has the blocks of the structure's
/// hierarchy. Returns no values if `progress` aborts. What the source or `progress` throws is
/// thrown on.
Values gatherValues(
  const Structure& structure, const CellSource& source, const Progress& progress = {});

/// Gathers the values and finds their ranges. Null if `progress` aborts.
std::shared_ptr<const Values> makeValues(
  const Structure& structure, const CellSource& source, const Progress& progress = {});
}

#endif
