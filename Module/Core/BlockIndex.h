// SPDX-License-Identifier: BSD-3-Clause
// Finds the blocks of a level that intersect a box.
#ifndef ExaBricksCoreBlockIndex_h
#define ExaBricksCoreBlockIndex_h

#include "Core/BoxIndex.h"
#include "Core/Hierarchy.h"

namespace exabricks
{
struct BlockIndex
{
  std::vector<BoxIndex> boxes;          // [level], logical boxes of its blocks
  std::vector<std::vector<int>> blocks; // [level][box], index into Hierarchy::blocks, ascending

  explicit BlockIndex(const Hierarchy& hierarchy)
    : boxes(hierarchy.levels())
    , blocks(hierarchy.levels())
  {
    std::vector<std::vector<Box>> boxesOfLevel(hierarchy.levels());
    for (std::size_t b = 0; b < hierarchy.blocks.size(); ++b)
    {
      const Block& block = hierarchy.blocks[b];
      boxesOfLevel[block.level].push_back(hierarchy.logicalBox(block));
      this->blocks[block.level].push_back(static_cast<int>(b));
    }
    for (int level = 0; level < hierarchy.levels(); ++level)
    {
      this->boxes[level] = BoxIndex(std::move(boxesOfLevel[level]));
    }
  }
};
}

#endif
