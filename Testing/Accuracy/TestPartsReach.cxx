// SPDX-License-Identifier: BSD-3-Clause
// What is reconstructed in a part (Core/Parts) depends on the cells within its reach alone.
#include "Accuracy/Candidates.h"
#include "Core/Parts.h"
#include "Reference/Field.h"

#include <gtest/gtest.h>

using namespace exabricks;

TEST(PartsReach, HoldsAllThatCounts)
{
  for (const reference::Scene& scene :
    { reference::twoLevels(), reference::ratio4(), reference::mixedRatios() })
  {
    const std::vector<std::int64_t>& width = scene.hierarchy.cellWidth;
    const LeafBoxes leaves = findLeafBoxes(scene.hierarchy);
    const reference::Field all(scene.hierarchy, leaves, scene.cells, std::nullopt);
    const auto value = [&](int level, const Int3& cell) { return *all.find(level, cell); };
    const accuracy::Candidates completed(scene.hierarchy, leaves, value);
    const Parts parts = cutIntoParts(leaves, buildBricks(leaves, width), width, 4);
    for (const Box& inHalfCells : parts.boxes)
    {
      const Box part = outwardToCells(inHalfCells, 2);
      for (const bool completes : { false, true })
      {
        const std::vector<std::int64_t> reach = findReach(leaves, width, inHalfCells, completes);
        LeafBoxes near;
        for (const LeafBox& leaf : leaves.boxes)
        {
          const std::int64_t by = reach[static_cast<std::size_t>(leaf.level)];
          const Box common = intersection(leaf.box, { part.lo - by, part.hi + by });
          if (!common.empty())
          {
            const Box cells = outwardToCells(common, width[static_cast<std::size_t>(leaf.level)]);
            near.boxes.push_back(
              { leaf.level, scaled(cells, width[static_cast<std::size_t>(leaf.level)]) });
            near.bounds = unite(near.bounds, near.boxes.back().box);
          }
        }
        const reference::Field some(scene.hierarchy, near, scene.cells, all.range());
        const accuracy::Candidates someCompleted(scene.hierarchy, near, value);
        double most = 0.0;
        for (int n = 0; n < 400; ++n)
        {
          const auto random = [&](int axis) { return reference::noise(axis, Int3(n), 2); };
          // Samples may lie beyond the part, by two of the finest cells in any case.
          const glm::dvec3 at = glm::dvec3(part.lo) - 2.0 +
            (4.0 + glm::dvec3(part.size())) * glm::dvec3(random(0), random(1), random(2));
          const auto expected = all.sample(at, reference::Reconstruction::Basis);
          const auto found = some.sample(at, reference::Reconstruction::Basis);
          ASSERT_EQ(expected.has_value(), found.has_value());
          if (expected)
          {
            most = std::max(most,
              completes ? std::abs(completed.completed(at) - someCompleted.completed(at))
                        : std::abs(*expected - *found));
          }
        }
        EXPECT_LT(most, 1e-9) << scene.name << (completes ? ", completed" : ", basis");
      }
    }
  }
}
