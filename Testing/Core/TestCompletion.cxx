// SPDX-License-Identifier: BSD-3-Clause
// Levels are completed beyond their leaf cells by values that make sense, also where there is
// little to go by. (What they are where there is enough: CompletesLevels.)
#include "Core/Completion.h"
#include "Reference/Scenes.h"

#include <gtest/gtest.h>
#include <limits>

using namespace exabricks;

namespace
{
// A linear field of which some fine cells are there alone, completed: the greatest deviation of a
// value in a layer.
double deviation(const std::function<bool(const Int3& fineCell)>& there)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(8) } }, { 1, { Int3(4), Int3(12) } } };
  const auto linear = [](const glm::dvec3& p) { return (3.0 * p.x + p.y + p.z) / 80.0; };
  const reference::ArraySource source = reference::fillCells(hierarchy,
    [&](int level, const Int3& c)
    {
      const double width = level == 0 ? 2.0 : 1.0;
      return level == 0 || there(c) ? linear((glm::dvec3(c) + 0.5) * width)
                                    : std::numeric_limits<double>::quiet_NaN();
    });
  const Structure structure = buildStructure(hierarchy);
  const auto completed = complete(structure, gatherValues(structure, source));
  EXPECT_EQ(completed->layer, 1);
  EXPECT_EQ(completed->ranges.regions.size(), structure.tree.regions.size());
  double greatest = 0.0;
  const float* value = completed->normalized.data();
  for (const Brick& brick : structure.bricks)
  {
    const double width = static_cast<double>(hierarchy.cellWidth[brick.level]);
    glm::ivec3 c;
    for (c.z = -1; c.z <= brick.cells.z; ++c.z)
    {
      for (c.y = -1; c.y <= brick.cells.y; ++c.y)
      {
        for (c.x = -1; c.x <= brick.cells.x; ++c.x, ++value)
        {
          const glm::dvec3 p = glm::dvec3(brick.lo) + (glm::dvec3(c) + 0.5) * width;
          const bool inside = p.x > 1.0 && p.y > 1.0 && p.z > 1.0 && p.x < 15.0 && p.y < 15.0 &&
            p.z < 15.0; // at the bounds values stay
          EXPECT_TRUE(*value < 0.0f || (*value >= 0.0f && *value <= 1.0f));
          if (inside && *value >= 0.0f)
          {
            greatest = std::max(greatest, std::abs(*value - completed->range.normalize(linear(p))));
          }
        }
      }
    }
  }
  return greatest;
}
}

TEST(Completion, IsExactForLinearFields)
{
  EXPECT_LT(deviation([](const Int3&) { return true; }), 1e-6);
}

TEST(Completion, GuessesNoSlopeFromOneNeighbour)
{
  // A fine cell in the middle of a face of the fine block is the one neighbour of its coarse one:
  // it tells the slope along the way to it alone. Two cells off is all that can go wrong.
  for (int axis = 0; axis < 3; ++axis)
  {
    Int3 cell(7);
    cell[axis] = 4;
    EXPECT_LT(deviation([&](const Int3& c) { return c == cell; }), 0.15) << axis;
  }
  EXPECT_LT(deviation([](const Int3&) { return false; }), 0.15);
}
