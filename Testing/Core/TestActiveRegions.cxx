// SPDX-License-Identifier: BSD-3-Clause
// The pruned tree leads to the regions that show something, and to no others.
#include "Core/ActiveRegions.h"
#include "Core/Structures.h"
#include "Scenes/StandIn.h"

#include <array>
#include <functional>
#include <gtest/gtest.h>
#include <random>

using namespace exabricks;
using namespace exabricks::testing;

namespace
{
// The leaf that holds a point, as the march finds it: 4 * place in the brick lists + KD_LEAF, or
// nothing.
std::uint32_t findLeaf(const std::vector<layout::KdNode>& nodes, const glm::ivec3& p)
{
  layout::KdNode node = nodes[0];
  while ((node.link & 3) != layout::KD_LEAF)
  {
    const std::uint32_t axis = node.link & 3;
    node = nodes[(node.link >> 2) + (p[axis] >= node.plane ? 1 : 0)];
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
  explicit Ranged(Built b, int macrocellCells = MacrocellCells)
    : built(std::move(b))
    , volume{ built.structure, withRanges(built, macrocellCells) }
    , values(*volume.values)
    , ranges(values.ranges)
  {
  }

  ActiveRegions select(const TransferFunction& transfer) const
  {
    return selectActiveRegions(this->volume, transfer);
  }

  const Built built;
  const Volume volume;
  const Values& values;
  const ValueRanges& ranges;

private:
  static std::shared_ptr<const Values> withRanges(const Built& built, int macrocellCells)
  {
    auto values = std::make_shared<Values>(built.gather());
    values->ranges = findValueRanges(*built.structure, *values, macrocellCells);
    return values;
  }
};

bool contains(const layout::ActiveBox& box, const glm::ivec3& p)
{
  return glm::all(glm::greaterThanEqual(p, box.lo)) && glm::all(glm::lessThan(p, box.hi));
}

TransferFunction above(double value)
{
  return TransferFunction(
    { { value, glm::dvec4(1.0, 1.0, 1.0, 0.0) }, { value + 0.01, glm::dvec4(1.0) } });
}
}

TEST(ActiveRegions, AreThoseTheTransferFunctionShows)
{
  const Ranged ranged(build(reference::twoLevels()), 1000); // as a whole
  const ActiveRegions active = ranged.select(above(0.8));
  std::size_t next = 0;
  for (std::uint32_t r = 0; r < ranged.ranges.regions.size(); ++r)
  {
    const layout::Region& region = ranged.built.tree().regions[r];
    if (ranged.ranges.regions[r].max > 0.8f)
    {
      ASSERT_LT(next, active.boxes.size());
      EXPECT_EQ(active.boxes[next].lo, region.lo);
      EXPECT_EQ(active.boxes[next].hi, region.hi);
      EXPECT_EQ(active.boxes[next].firstBrick, region.firstBrick);
      ++next;
    }
  }
  EXPECT_EQ(active.boxes.size(), next);
  EXPECT_EQ(active.regions, next);
  EXPECT_GT(next, 0u);
  EXPECT_LT(next, ranged.ranges.regions.size());
}

TEST(ActiveRegions, AreReachedThroughTheTreeAndNoOthers)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Ranged ranged(buildRandom(seed), 1 + seed % 8);
    const RegionTree& tree = ranged.built.tree();
    const ActiveRegions active = ranged.select(above(0.9 + 0.02 * (seed % 5)));
    for (const layout::ActiveBox& box : active.boxes)
    {
      ASSERT_EQ(findLeaf(active.nodes, box.lo), box.firstBrick);
      ASSERT_EQ(findLeaf(active.nodes, box.hi - 1), box.firstBrick);
    }
    // any point of a region leads to its list where a box holds it, and to nothing elsewhere
    for (std::uint32_t r = 0; r < tree.regions.size(); ++r)
    {
      const layout::Region& region = tree.regions[r];
      for (const glm::ivec3& p : { region.lo, region.hi - 1, (region.lo + region.hi) / 2 })
      {
        const bool held = std::any_of(active.boxes.begin(), active.boxes.end(),
          [&](const layout::ActiveBox& box) { return contains(box, p); });
        ASSERT_EQ(findLeaf(active.nodes, p),
          held ? region.firstBrick : std::uint32_t(layout::KD_NO_REGION));
      }
    }
    ASSERT_EQ(active.nodes.size(), 2 * countLeaves(active.nodes, 0) - 1);
  }
}

TEST(ActiveRegions, AreCutWhereSomeMacrocellsShowNothing)
{
  // One brick, of which one octant shows.
  reference::Scene scene;
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(32) } } };
  scene.cells = reference::fillCells(scene.hierarchy,
    [](int, const Int3& c) { return c.x >= 24 && c.y >= 24 && c.z >= 24 ? 1.0 : 0.0; });
  const Ranged ranged(build(scene));
  ASSERT_EQ(ranged.built.tree().regions.size(), 1u);
  const ActiveRegions active = ranged.select(above(0.5));
  ASSERT_EQ(active.boxes.size(), 1u);
  // cells up to 24 have tents that end at 25: half cells from 47 on; macrocells are 16 long
  EXPECT_EQ(active.boxes[0].lo, glm::ivec3(32));
  EXPECT_EQ(active.boxes[0].hi, glm::ivec3(64));
  EXPECT_EQ(active.boxes[0].step, 2.0f);
}

TEST(ActiveRegions, LoseNoMacrocellThatShowsAnything)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Ranged ranged(buildRandom(seed), 2);
    const TransferFunction transfer = above(0.9);
    const ActiveRegions active = ranged.select(transfer);
    for (const MacrocellGrid& grid : ranged.ranges.grids)
    {
      const layout::Region& region = ranged.built.tree().regions[grid.region];
      const glm::ivec3 n = grid.count(region);
      for (int i = 0; i < n.x * n.y * n.z; ++i)
      {
        const glm::ivec3 lo =
          region.lo + glm::ivec3(i % n.x, i / n.x % n.y, i / (n.x * n.y)) * grid.side;
        if (transfer.visible(ranged.ranges.macrocells[grid.firstRange + i]))
        {
          ASSERT_EQ(findLeaf(active.nodes, lo), region.firstBrick);
          ASSERT_EQ(
            findLeaf(active.nodes, glm::min(lo + grid.side, region.hi) - 1), region.firstBrick);
        }
      }
    }
  }
}

TEST(ActiveRegions, SayTheFinestCellAndWhetherSomeAreAbsent)
{
  const Ranged ranged(build(reference::holes()));
  const TransferFunction all({ { 0.0, glm::dvec4(1.0) } });
  int absent = 0;
  for (const layout::ActiveBox& box : ranged.select(all).boxes)
  {
    const layout::Region& region =
      *std::find_if(ranged.built.tree().regions.begin(), ranged.built.tree().regions.end(),
        [&](const layout::Region& r)
        {
          return glm::all(glm::lessThanEqual(r.lo, box.lo)) &&
            glm::all(glm::greaterThanEqual(r.hi, box.hi));
        });
    std::int64_t finest = std::numeric_limits<std::int64_t>::max();
    bool some = false;
    for (std::uint32_t k = 0; k < region.brickCount; ++k)
    {
      const std::uint32_t b = ranged.built.tree().brickLists[region.firstBrick + k];
      finest = std::min(finest, ranged.built.width(ranged.built.bricks()[b]));
      some = some || ranged.values.brickHasAbsentCells[b];
    }
    EXPECT_EQ(std::abs(box.step), static_cast<float>(2 * finest));
    EXPECT_EQ(box.step < 0.0f, some);
    absent += some;
  }
  EXPECT_GT(absent, 0);
}

TEST(ActiveRegions, AreAllWithDataWhenAllIsOpaque)
{
  const Ranged ranged(build(reference::holes()));
  const ActiveRegions active = ranged.select(TransferFunction({ { 0.0, glm::dvec4(1.0) } }));
  std::size_t withData = 0;
  for (const ValueRange& range : ranged.ranges.regions)
  {
    withData += !range.empty();
  }
  EXPECT_EQ(active.regions, withData);
}

TEST(ActiveRegions, AreAllWithBricksAsAWholeWhereNoneIsSkipped)
{
  const Ranged ranged(build(reference::holes()), 1);
  const ActiveRegions all = selectAllRegions(ranged.volume);
  std::size_t withBricks = 0;
  for (const layout::Region& region : ranged.built.tree().regions)
  {
    withBricks += region.brickCount > 0;
  }
  EXPECT_EQ(all.regions, withBricks);
  EXPECT_EQ(all.boxes.size(), withBricks);
}

TEST(ActiveRegions, KnowTheExtremesBelowEachNode)
{
  for (const Extreme extreme : { Extreme::Greatest, Extreme::Least })
  {
    const auto combine = [=](float a, float b)
    { return extreme == Extreme::Greatest ? std::max(a, b) : std::min(a, b); };
    const float nothing = extreme == Extreme::Greatest ? -std::numeric_limits<float>::infinity()
                                                       : std::numeric_limits<float>::infinity();
    const Ranged ranged(build(reference::holes()), 2);
    const TransferFunction all({ { 0.0, glm::dvec4(1.0) } });
    const ActiveRegions active =
      selectActiveRegions(ranged.volume, all, nullptr, { true, extreme });
    ASSERT_EQ(active.nodeExtremes.size(), active.nodes.size());
    ASSERT_EQ(active.boxExtremes.size(), active.boxes.size());
    ASSERT_GT(active.boxes.size(), 1u);
    // That of a node is that of the boxes below it, which come in the order of leaves.
    std::size_t leaves = 0;
    const std::function<float(std::size_t)> find = [&](std::size_t n)
    {
      const std::uint32_t index = active.nodes[n].link >> 2;
      float found = nothing;
      if ((active.nodes[n].link & 3) != layout::KD_LEAF)
      {
        found = find(index);
        found = combine(found, find(index + 1));
      }
      else if (index != layout::KD_NO_REGION)
      {
        found = active.boxExtremes[leaves++];
      }
      EXPECT_EQ(active.nodeExtremes[n], found);
      return found;
    };
    find(0);
    EXPECT_EQ(leaves, active.boxes.size());
    // That of a box is that of the macrocells in it.
    for (std::size_t i = 0; i < active.boxes.size(); ++i)
    {
      const layout::ActiveBox& box = active.boxes[i];
      float found = nothing;
      for (std::uint32_t r = 0; r < ranged.built.tree().regions.size(); ++r)
      {
        const layout::Region& region = ranged.built.tree().regions[r];
        const auto grid = std::find_if(ranged.ranges.grids.begin(), ranged.ranges.grids.end(),
          [=](const MacrocellGrid& of) { return of.region == r; });
        const glm::ivec3 n =
          grid != ranged.ranges.grids.end() ? grid->count(region) : glm::ivec3(1);
        for (int k = 0; k < n.x * n.y * n.z && region.brickCount > 0; ++k)
        {
          const glm::ivec3 at(k % n.x, k / n.x % n.y, k / (n.x * n.y));
          const bool cut = grid != ranged.ranges.grids.end();
          const ValueRange& range =
            cut ? ranged.ranges.macrocells[grid->firstRange + k] : ranged.ranges.regions[r];
          if (contains(box, cut ? grid->corner(region, at) : region.lo))
          {
            found = combine(found, extreme == Extreme::Greatest ? range.max : range.min);
          }
        }
      }
      EXPECT_EQ(active.boxExtremes[i], found);
    }
  }
}

// So many regions that subtrees of them are selected at once.
TEST(ActiveRegions, OfManyRegionsComeInOrderWithTheirTree)
{
  const StandIn standIn = makeStandIn(StandInKind::Impact5K, 400000);
  auto structure = std::make_shared<const Structure>(buildStructure(standIn.hierarchy));
  auto values = std::make_shared<Values>(gatherValues(*structure, *standIn.cells));
  values->ranges = findValueRanges(*structure, *values, 1000); // none is cut
  Volume volume{ structure, values };
  ASSERT_GT(structure->tree.regions.size(), 20000u);
  const TransferFunction transfer = above(0.1);
  const ActiveRegions active =
    selectActiveRegions(volume, transfer, nullptr, { true, Extreme::Greatest });
  ASSERT_EQ(active.nodes.size(), 2 * countLeaves(active.nodes, 0) - 1);
  ASSERT_EQ(active.nodeExtremes.size(), active.nodes.size());
  ASSERT_EQ(active.boxExtremes.size(), active.boxes.size());
  std::size_t next = 0;
  float greatest = 0.0f;
  for (std::size_t r = 0; r < structure->tree.regions.size(); ++r)
  {
    const layout::Region& region = structure->tree.regions[r];
    const bool shows = region.brickCount > 0 && transfer.visible(values->ranges.regions[r]);
    ASSERT_EQ(findLeaf(active.nodes, region.lo),
      shows ? region.firstBrick : std::uint32_t(layout::KD_NO_REGION));
    if (shows)
    {
      ASSERT_LT(next, active.boxes.size());
      ASSERT_EQ(active.boxes[next].lo, region.lo);
      ASSERT_EQ(active.boxExtremes[next], values->ranges.regions[r].max);
      greatest = std::max(greatest, values->ranges.regions[r].max);
      ++next;
    }
  }
  EXPECT_EQ(active.boxes.size(), next);
  EXPECT_EQ(active.regions, next);
  EXPECT_EQ(active.boxCount, next);
  EXPECT_GT(next, 1000u);
  EXPECT_LT(next, structure->tree.regions.size());
  EXPECT_EQ(active.nodeExtremes[0], greatest);

  // Cut between macrocells: of each of them that shows anything its place leads to the region's
  // list, and of others none does.
  auto cut = std::make_shared<Values>(*values);
  cut->ranges = findValueRanges(*structure, *values, 2);
  volume.values = cut;
  const ActiveRegions parts = selectActiveRegions(volume, transfer);
  ASSERT_GT(cut->ranges.grids.size(), 1000u);
  EXPECT_EQ(parts.regions, active.regions);
  EXPECT_NE(parts.boxCount, active.boxCount);
  ASSERT_EQ(parts.nodes.size(), 2 * countLeaves(parts.nodes, 0) - 1);
  for (const MacrocellGrid& grid : cut->ranges.grids)
  {
    const layout::Region& region = structure->tree.regions[grid.region];
    const glm::ivec3 n = grid.count(region);
    for (int k = 0; k < n.x * n.y * n.z && region.brickCount > 0; ++k)
    {
      const glm::ivec3 at(k % n.x, k / n.x % n.y, k / (n.x * n.y));
      const bool shows =
        transfer.visible(cut->ranges.macrocells[grid.firstRange + static_cast<std::size_t>(k)]);
      ASSERT_EQ(findLeaf(parts.nodes, grid.corner(region, at)),
        shows ? region.firstBrick : std::uint32_t(layout::KD_NO_REGION));
    }
  }
}

TEST(ActiveRegions, OfNothingToShowAreATreeOfOneNode)
{
  const Ranged ranged(build(reference::twoLevels()));
  const ActiveRegions active = ranged.select(TransferFunction());
  EXPECT_TRUE(active.boxes.empty());
  EXPECT_EQ(active.regions, 0u);
  ASSERT_EQ(active.nodes.size(), 1u);
  EXPECT_EQ(active.nodes[0].link, 4 * layout::KD_NO_REGION + layout::KD_LEAF);
}

TEST(ActiveRegions, SortedByMedianSplitsAreTheSameRegions)
{
  const Ranged ranged(build(reference::twoLevels(), 4, { 1, 1, 0 }));
  const std::vector<layout::ActiveBox> boxes = ranged.select(above(0.3)).boxes;
  ActiveRegions active;
  active.boxes = boxes;
  std::shuffle(active.boxes.begin(), active.boxes.end(), std::mt19937(7));
  for (const layout::ActiveBox& box : active.boxes)
  {
    active.boxExtremes.push_back(static_cast<float>(box.lo.x));
  }
  sortByMedianSplits(active);
  const std::vector<layout::ActiveBox>& sorted = active.boxes;
  ASSERT_EQ(active.boxExtremes.size(), sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    EXPECT_EQ(active.boxExtremes[i], static_cast<float>(sorted[i].lo.x)) << "a box keeps its own";
  }

  // The first half lies below the second along one axis.
  bool halved = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    int lower = 0;
    int upper = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      const int center = sorted[i].lo[axis] + sorted[i].hi[axis];
      (i < sorted.size() / 2 ? lower : upper) =
        i < sorted.size() / 2 ? std::max(lower, center) : std::min(upper, center);
    }
    halved = halved || lower <= upper;
  }
  EXPECT_TRUE(halved);
  const auto corners = [](const std::vector<layout::ActiveBox>& of)
  {
    std::vector<std::array<int, 3>> los;
    for (const layout::ActiveBox& box : of)
    {
      los.push_back({ { box.lo.x, box.lo.y, box.lo.z } });
    }
    std::sort(los.begin(), los.end());
    return los;
  };
  EXPECT_EQ(corners(sorted), corners(boxes));
}
