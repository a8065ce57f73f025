// SPDX-License-Identifier: BSD-3-Clause
// A volume without its finest level holds the means of what it had.
#include "Core/Coarsening.h"
#include "Core/Completion.h"
#include "Core/Structure.h"
#include "Reference/Scenes.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
struct Subject
{
  Structure structure;
  Scalars scalars;
  ValueRanges ranges;

  explicit Subject(const reference::Scene& scene)
    : structure(buildStructure(scene.hierarchy))
    , scalars(gatherScalars(scene.hierarchy, structure.bricks, scene.cells))
    , ranges(findValueRanges(structure.tree, structure.bricks, scene.hierarchy.cellWidth, scalars))
  {
  }

  Volume volume() const
  {
    return { &this->structure.tree, &this->structure.bricks, &this->structure.hierarchy.cellWidth,
      &this->scalars, &this->ranges };
  }
};

// The volume's value, and its size: values times finest cells of `unit` that have one.
struct Mass
{
  double value = 0.0;
  double size = 0.0;
};

Mass massOf(const Volume& volume, double unit)
{
  Mass mass;
  for (const Brick& brick : *volume.bricks)
  {
    const double width = unit * static_cast<double>((*volume.cellWidth)[brick.level]);
    for (std::uint64_t i = 0; i < brick.numberOfCells(); ++i)
    {
      const double value = volume.scalars->values[brick.firstValue + i];
      if (value >= 0.0)
      {
        mass.value += value * width * width * width;
        mass.size += width * width * width;
      }
    }
  }
  return mass;
}
}

TEST(Coarsening, KeepsTheSumOverTheVolume)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::ratio4(),
         reference::mixedRatios(), reference::anisotropic(), reference::partlyCovered() })
  {
    SCOPED_TRACE(scene.name);
    const Subject subject(scene);
    const auto coarser = coarsen(subject.volume());
    const std::vector<std::int64_t>& width = scene.hierarchy.cellWidth;
    ASSERT_TRUE(coarser);
    EXPECT_EQ(coarser->cellWidth.size(), width.size() - 1);
    EXPECT_EQ(coarser->cellWidth.back(), 1);
    const Mass before = massOf(subject.volume(), 1.0);
    const Mass after = massOf(coarser->volume(), static_cast<double>(width[width.size() - 2]));
    EXPECT_DOUBLE_EQ(after.size, before.size);
    EXPECT_NEAR(after.value, before.value, 1e-6 * before.value);
    EXPECT_LT(coarser->scalars.values.size(), subject.scalars.values.size());
    // The same space in other half cells.
    const glm::dvec3 corner(coarser->fromHalfCells * glm::dvec4(subject.structure.tree.size, 1.0));
    EXPECT_EQ(corner, glm::dvec3(coarser->tree.size));
  }
}

TEST(Coarsening, OfAnyHierarchyStaysInItsValues)
{
  // Absent cells, partly covered ones, blocks that end inside coarse cells.
  int coarsened = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const Subject subject(reference::randomScene(seed));
    const auto coarser = coarsen(subject.volume());
    if (!coarser)
    {
      EXPECT_EQ(subject.structure.hierarchy.levels(), 1);
      continue;
    }
    ++coarsened;
    std::uint64_t absent = 0;
    for (const float value : coarser->scalars.values)
    {
      ASSERT_TRUE(value == layout::ABSENT || (value >= 0.0f && value <= 1.0f)) << value;
      absent += value == layout::ABSENT;
    }
    EXPECT_EQ(coarser->scalars.absentCells, absent);
    EXPECT_EQ(coarser->scalars.range.min, subject.scalars.range.min);
  }
  EXPECT_GT(coarsened, 20);
}

TEST(Coarsening, OfCompletedLevelsCompletesThemToo)
{
  const Subject subject(reference::twoLevels());
  const std::vector<std::int64_t>& width = subject.structure.hierarchy.cellWidth;
  const Completion completion =
    complete(subject.structure.tree, subject.structure.bricks, width, subject.scalars);
  Volume volume = subject.volume();
  volume.bricks = &completion.bricks;
  volume.scalars = &completion.scalars;
  const auto coarser = coarsen(volume);
  ASSERT_TRUE(coarser);
  EXPECT_EQ(coarser->scalars.layer, 1);
  // Its bricks' own cells are those of the volume that is not completed.
  const auto plain = coarsen(subject.volume());
  ASSERT_EQ(coarser->bricks.size(), plain->bricks.size());
  const Brick& a = coarser->bricks.front();
  const Brick& b = plain->bricks.front();
  const int nx = a.cells.x + 2;
  const int ny = a.cells.y + 2;
  EXPECT_EQ(
    coarser->scalars.values[a.firstValue + 1 + nx * (1 + ny)], plain->scalars.values[b.firstValue]);
}

TEST(Coarsening, StopsAtOneLevel)
{
  const Subject subject(reference::uniform());
  EXPECT_FALSE(coarsen(subject.volume()));
}
