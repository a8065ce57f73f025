// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CellSource.h"

#include <algorithm>

namespace exabricks
{
CellSource::~CellSource() = default;

std::optional<Range> CellSource::wholeRange() const { return std::nullopt; }

bool CellSource::hasDuplicates(int) const { return false; }

void CellSource::readDuplicates(int, const Box& cells, unsigned char* duplicate) const
{
  std::fill_n(duplicate, static_cast<std::size_t>(cells.volume()), static_cast<unsigned char>(0));
}
}
