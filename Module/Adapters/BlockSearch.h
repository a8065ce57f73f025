// SPDX-License-Identifier: BSD-3-Clause
// Back from a leaf cell to the AMR: the block that holds it, and the cell's number there.
#ifndef ExaBricksAdaptersBlockSearch_h
#define ExaBricksAdaptersBlockSearch_h

#include "Adapters/BrickedVolume.h"
#include "Core/CellSearch.h"

#include "vtkOverlappingAMR.h"

#include <vector>

namespace exabricks
{
/// -1: there is none.
struct CellOfBlock
{
  int level = -1; // of the AMR
  int block = -1; // in its level
  vtkIdType id = -1;
  int ijk[3] = { -1, -1, -1 }; // in the block's grid
};

class BlockSearch
{
public:
  /// `amr` is what `bricked` was made of. Both have to live as long as this.
  BlockSearch(vtkOverlappingAMR* amr, const BrickedVolume& bricked);

  /// `inCell`: a place in the leaf cell, in half cells. Takes time by the number of blocks, but
  /// where the block is the one found last.
  CellOfBlock find(const LeafCell& leaf, const glm::dvec3& inCell);

private:
  // The cell that holds a place of the only block, of which points are drawn.
  CellOfBlock CellBetweenPoints(const glm::dvec3& place) const;
  // Where a cell would be in a block, if it is there; a duplicate of another block's counts only
  // where it is asked for.
  CellOfBlock CellIn(int amrLevel, int block, const glm::dvec3& cell, const glm::dvec3& middle,
    bool duplicate) const;

  vtkOverlappingAMR* const AMR;
  const BrickedVolume& Bricked;
  std::vector<int> Last; // of each level of the AMR, the block found last, or -1
};
}

#endif
