// SPDX-License-Identifier: BSD-3-Clause
// Parts share the bounds out, have about as many cells each, and come in the order in which they
// hide one another.
#include "Structures.h"

#include "Core/Parts.h"
#include "Scenes/StandIn.h"

#include <gtest/gtest.h>
#include <numeric>

using namespace exabricks;
using exabricks::testing::RandomScenes;

namespace
{
double cellsIn(const LeafBoxes& leaves, const std::vector<std::int64_t>& width, const Box& part)
{
  double cells = 0.0;
  for (const LeafBox& leaf : leaves.boxes)
  {
    const Box common = intersection(scaled(leaf.box, 2), part);
    if (!common.empty())
    {
      const glm::dvec3 size =
        0.5 * glm::dvec3(common.size()) / static_cast<double>(width[leaf.level]);
      cells += size.x * size.y * size.z;
    }
  }
  return cells;
}
}

TEST(Parts, ShareTheBoundsOut)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const reference::Scene scene = reference::randomScene(seed);
    const LeafBoxes leaves = findLeafBoxes(scene.hierarchy);
    const int count = 1 + static_cast<int>(seed % 9);
    const Parts parts = cutIntoParts(
      leaves, buildBricks(leaves, scene.hierarchy.cellWidth), scene.hierarchy.cellWidth, count);
    ASSERT_EQ(parts.boxes.size(), static_cast<std::size_t>(count));
    LatticeVolume volume;
    for (const Box& box : parts.boxes)
    {
      ASSERT_TRUE(box.empty() || scaled(leaves.bounds, 2).contains(box));
      volume += box.volume();
      for (const Box& other : parts.boxes)
      {
        ASSERT_TRUE(&box == &other || box.empty() || other.empty() || !box.intersects(other));
      }
    }
    ASSERT_TRUE(volume == scaled(leaves.bounds, 2).volume());
  }
}

TEST(Parts, HaveAboutAsManyCellsEach)
{
  for (const StandInKind kind :
    { StandInKind::Cloud, StandInKind::Impact5K, StandInKind::Gear, StandInKind::ExajetRear })
  {
    const char* const name = describe(kind).name;
    const StandIn standIn = makeStandIn(kind, 200000);
    const LeafBoxes leaves = findLeafBoxes(standIn.hierarchy);
    for (const int count : { 2, 3, 4, 7, 16 })
    {
      const Parts parts = cutIntoParts(leaves, buildBricks(leaves, standIn.hierarchy.cellWidth),
        standIn.hierarchy.cellWidth, count);
      double most = 0.0;
      double all = 0.0;
      for (const Box& box : parts.boxes)
      {
        const double cells = cellsIn(leaves, standIn.hierarchy.cellWidth, box);
        most = std::max(most, cells);
        all += cells;
      }
      std::cout << name << ", " << count << " parts: most " << most * count / all
                << " of the mean\n";
      EXPECT_NEAR(all, static_cast<double>(leaves.cells), 1e-6 * all);
      EXPECT_LT(most * count / all, 1.1) << name << ", " << count;
    }
  }
}

TEST(Parts, ComeInTheOrderInWhichTheyHideOneAnother)
{
  const StandIn standIn = makeStandIn(StandInKind::Cloud, 20000);
  const LeafBoxes leaves = findLeafBoxes(standIn.hierarchy);
  const Parts parts = cutIntoParts(
    leaves, buildBricks(leaves, standIn.hierarchy.cellWidth), standIn.hierarchy.cellWidth, 7);
  const glm::dvec3 lo(scaled(leaves.bounds, 2).lo);
  const glm::dvec3 size(scaled(leaves.bounds, 2).size());
  for (int n = 0; n < 200; ++n)
  {
    const auto random = [&](int axis) { return reference::noise(axis, Int3(n), 1); };
    // From outside and inside, in perspective and in parallel.
    const glm::dvec3 eye = lo + size * (3.0 * glm::dvec3(random(0), random(1), random(2)) - 1.0);
    const glm::dvec3 to = lo + size * glm::dvec3(random(3), random(4), random(5));
    const bool parallel = n % 2 == 0;
    const std::vector<int> order =
      parts.frontToBack(parallel ? glm::dvec4(eye - to, 0.0) : glm::dvec4(eye, 1.0));
    ASSERT_EQ(order.size(), parts.boxes.size());
    // Along the ray, parts come in this order.
    std::size_t last = 0;
    for (int step = 0; step < 2000; ++step)
    {
      const Int3 at(glm::floor(glm::mix(eye, to, step / 1000.0)));
      for (std::size_t place = 0; place < order.size(); ++place)
      {
        if (parts.boxes[static_cast<std::size_t>(order[place])].contains(at))
        {
          ASSERT_GE(place, last) << n;
          last = place;
        }
      }
    }
  }
}

TEST(Parts, OfLessThanHalfACellAreEmpty)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(1) } } };
  const LeafBoxes leaves = findLeafBoxes(hierarchy);
  const Parts parts =
    cutIntoParts(leaves, buildBricks(leaves, hierarchy.cellWidth), hierarchy.cellWidth, 11);
  const auto empty = static_cast<std::size_t>(std::count_if(
    parts.boxes.begin(), parts.boxes.end(), [](const Box& box) { return box.empty(); }));
  EXPECT_GE(empty, 3u);
  EXPECT_EQ(parts.frontToBack({ -1.0, 0.0, 0.0, 0.0 }).size(), 11u - empty);
}
