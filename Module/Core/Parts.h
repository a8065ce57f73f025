// SPDX-License-Identifier: BSD-3-Clause
// Cuts a hierarchy's bounds into boxes of about equal numbers of leaf cells, one for each of
// several processes that draw a part each, and tells which cells a part's pictures depend on.
#ifndef ExaBricksCoreParts_h
#define ExaBricksCoreParts_h

#include "Core/Bricks.h"

#include <glm/vec4.hpp>

namespace exabricks
{
/// A k-d tree whose leaves are the parts, so that they have an order from any eye.
struct Parts
{
  struct Cut
  {
    int axis = -1;          // below 0: a part
    std::int64_t plane = 0; // half cells
    int lower = 0; // of a cut: index of the lower side, the upper one follows; of a part: its
                   // number
  };
  std::vector<Cut> cuts;  // the root first
  std::vector<Box> boxes; // [part], half cells; disjoint, together the bounds; empty: there was no
                          // cell left for it

  /// The numbers of the parts that are not empty, those first that hide others. `eye`: a point in
  /// half cells, or with w = 0 the direction to where parallel rays come from.
  std::vector<int> frontToBack(const glm::dvec4& eye) const;
};

/// Half cells count from logical (0, 0, 0). Each box holds at most a tenth more cells than the
/// mean, if its cells are small beside it. Of the cuts that do, those are taken that go through the
/// fewest supports of `bricks`: what lies between two cuts is drawn by one process as by one alone,
/// and where regions end at a cut, nothing is left that two have to share.
Parts cutIntoParts(const LeafBoxes& leaves, const std::vector<Brick>& bricks,
  const std::vector<std::int64_t>& cellWidth, int numberOfParts);

/// The cells, logical, of a level within its reach of a part, which is in half cells.
inline Box cellsInReach(const Box& part, std::int64_t reach)
{
  const Box cells = outwardToCells(part, 2);
  return { cells.lo - reach, cells.hi + reach };
}

/// How far around a part, a box in half cells, cells of each level [level] count for what is seen
/// in it, in finest cells. For a reconstruction between a level's own cells that is one of them; to
/// complete levels, three of the coarsest ones nearby, as values are extrapolated from their
/// slopes. Two more, as the last interval of samples may end beyond the part.
std::vector<std::int64_t> findReach(const LeafBoxes& leaves,
  const std::vector<std::int64_t>& cellWidth, const Box& part, bool completed);
}

#endif
