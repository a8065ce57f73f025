// SPDX-License-Identifier: BSD-3-Clause
// Values computed once, so that reading them costs what reading a simulation's does.
#ifndef ExaBricksBenchmarksStoredSource_h
#define ExaBricksBenchmarksStoredSource_h

#include "Core/CellSource.h"
#include "Core/Hierarchy.h"

namespace exabricks
{
namespace benchmarks
{
class StoredSource : public CellSource
{
public:
  /// Reads all of `from`, in parallel.
  StoredSource(const Hierarchy& hierarchy, const CellSource& from);

  void read(int block, const Box& cells, double* values) const override;

private:
  const std::vector<Block> Blocks;
  std::vector<std::vector<float>> Values;
};
}
}

#endif
