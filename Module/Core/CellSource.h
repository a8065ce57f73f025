// SPDX-License-Identifier: BSD-3-Clause
// Where the values of a hierarchy's cells come from.
#ifndef ExaBricksCoreCellSource_h
#define ExaBricksCoreCellSource_h

#include "Core/Box.h"
#include "Core/Range.h"

#include <limits>
#include <optional>

namespace exabricks
{
/// Stands for a cell that is hidden, whatever its value.
constexpr double HiddenValue = -std::numeric_limits<double>::infinity();

/// Called from several threads at once.
class CellSource
{
public:
  virtual ~CellSource();
  /// Writes the values of `cells` (in cells of the block's level, inside the block) of block
  /// `block` of the hierarchy, x fastest. A value that is not finite stands for an absent cell:
  /// HiddenValue for one that never shows, any other for one whose value is undefined.
  virtual void read(int block, const Box& cells, double* values) const = 0;
  /// The range that values are normalised to; none: that of the leaf cells.
  virtual std::optional<Range> wholeRange() const;
  /// Whether the block has cells that another block of the level holds too and knows better.
  virtual bool hasDuplicates(int block) const;
  /// Writes 1 for such cells, 0 for others.
  virtual void readDuplicates(int block, const Box& cells, unsigned char* duplicate) const;
};
}

#endif
