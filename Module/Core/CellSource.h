// SPDX-License-Identifier: BSD-3-Clause
// Where the values of a hierarchy's cells come from.
#ifndef ExaBricksCoreCellSource_h
#define ExaBricksCoreCellSource_h

#include "Core/Box.h"

#include <limits>

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
  /// Whether the block has cells that another block of the level holds too and knows better.
  virtual bool hasDuplicates(int block) const;
  /// Writes 1 for such cells, 0 for others.
  virtual void readDuplicates(int block, const Box& cells, unsigned char* duplicate) const;
};
}

#endif
