// SPDX-License-Identifier: BSD-3-Clause
// Gathered values are the source's, normalised without loss.
#include "Core/Structures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <thread>

using namespace exabricks;
using namespace exabricks::testing;
using namespace exabricks::reference;

namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A row of cells, in one brick.
struct Row
{
  Built built;
  Values values;
};

Row gatherRow(const std::vector<double>& values)
{
  Scene scene;
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(values.size(), 1, 1) } } };
  scene.cells = fillCells(scene.hierarchy, [&](int, const Int3& cell) { return values[cell.x]; });
  Row row{ build(scene, 255), {} };
  row.values = row.built.gather();
  return row;
}

// The same level twice over the same two cells: one block has the values, the other duplicates.
Values gatherTwice(bool firstIsReal)
{
  Scene scene;
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(2, 1, 1) } }, { 0, { Int3(0), Int3(2, 1, 1) } } };
  scene.cells =
    fillCells(scene.hierarchy, [](int, const Int3& cell) { return static_cast<double>(cell.x); });
  markDuplicates(scene.hierarchy, firstIsReal, scene.cells);
  const Built built = build(scene);
  return built.gather();
}

// What the source has for the cell of `level` with the corner `corner` (logical): the value of the
// finest block there that is not finer, and of the real one where there are duplicates.
double expectedValue(const Scene& scene, int level, const Int3& corner)
{
  double found = notANumber;
  int best = -1;
  for (std::size_t b = 0; b < scene.hierarchy.blocks.size(); ++b)
  {
    const Block& block = scene.hierarchy.blocks[b];
    if (block.level > level || !scene.hierarchy.logicalBox(block).contains(corner))
    {
      continue;
    }
    Int3 cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = floorDivide(corner[axis], scene.hierarchy.cellWidth[block.level]);
    }
    const Box cells{ cell, cell + std::int64_t(1) };
    double value = 0.0;
    unsigned char duplicate = 0;
    scene.cells.read(static_cast<int>(b), cells, &value);
    if (scene.cells.hasDuplicates(static_cast<int>(b)))
    {
      scene.cells.readDuplicates(static_cast<int>(b), cells, &duplicate);
    }
    const int rank = 2 * block.level + (duplicate ? 0 : 1);
    if (rank > best)
    {
      best = rank;
      found = value;
    }
  }
  return found;
}

}

TEST(Range, NormalizesItsEndsTo0And1)
{
  const Range range{ -3.0, 5.0 };
  EXPECT_EQ(range.normalize(-3.0), 0.0);
  EXPECT_EQ(range.normalize(1.0), 0.5);
  EXPECT_EQ(range.normalize(5.0), 1.0);
}

TEST(Range, OfOneValueNormalizesItTo0)
{
  EXPECT_EQ((Range{ 101325.0, 101325.0 }).normalize(101325.0), 0.0);
}

TEST(Range, DoesNotOverflow)
{
  const double most = std::numeric_limits<double>::max();
  const Range range{ -most, most };
  EXPECT_EQ(range.normalize(-most), 0.0);
  EXPECT_EQ(range.normalize(0.0), 0.5);
  EXPECT_EQ(range.normalize(most), 1.0);
  // The least one: half of it would be 0.
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ((Range{ 0.0, least }).normalize(least), 1.0);
}

TEST(Range, IsEmptyAtFirst) { EXPECT_TRUE(Range().empty()); }

TEST(Values, AreTheSourcesInBrickOrder)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const Values values = built.gather();
    ASSERT_EQ(values.normalized.size(), built.leaves.cells);

    std::vector<double> expected(values.normalized.size());
    Range range;
    std::uint64_t absent = 0;
    forEachLeafCell(built,
      [&](const Brick& brick, const Int3& corner, std::uint64_t i)
      {
        expected[i] = expectedValue(built.scene, brick.level, corner);
        absent += !std::isfinite(expected[i]);
        if (std::isfinite(expected[i]))
        {
          range.add(expected[i]);
        }
      });
    ASSERT_EQ(values.absentCells, absent);
    ASSERT_EQ(values.range.min, range.min);
    ASSERT_EQ(values.range.max, range.max);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      ASSERT_EQ(values.normalized[i],
        std::isfinite(expected[i])     ? static_cast<float>(range.normalize(expected[i]))
          : expected[i] == HiddenValue ? layout::ABSENT
                                       : layout::UNDEFINED);
    }
  }
}

TEST(Values, SayWhichBricksHaveAbsentCells)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed)
  {
    const Built built = buildRandom(seed);
    const Values values = built.gather();
    for (std::size_t b = 0; b < built.bricks().size(); ++b)
    {
      const auto first = values.normalized.begin() + values.firstValue[b];
      const auto last = first + built.bricks()[b].numberOfCells();
      const auto undefined = std::count(first, last, layout::UNDEFINED);
      ASSERT_EQ(values.brickHasUndefinedCells[b] != 0, undefined > 0);
      ASSERT_EQ(values.brickHasAbsentCells[b] != 0,
        undefined + std::count(first, last, layout::ABSENT) > 0);
    }
  }
}

TEST(Values, CountCellsThatAreNotFiniteAsAbsent)
{
  const Values values = gatherRow({ 1.0, notANumber, 2.0, infinity, HiddenValue, 3.0 }).values;
  EXPECT_EQ(values.absentCells, 3u);
  EXPECT_EQ(values.normalized,
    (std::vector<float>{ 0.0f, layout::UNDEFINED, 0.5f, layout::UNDEFINED, layout::ABSENT, 1.0f }));
}

TEST(Values, HaveAnEmptyRangeWhenAllAreAbsent)
{
  const Values values = gatherRow({ notANumber, notANumber }).values;
  EXPECT_TRUE(values.range.empty());
  EXPECT_EQ(values.absentCells, 2u);
  EXPECT_EQ(values.normalized, std::vector<float>(2, layout::UNDEFINED));
}

TEST(Values, PreferRealCellsToDuplicatesInEitherOrder)
{
  for (const bool firstIsReal : { true, false })
  {
    const Values values = gatherTwice(firstIsReal);
    EXPECT_EQ(values.range.max, 1.0);
    EXPECT_EQ(values.normalized, (std::vector<float>{ 0.0f, 1.0f }));
  }
}

TEST(Values, KeepTheDetailOfANarrowRangeFarFrom0)
{
  std::vector<double> values; // floats of them would be 1/128 apart
  for (int i = 0; i <= 200; ++i)
  {
    values.push_back(101325.0 - 0.1 + 0.001 * i);
  }
  const std::vector<float> normalized = gatherRow(values).values.normalized;
  EXPECT_EQ(std::set<float>(normalized.begin(), normalized.end()).size(), values.size());
  EXPECT_TRUE(std::is_sorted(normalized.begin(), normalized.end()));
}

TEST(Values, KeepTheDetailOfTinyValues)
{
  std::vector<double> values;
  for (int i = 0; i <= 70; ++i) // densities from 1e-28 to 1e-21
  {
    values.push_back(1e-28 * std::pow(10.0, 0.1 * i));
  }
  const std::vector<float> normalized = gatherRow(values).values.normalized;
  EXPECT_EQ(std::set<float>(normalized.begin(), normalized.end()).size(), values.size());
  EXPECT_EQ(normalized.front(), 0.0f);
  EXPECT_EQ(normalized.back(), 1.0f);
}

TEST(Values, MaySpanAllDoubles)
{
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(
    gatherRow({ -most, 0.0, most }).values.normalized, (std::vector<float>{ 0.0f, 0.5f, 1.0f }));
}

TEST(Values, FollowOneAnotherBrickByBrick)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed)
  {
    const Built built = buildRandom(seed);
    const Values values = built.gather();
    std::uint64_t next = 0;
    ASSERT_EQ(values.firstValue.size(), built.bricks().size() + 1);
    for (std::size_t b = 0; b < built.bricks().size(); ++b)
    {
      ASSERT_EQ(values.firstValue[b], next);
      next += built.bricks()[b].numberOfCells();
    }
    ASSERT_EQ(values.firstValue.back(), next);
  }
}

TEST(Values, AreNoneWhenProgressAborts)
{
  const Built built = build(twoLevels(), 1);
  for (const double at : { 0.0, 0.6 })
  {
    const auto abort = [&](double done) { return done < at; };
    EXPECT_TRUE(gatherValues(*built.structure, built.scene.cells, abort).normalized.empty());
    EXPECT_FALSE(makeValues(*built.structure, built.scene.cells, abort));
  }
}

TEST(Values, ReportProgressFromTheCallingThread)
{
  const Built built = build(twoLevels(), 1);
  const auto caller = std::this_thread::get_id();
  double last = 0.0;
  const auto watch = [&](double done)
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_GE(done, last);
    last = done;
    return true;
  };
  EXPECT_FALSE(gatherValues(*built.structure, built.scene.cells, watch).normalized.empty());
  EXPECT_EQ(last, 1.0);
  last = 0.0;
  EXPECT_TRUE(makeValues(*built.structure, built.scene.cells, watch));
  EXPECT_EQ(last, 1.0);
}
