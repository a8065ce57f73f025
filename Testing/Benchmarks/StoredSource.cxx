// SPDX-License-Identifier: BSD-3-Clause
#include "StoredSource.h"

namespace exabricks
{
namespace benchmarks
{
StoredSource::StoredSource(const Hierarchy& hierarchy, const CellSource& from)
  : Blocks(hierarchy.blocks)
  , Values(hierarchy.blocks.size())
{
  const auto count = static_cast<std::int64_t>(this->Blocks.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t b = 0; b < count; ++b)
  {
    const Box& cells = this->Blocks[b].cells;
    std::vector<double> values(static_cast<std::size_t>(cells.volume()));
    from.read(static_cast<int>(b), cells, values.data());
    this->Values[b].assign(values.begin(), values.end());
  }
}

void StoredSource::read(int block, const Box& cells, double* values) const
{
  const Box& all = this->Blocks[block].cells;
  const Int3 size = all.size();
  for (std::int64_t z = cells.lo.z; z < cells.hi.z; ++z)
  {
    for (std::int64_t y = cells.lo.y; y < cells.hi.y; ++y)
    {
      const Int3 at = Int3(cells.lo.x, y, z) - all.lo;
      const float* row = this->Values[block].data() + at.x + size.x * (at.y + size.y * at.z);
      values = std::copy(row, row + cells.size().x, values);
    }
  }
}
}
}
