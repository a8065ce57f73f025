// SPDX-License-Identifier: BSD-3-Clause
// What a region's list of bricks says of a point is what all leaf cells say.
#include "Core/Structures.h"
#include "Reference/Oracle.h"

#include <cmath>
#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <random>

using namespace exabricks;
using namespace exabricks::testing;
using namespace exabricks::reference;

namespace
{
template <typename T>
struct Sums
{
  T values = 0; // of weight times value
  T weights = 0;
};

// The tents of a brick's cells at p (half cells from the bounds' corner), in the clamped form: the
// trilinear weights at the nearest point between its cells' centres, times the distance's tent.
template <typename T>
void addBrick(
  const Built& built, const Values& values, std::uint32_t b, const glm::vec<3, T>& p, Sums<T>& sums)
{
  using Vec3 = glm::vec<3, T>;
  const Brick& brick = built.bricks()[b];
  const Vec3 lo((brick.lo - built.tree().bounds.lo) * std::int64_t(2));
  const Vec3 q = (p - lo) / static_cast<T>(2 * built.width(brick)) - static_cast<T>(0.5);
  const Vec3 n(brick.cells);
  const Vec3 c = glm::clamp(q, Vec3(0), n - static_cast<T>(1));
  const Vec3 h = glm::max(Vec3(1) - glm::abs(q - c), Vec3(0));
  const T weight = h.x * h.y * h.z;
  const glm::ivec3 base = glm::min(glm::ivec3(c), glm::max(brick.cells - 2, glm::ivec3(0)));
  const Vec3 f = c - Vec3(base);
  Sums<T> brickSums;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const T tent = (step.x ? f.x : 1 - f.x) * (step.y ? f.y : 1 - f.y) * (step.z ? f.z : 1 - f.z);
    const glm::ivec3 cell = glm::min(base + step, brick.cells - 1);
    const float value = values.ofBrick(
      b)[cell.x + brick.cells.x * (cell.y + static_cast<std::uint64_t>(brick.cells.y) * cell.z)];
    if (value >= 0.0f)
    {
      brickSums.values += tent * value;
      brickSums.weights += tent;
    }
  }
  sums.values += weight * brickSums.values;
  sums.weights += weight * brickSums.weights;
}

template <typename T>
Sums<T> sumOverRegion(
  const Built& built, const Values& values, const layout::Region& region, const glm::vec<3, T>& p)
{
  Sums<T> sums;
  for (std::uint32_t k = 0; k < region.brickCount; ++k)
  {
    addBrick(built, values, built.tree().brickLists[region.firstBrick + k], p, sums);
  }
  return sums;
}

// A point strictly inside the region, in half cells, that floats hold exactly.
glm::vec3 pickPoint(const layout::Region& region, std::mt19937& random)
{
  glm::vec3 p;
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = static_cast<float>(region.lo[axis]) +
      static_cast<float>(region.hi[axis] - region.lo[axis]) *
        (static_cast<float>(random() % 255 + 1) / 256.0f);
  }
  return p;
}

// Calls visit(built, values, ranges, index of region, point) at random points, in about as many
// regions of each random scene as asked for.
template <typename Visitor>
void forRandomPoints(std::size_t regions, int pointsPerRegion, const Visitor& visit)
{
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const Values values = built.gather();
    const ValueRanges ranges = findValueRanges(*built.structure, values);
    std::mt19937 random(seed);
    const std::size_t step = built.tree().regions.size() / regions + 1;
    for (std::size_t r = 0; r < built.tree().regions.size(); r += step)
    {
      for (int i = 0; i < pointsPerRegion && built.tree().regions[r].brickCount > 0; ++i)
      {
        visit(built, values, ranges, r, pickPoint(built.tree().regions[r], random));
        if (::testing::Test::HasFatalFailure())
        {
          return;
        }
      }
    }
  }
}
}

TEST(Reconstruction, TakesTheSameFromTheRegionsListAsFromAllBricks)
{
  forRandomPoints(50, 2,
    [](const Built& built, const Values& values, const ValueRanges&, std::size_t r,
      const glm::vec3& p)
    {
      const Sums<float> listed = sumOverRegion(built, values, built.tree().regions[r], p);
      Sums<float> all;
      for (std::uint32_t b = 0; b < built.bricks().size(); ++b)
      {
        addBrick(built, values, b, p, all);
      }
      // bit for bit: a brick out of reach weighs exactly 0
      ASSERT_EQ(listed.values, all.values);
      ASSERT_EQ(listed.weights, all.weights);
    });
}

TEST(Reconstruction, NeverLeavesTheRangeOfTheRegion)
{
  forRandomPoints(300, 4,
    [](const Built& built, const Values& values, const ValueRanges& ranges, std::size_t r,
      const glm::vec3& p)
    {
      const layout::Region& region = built.tree().regions[r];
      // A mean stays in the range. Rounding adds a few ulp: each sum rounds once per term.
      const Sums<double> sums = sumOverRegion(built, values, region, glm::dvec3(p));
      const Sums<float> rounded = sumOverRegion(built, values, region, p);
      if (sums.weights > 0.0)
      {
        const double value = sums.values / sums.weights;
        ASSERT_GE(value, ranges.regions[r].min * (1.0 - 1e-14));
        ASSERT_LE(value, ranges.regions[r].max * (1.0 + 1e-14));
        const float slack =
          2.0f * std::numeric_limits<float>::epsilon() * static_cast<float>(region.brickCount + 4);
        ASSERT_GE(rounded.values / rounded.weights, ranges.regions[r].min * (1.0f - slack));
        ASSERT_LE(rounded.values / rounded.weights, ranges.regions[r].max * (1.0f + slack));
      }
    });
}

TEST(Reconstruction, OfBricksIsThatOfLeafCells)
{
  int visited = 0;
  for (std::uint32_t seed = 0; seed < RandomScenes; ++seed)
  {
    SCOPED_TRACE(seed);
    const Built built = buildRandom(seed);
    const Values values = built.gather();
    const Oracle oracle(built.hierarchy(), built.leaves, built.scene.cells);
    std::mt19937 random(seed);
    for (const layout::Region& region : built.tree().regions)
    {
      const glm::dvec3 p = pickPoint(region, random);
      const glm::dvec3 logical = 0.5 * p + glm::dvec3(built.tree().bounds.lo);
      const std::optional<double> expected = oracle.sample(logical, Reconstruction::Basis);
      if (region.brickCount == 0)
      {
        ASSERT_FALSE(expected);
      }
      if (expected)
      {
        const Sums<double> sums = sumOverRegion(built, values, region, p);
        ASSERT_NEAR(sums.values / sums.weights, *expected, 1e-6); // stored values are floats
        ++visited;
      }
    }
  }
  EXPECT_GT(visited, 10000);
}

TEST(Reconstruction, ReturnsAConstantExactlyAcrossLevels)
{
  Scene scene = mixedRatios();
  scene.cells = fillCells(scene.hierarchy, [](int, const Int3&) { return 0.75; });
  const Built built = build(scene);
  const Oracle oracle(built.hierarchy(), built.leaves, built.scene.cells, Range{ 0.0, 1.0 });
  std::mt19937 random(1);
  for (const layout::Region& region : built.tree().regions)
  {
    const glm::dvec3 p = 0.5f * pickPoint(region, random);
    ASSERT_NEAR(*oracle.sample(p, Reconstruction::Basis), 0.75, 1e-15);
  }
}
