// SPDX-License-Identifier: BSD-3-Clause
// All that is drawn of a data set.
#ifndef ExaBricksCoreVolume_h
#define ExaBricksCoreVolume_h

#include "Core/ValueRanges.h"

namespace exabricks
{
/// Bricks, regions and values to draw. Nothing is copied: all must live as long as it is set.
struct Volume
{
  const RegionTree* tree = nullptr;
  const std::vector<Brick>* bricks = nullptr;
  const std::vector<std::int64_t>* cellWidth = nullptr;
  const Scalars* scalars = nullptr;
  const ValueRanges* ranges = nullptr;
};
}

#endif
