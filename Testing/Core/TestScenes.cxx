// SPDX-License-Identifier: BSD-3-Clause
// The random hierarchies that the other tests use meet the cases that matter, and often.
#include "Core/Structures.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace exabricks;
using namespace exabricks::testing;
using namespace exabricks::reference;

TEST(RandomHierarchies, MeetAllCases)
{
  int ofLevels[5] = {};
  int partlyCovered = 0;
  int overlapping = 0;
  int withHoles = 0;
  int acrossZero = 0;
  int ratioOf3 = 0;
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    const Hierarchy hierarchy = randomHierarchy(seed);
    const LeafBoxes leaves = findLeafBoxes(hierarchy);
    ++ofLevels[hierarchy.levels()];
    partlyCovered += leaves.partlyCoveredBoxes > 0;
    bool overlaps = false;
    for (const Block& a : hierarchy.blocks)
    {
      for (const Block& b : hierarchy.blocks)
      {
        overlaps = overlaps || (&a != &b && a.level == b.level && a.cells.intersects(b.cells));
      }
    }
    overlapping += overlaps;
    withHoles += finestLevels(hierarchy).count(-1) > 0;
    acrossZero += leaves.bounds.lo.x < 0 && leaves.bounds.hi.x > 0;
    ratioOf3 += hierarchy.cellWidth[0] % 3 == 0;
  }
  for (int levels = 1; levels <= 4; ++levels)
  {
    EXPECT_GT(ofLevels[levels], 15);
  }
  EXPECT_GT(partlyCovered, 40);
  EXPECT_GT(overlapping, 40);
  EXPECT_GT(withHoles, 80);
  EXPECT_GT(acrossZero, 40);
  EXPECT_GT(ratioOf3, 40);
}

TEST(RandomScenes, HaveAbsentCellsAndDuplicates)
{
  int withDuplicates = 0;
  int withAbsentCells = 0;
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    const Scene scene = randomScene(seed);
    bool duplicates = false;
    bool absent = false;
    for (std::size_t b = 0; b < scene.hierarchy.blocks.size(); ++b)
    {
      duplicates = duplicates || scene.cells.hasDuplicates(static_cast<int>(b));
      for (const double value : scene.cells.values[b])
      {
        absent = absent || !std::isfinite(value);
      }
    }
    withDuplicates += duplicates;
    withAbsentCells += absent;
  }
  EXPECT_GT(withDuplicates, 20);
  EXPECT_GT(withAbsentCells, 80);
}

TEST(Scenes, AreHierarchiesWithoutFault)
{
  for (const Scene& scene : allScenes())
  {
    EXPECT_EQ(findFault(scene.hierarchy), "") << scene.name;
    EXPECT_GT(findLeafBoxes(scene.hierarchy).cells, 1000u) << scene.name;
  }
}

TEST(Scenes, ShowWhatTheirNamesSay)
{
  EXPECT_EQ(uniform().hierarchy.cellWidth, (std::vector<std::int64_t>{ 1 }));
  EXPECT_EQ(twoLevels().hierarchy.cellWidth, (std::vector<std::int64_t>{ 2, 1 }));
  EXPECT_EQ(ratio4().hierarchy.cellWidth, (std::vector<std::int64_t>{ 4, 1 }));
  EXPECT_EQ(mixedRatios().hierarchy.cellWidth, (std::vector<std::int64_t>{ 6, 2, 1 }));
  EXPECT_EQ(anisotropic().hierarchy.spacing, glm::dvec3(1.0, 1.0, 2.0));
  EXPECT_GT(finestLevels(holes().hierarchy).count(-1), 0u);
  EXPECT_GT(findLeafBoxes(partlyCovered().hierarchy).partlyCoveredBoxes, 0u);
}

TEST(Scenes, RefineInTheShellOnly)
{
  for (const Scene& scene : { twoLevels(), ratio4(), mixedRatios(), holes() })
  {
    int ofLevel[4] = {};
    for (const LeafBox& leaf : findLeafBoxes(scene.hierarchy).boxes)
    {
      ++ofLevel[leaf.level];
    }
    for (int level = 0; level < scene.hierarchy.levels(); ++level)
    {
      EXPECT_GT(ofLevel[level], 0) << scene.name << ", level " << level;
    }
  }
}
