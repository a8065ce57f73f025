// SPDX-License-Identifier: BSD-3-Clause
// Active brick regions partition the bounds, and know all bricks that reach into them.
#include "Core/BoxIndex.h"
#include "Core/Regions.h"
#include "Core/Structures.h"
#include "Scenes/StandIn.h"

#include <gtest/gtest.h>

using namespace exabricks;
using namespace exabricks::testing;

namespace
{
// Walks the k-d tree, and counts how often each region is a leaf whose box is the region's.
void visitLeaves(const RegionTree& tree, std::size_t n, const Box& box, std::vector<int>& visits)
{
  const layout::KdNode& node = tree.nodes[n];
  const std::uint32_t index = node.link >> 2;
  const std::uint32_t axis = node.link & 3;
  if (axis == layout::KD_LEAF)
  {
    ASSERT_LT(index, tree.regions.size());
    const layout::Region& region = tree.regions[index];
    EXPECT_EQ(box, (Box{ Int3(region.lo), Int3(region.hi) }));
    ++visits[index];
    return;
  }
  ASSERT_GT(node.plane, box.lo[axis]);
  ASSERT_LT(node.plane, box.hi[axis]);
  ASSERT_GT(index, n); // no circles
  ASSERT_LT(index + 1, tree.nodes.size());
  const auto parts = split(box, static_cast<int>(axis), node.plane);
  visitLeaves(tree, index, parts.first, visits);
  visitLeaves(tree, index + 1, parts.second, visits);
}

Box supportInHalfCells(const Built& built, const Brick& brick)
{
  const Box box = built.box(brick);
  const std::int64_t width = built.width(brick);
  return { (box.lo - built.tree().bounds.lo) * std::int64_t(2) - width,
    (box.hi - built.tree().bounds.lo) * std::int64_t(2) + width };
}
}

TEST(Regions, OfOneBrickAreOne)
{
  const Built built = build(reference::uniform(), 255);
  ASSERT_EQ(built.tree().regions.size(), 1u);
  EXPECT_EQ(built.tree().regions[0].lo, glm::ivec3(0));
  EXPECT_EQ(built.tree().regions[0].hi, glm::ivec3(48));
  EXPECT_EQ(built.tree().brickLists, std::vector<std::uint32_t>{ 0 });
}

TEST(Regions, AreCutAtTheFacesOfSupports)
{
  // Two bricks side by side, each 4 cells long: both reach half a cell over the middle.
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(8, 1, 1) } } };
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  const std::vector<Brick> bricks = buildBricks(leaves, hierarchy.cellWidth, 4);
  const RegionTree tree = buildRegions(bricks, leaves.bounds, hierarchy.cellWidth, { 1, 1, 0 });
  ASSERT_EQ(tree.regions.size(), 3u);
  std::vector<std::pair<int, int>> spans;
  for (const layout::Region& region : tree.regions)
  {
    spans.emplace_back(region.lo.x, region.hi.x);
  }
  EXPECT_EQ(spans, (std::vector<std::pair<int, int>>{ { 0, 7 }, { 7, 9 }, { 9, 16 } }));
  EXPECT_EQ(
    buildRegions(bricks, leaves.bounds, hierarchy.cellWidth, { 2, 2, 0 }).regions.size(), 1u);
}

TEST(Regions, PartitionTheBoundsAsTheLeavesOfTheTree)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    ASSERT_EQ(built.tree().bounds, built.leaves.bounds);
    ASSERT_EQ(Int3(built.tree().size), built.leaves.bounds.size() * std::int64_t(2));
    ASSERT_FALSE(built.tree().nodes.empty());
    std::vector<int> visits(built.tree().regions.size(), 0);
    visitLeaves(built.tree(), 0, { Int3(0), Int3(built.tree().size) }, visits);
    ASSERT_EQ(visits, std::vector<int>(visits.size(), 1));
    ASSERT_EQ(built.tree().nodes.size(), 2 * visits.size() - 1);
  }
}

TEST(Regions, LieInLeafCellsOrHaveNoBricks)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    Lattice leaf(built.leaves.bounds, 0);
    for (const LeafBox& box : built.leaves.boxes)
    {
      leaf.fill(box.box, 1);
    }
    for (const layout::Region& region : built.tree().regions)
    {
      int cells = 0;
      const Box box = finestCells(built.tree(), region);
      forEachPoint(box, [&](const Int3& p) { cells += leaf[p]; });
      ASSERT_EQ(cells, region.brickCount > 0 ? static_cast<int>(box.volume()) : 0);
    }
  }
}

TEST(Regions, ListAllBricksThatReachIntoThemInAscendingOrder)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    std::vector<Box> supports;
    for (const Brick& brick : built.bricks())
    {
      supports.push_back(supportInHalfCells(built, brick));
    }
    for (const layout::Region& region : built.tree().regions)
    {
      const Box box{ Int3(region.lo), Int3(region.hi) };
      std::vector<std::uint32_t> reach;
      for (std::size_t b = 0; b < supports.size() && region.brickCount > 0; ++b)
      {
        if (supports[b].intersects(box))
        {
          reach.push_back(static_cast<std::uint32_t>(b));
        }
      }
      const auto list = built.tree().brickLists.begin() + region.firstBrick;
      ASSERT_EQ(reach, std::vector<std::uint32_t>(list, list + region.brickCount));
    }
  }
}

// So many bricks that subtrees are made at once: what is put together is whole, in order, and of
// each region its list and the finest cells.
TEST(Regions, OfManyBricksAreThoseOfTheirSubtrees)
{
  const StandIn standIn = makeStandIn(StandInKind::Impact5K, 500000);
  const Structure structure = buildStructure(standIn.hierarchy);
  const RegionTree& tree = structure.tree;
  ASSERT_GT(structure.bricks.size(), 4000u);
  std::vector<int> visits(tree.regions.size(), 0);
  visitLeaves(tree, 0, { Int3(0), Int3(tree.size) }, visits);
  EXPECT_EQ(visits, std::vector<int>(visits.size(), 1));
  EXPECT_EQ(tree.nodes.size(), 2 * tree.regions.size() - 1);
  std::vector<std::int64_t> finestCells(tree.regions.size(), -1);
  for (const layout::KdNode& node : tree.nodes)
  {
    if ((node.link & 3) == layout::KD_LEAF)
    {
      finestCells[node.link >> 2] = node.plane;
    }
  }
  std::vector<Box> supports;
  for (const Brick& brick : structure.bricks)
  {
    const Box box = structure.box(brick);
    const std::int64_t width = structure.width(brick);
    supports.push_back({ (box.lo - tree.bounds.lo) * std::int64_t(2) - width,
      (box.hi - tree.bounds.lo) * std::int64_t(2) + width });
  }
  const BoxIndex index(supports);
  std::size_t listed = 0;
  for (std::size_t r = 0; r < tree.regions.size(); ++r)
  {
    const layout::Region& region = tree.regions[r];
    ASSERT_EQ(region.firstBrick, listed); // lists are in the order of regions
    listed += region.brickCount;
    std::vector<std::uint32_t> reach;
    std::int64_t finest = 0;
    if (region.brickCount > 0)
    {
      index.forEachIntersecting({ Int3(region.lo), Int3(region.hi) },
        [&](int b) { reach.push_back(static_cast<std::uint32_t>(b)); });
      std::sort(reach.begin(), reach.end());
      finest = std::numeric_limits<std::int64_t>::max();
      for (const std::uint32_t brick : reach)
      {
        finest = std::min(finest, structure.width(structure.bricks[brick]));
      }
    }
    const auto list = tree.brickLists.begin() + region.firstBrick;
    ASSERT_EQ(reach, std::vector<std::uint32_t>(list, list + region.brickCount));
    ASSERT_EQ(finestCells[r], finest);
  }
  EXPECT_EQ(listed, tree.brickLists.size());
}

namespace
{
// Of the bounds, in half cells.
Box somePart(const Built& built)
{
  const Box all = scaled(built.leaves.bounds, 2);
  const Int3 size = all.size();
  return { all.lo + size / std::int64_t(3), all.hi - size / std::int64_t(4) };
}
}

TEST(Regions, OfAShownPartAreThoseOfAllCutAtItsFaces)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const Box shown = somePart(built);
    const RegionTree tree =
      buildRegions(built.bricks(), built.leaves.bounds, built.cellWidth(), {}, {}, shown);
    ASSERT_EQ(tree.bounds, built.tree().bounds);
    const Int3 corner = built.leaves.bounds.lo * std::int64_t(2);
    const Box part{ shown.lo - corner, shown.hi - corner };
    std::vector<int> visits(tree.regions.size(), 0);
    visitLeaves(tree, 0, { Int3(0), Int3(tree.size) }, visits);
    ASSERT_EQ(visits, std::vector<int>(visits.size(), 1));
    // Of each place's bricks none that reach there are missing, and beyond the part there are none.
    Lattice leaf(built.leaves.bounds, 0);
    for (const LeafBox& box : built.leaves.boxes)
    {
      leaf.fill(box.box, 1);
    }
    for (const layout::Region& region : tree.regions)
    {
      const Box box{ Int3(region.lo), Int3(region.hi) };
      ASSERT_TRUE(region.brickCount == 0 || part.contains(box));
      forEachPoint(intersection(box, part),
        [&](const Int3& half)
        {
          const int inLeaf = leaf[built.leaves.bounds.lo + half / std::int64_t(2)];
          ASSERT_EQ(inLeaf, region.brickCount > 0 ? 1 : 0);
        });
      const auto list = tree.brickLists.begin() + region.firstBrick;
      for (std::size_t b = 0; b < built.bricks().size() && region.brickCount > 0; ++b)
      {
        const bool reaches = supportInHalfCells(built, built.bricks()[b]).intersects(box);
        ASSERT_EQ(reaches,
          std::find(list, list + region.brickCount, static_cast<std::uint32_t>(b)) !=
            list + region.brickCount);
      }
    }
  }
}

TEST(Regions, OfAPartThatAreLeftWholeAreThoseOfAll)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const Box shown = somePart(built);
    const Int3 corner = built.leaves.bounds.lo * std::int64_t(2);
    const RegionTree whole = buildRegions(built.bricks(), built.leaves.bounds, built.cellWidth());
    const RegionTree tree =
      buildRegions(built.bricks(), built.leaves.bounds, built.cellWidth(), {}, {}, shown, true);
    // Both are in the order of their trees' leaves.
    const auto listsOf = [&](const RegionTree& of)
    {
      std::vector<std::vector<std::int64_t>> lists;
      for (const layout::Region& region : of.regions)
      {
        const Box box{ Int3(region.lo) + corner, Int3(region.hi) + corner };
        if (region.brickCount > 0 && box.intersects(shown))
        {
          lists.push_back(
            { region.lo.x, region.lo.y, region.lo.z, region.hi.x, region.hi.y, region.hi.z });
          const auto first = of.brickLists.begin() + region.firstBrick;
          lists.back().insert(lists.back().end(), first, first + region.brickCount);
        }
      }
      return lists;
    };
    ASSERT_EQ(listsOf(tree), listsOf(whole));
  }
}

TEST(Regions, KeepListsShortWhereFewBricksMeet)
{
  // The face between two bricks, the edge of four, the corner of eight: nothing longer, and what
  // lies inside one brick lists it alone.
  const Built built = build(reference::uniform(), 12, { 1, 1, 0 });
  ASSERT_EQ(built.bricks().size(), 8u);
  ASSERT_EQ(built.tree().regions.size(), 27u);
  std::vector<int> ofLength(9, 0);
  for (const layout::Region& region : built.tree().regions)
  {
    ++ofLength[region.brickCount];
  }
  EXPECT_EQ(ofLength, (std::vector<int>{ 0, 8, 12, 0, 6, 0, 0, 0, 1 }));
}

TEST(Regions, ThatAreSmallMayListMoreBricks)
{
  // Where eight bricks meet, what is no longer than six cells is left whole.
  const Built built = build(reference::uniform(), 3, { 1, 8, 6 });
  ASSERT_EQ(built.bricks().size(), 512u);
  const Built split = build(reference::uniform(), 3, { 1, 1, 0 });
  EXPECT_LT(9 * built.tree().regions.size(), split.tree().regions.size());
  std::uint32_t longest = 0;
  for (const layout::Region& region : built.tree().regions)
  {
    const glm::ivec3 size = region.hi - region.lo;
    EXPECT_TRUE(region.brickCount == 1 || std::max({ size.x, size.y, size.z }) <= 12 ||
      region.brickCount == 0);
    longest = std::max(longest, region.brickCount);
  }
  EXPECT_GT(longest, 1u);
  EXPECT_LE(longest, 8u);
}

TEST(Regions, OfNoDataHaveNoBricks)
{
  const RegionTree tree = buildRegions({}, {}, { 1 });
  for (const layout::Region& region : tree.regions)
  {
    EXPECT_EQ(region.brickCount, 0u);
  }
}

TEST(Regions, AreNoTreeWhenProgressAborts)
{
  const Built built = build(reference::twoLevels());
  const auto abort = [](double) { return false; };
  EXPECT_TRUE(
    buildRegions(built.bricks(), built.leaves.bounds, built.cellWidth(), {}, abort).nodes.empty());
}

TEST(Regions, ReportProgressThatGrowsToOne)
{
  const Built built = build(reference::twoLevels());
  double last = 0.0;
  const auto watch = [&](double done)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return true;
  };
  const RegionTree tree =
    buildRegions(built.bricks(), built.leaves.bounds, built.cellWidth(), {}, watch);
  EXPECT_EQ(tree.nodes.size(), 2 * tree.regions.size() - 1);
  EXPECT_GT(last, 0.0);
}
