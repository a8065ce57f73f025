// SPDX-License-Identifier: BSD-3-Clause
// The pruned tree leads to the regions that show something, and to no others.
#include "Core/ActiveRegions.h"
#include "Core/Structures.h"

#include <gtest/gtest.h>
#include <random>

using namespace exabricks;
using namespace exabricks::testing;

namespace
{
// The leaf that holds a box, as the march finds it: a region, or nothing.
std::uint32_t findRegion(const std::vector<layout::KdNode>& nodes, const glm::ivec3& lo)
{
  layout::KdNode node = nodes[0];
  while ((node.link & 3) != layout::KD_LEAF)
  {
    const std::uint32_t axis = node.link & 3;
    node = nodes[(node.link >> 2) + (lo[axis] >= node.plane ? 1 : 0)];
  }
  return node.link >> 2;
}

std::size_t countLeaves(const std::vector<layout::KdNode>& nodes, std::size_t n)
{
  const std::uint32_t index = nodes[n].link >> 2;
  if ((nodes[n].link & 3) == layout::KD_LEAF)
  {
    return 1;
  }
  return countLeaves(nodes, index) + countLeaves(nodes, index + 1);
}

struct Ranged
{
  Built built;
  std::vector<ValueRange> ranges;
};

Ranged findRanges(Built built)
{
  const Scalars scalars = gatherScalars(built.hierarchy(), built.bricks, built.scene.cells);
  Ranged ranged{ std::move(built), {} };
  ranged.ranges =
    findValueRanges(ranged.built.tree, ranged.built.bricks, ranged.built.cellWidth(), scalars);
  return ranged;
}

TransferFunction above(double value)
{
  return TransferFunction(
    { { value, glm::dvec4(1.0, 1.0, 1.0, 0.0) }, { value + 0.01, glm::dvec4(1.0) } });
}
}

TEST(ActiveRegions, AreThoseTheTransferFunctionShows)
{
  const Ranged ranged = findRanges(build(reference::twoLevels()));
  const ActiveRegions active = selectActiveRegions(ranged.built.tree, ranged.ranges, above(0.8));
  std::vector<std::uint32_t> expected;
  for (std::uint32_t r = 0; r < ranged.ranges.size(); ++r)
  {
    if (ranged.ranges[r].max > 0.8f)
    {
      expected.push_back(r);
    }
  }
  EXPECT_EQ(active.regions, expected);
  EXPECT_GT(expected.size(), 0u);
  EXPECT_LT(expected.size(), ranged.ranges.size());
}

TEST(ActiveRegions, AreReachedThroughTheTreeAndNoOthers)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Ranged ranged = findRanges(buildRandom(seed));
    const RegionTree& tree = ranged.built.tree;
    const ActiveRegions active =
      selectActiveRegions(tree, ranged.ranges, above(0.9 + 0.02 * (seed % 5)));
    std::vector<unsigned char> isActive(tree.regions.size(), 0);
    for (const std::uint32_t r : active.regions)
    {
      isActive[r] = 1;
    }
    for (std::uint32_t r = 0; r < tree.regions.size(); ++r)
    {
      // both corners of the region lead to it, or to nothing
      const std::uint32_t expected = isActive[r] ? r : layout::KD_NO_REGION;
      ASSERT_EQ(findRegion(active.nodes, tree.regions[r].lo), expected);
      ASSERT_EQ(findRegion(active.nodes, tree.regions[r].hi - 1), expected);
    }
    ASSERT_EQ(active.nodes.size(), 2 * countLeaves(active.nodes, 0) - 1);
    ASSERT_LE(active.nodes.size(), tree.nodes.size());
  }
}

TEST(ActiveRegions, AreAllWithDataWhenAllIsOpaque)
{
  const Ranged ranged = findRanges(build(reference::holes()));
  const ActiveRegions active = selectActiveRegions(
    ranged.built.tree, ranged.ranges, TransferFunction({ { 0.0, glm::dvec4(1.0) } }));
  std::size_t withData = 0;
  for (const ValueRange& range : ranged.ranges)
  {
    withData += range.min <= range.max;
  }
  EXPECT_EQ(active.regions.size(), withData);
}

TEST(ActiveRegions, OfNothingToShowAreATreeOfOneNode)
{
  const Ranged ranged = findRanges(build(reference::twoLevels()));
  const ActiveRegions active =
    selectActiveRegions(ranged.built.tree, ranged.ranges, TransferFunction());
  EXPECT_TRUE(active.regions.empty());
  ASSERT_EQ(active.nodes.size(), 1u);
  EXPECT_EQ(active.nodes[0].link, 4 * layout::KD_NO_REGION + layout::KD_LEAF);
}

TEST(ActiveRegions, SortedByMedianSplitsAreTheSameRegions)
{
  const Ranged ranged = findRanges(build(reference::twoLevels(), 4, 1));
  std::vector<std::uint32_t> regions =
    selectActiveRegions(ranged.built.tree, ranged.ranges, above(0.3)).regions;
  std::vector<std::uint32_t> sorted = regions;
  std::shuffle(sorted.begin(), sorted.end(), std::mt19937(7));
  sortByMedianSplits(ranged.built.tree, sorted);

  // The first half lies below the second along one axis.
  bool halved = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    int lower = 0;
    int upper = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      const layout::Region& region = ranged.built.tree.regions[sorted[i]];
      const int center = region.lo[axis] + region.hi[axis];
      (i < sorted.size() / 2 ? lower : upper) =
        i < sorted.size() / 2 ? std::max(lower, center) : std::min(upper, center);
    }
    halved = halved || lower <= upper;
  }
  EXPECT_TRUE(halved);
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, regions);
}
