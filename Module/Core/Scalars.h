// SPDX-License-Identifier: BSD-3-Clause
// The values of the leaf cells in brick order, normalised to their range.
#ifndef ExaBricksCoreScalars_h
#define ExaBricksCoreScalars_h

#include "Core/Regions.h"

#include <cmath>
#include <limits>

namespace exabricks
{
/// Where the cells' values come from. Called from several threads at once.
class CellSource
{
public:
  virtual ~CellSource();
  /// Writes the values of `cells` (in cells of the block's level, inside the block) of block
  /// `block` of the hierarchy, x fastest. A value that is not finite stands for an absent cell.
  virtual void read(int block, const Box& cells, double* values) const = 0;
  /// Whether the block has cells that another block of the level holds too and knows better.
  virtual bool hasDuplicates(int block) const;
  /// Writes 1 for such cells, 0 for others.
  virtual void readDuplicates(int block, const Box& cells, unsigned char* duplicate) const;
};

struct Range
{
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(this->min <= this->max); }
  void add(double value)
  {
    this->min = std::min(this->min, value);
    this->max = std::max(this->max, value);
  }
  void add(const Range& other)
  {
    this->min = std::min(this->min, other.min);
    this->max = std::max(this->max, other.max);
  }
  /// 0 at min, 1 at max; for any finite range, from the widest to that of the least two denormals.
  /// 0 for a range of one value.
  double normalize(double value) const
  {
    const double width = this->max - this->min;
    if (!std::isfinite(width))
    {
      return (0.5 * value - 0.5 * this->min) / (0.5 * this->max - 0.5 * this->min);
    }
    return width > 0.0 ? (value - this->min) / width : value - this->min;
  }
};

// With fewer cells than this, starting the threads takes longer than the work.
constexpr std::uint64_t ParallelCells = 1 << 17;

struct Scalars
{
  Range range;               // of the leaf cells that are there, as the source gave it
  std::vector<float> values; // [Brick::firstValue ...], in [0, 1], or layout::ABSENT
  int layer = 0;             // cells around each brick that have values too: see Completion
  std::vector<unsigned char> brickHasAbsentCells;
  std::uint64_t absentCells = 0;
};

/// Reads every leaf cell twice: for the range, then to normalise in double precision. Returns no
/// values if `progress` aborts. What the source or `progress` throws is thrown on.
Scalars gatherScalars(const Hierarchy& hierarchy, const std::vector<Brick>& bricks,
  const CellSource& source, const Progress& progress = {});
}

#endif
