// SPDX-License-Identifier: BSD-3-Clause
// Space skipping: the regions in which the transfer function shows anything, and what the two
// traversals walk.
#ifndef ExaBricksCoreActiveRegions_h
#define ExaBricksCoreActiveRegions_h

#include "Core/TransferFunction.h"

namespace exabricks
{
struct ActiveRegions
{
  std::vector<std::uint32_t> regions; // in the order of the tree's leaves
  /// The regions' k-d tree without the parts where nothing is active.
  std::vector<layout::KdNode> nodes;
};

ActiveRegions selectActiveRegions(
  const RegionTree& tree, const std::vector<ValueRange>& ranges, const TransferFunction& transfer);

/// Orders `regions` by recursive median splits along the longest axis of their centres. Builders
/// that halve the array of boxes as given (Mesa's) make a good hierarchy of it.
void sortByMedianSplits(const RegionTree& tree, std::vector<std::uint32_t>& regions);
}

#endif
