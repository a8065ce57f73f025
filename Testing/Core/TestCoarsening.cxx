// SPDX-License-Identifier: BSD-3-Clause
// A volume without its finest level holds the means of what it had.
#include "Core/Coarsening.h"
#include "Core/Completion.h"
#include "Reference/Scenes.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
Volume makeVolume(const reference::Scene& scene)
{
  auto structure = std::make_shared<const Structure>(buildStructure(scene.hierarchy));
  return { structure, makeValues(*structure, scene.cells) };
}

// The volume without its finest level; none if it has no other.
struct Coarser
{
  Volume volume;
  glm::dmat4 fromHalfCells{ 1.0 };

  explicit Coarser(const Volume& finer)
  {
    if (const auto coarser = coarsen(*finer.structure))
    {
      this->volume = { coarser->structure, coarsen(finer, *coarser->structure) };
      this->fromHalfCells = coarser->fromHalfCells;
    }
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
  for (std::size_t b = 0; b < volume.structure->bricks.size(); ++b)
  {
    const Brick& brick = volume.structure->bricks[b];
    const double width = unit * static_cast<double>(volume.structure->width(brick));
    for (std::uint64_t i = 0; i < brick.numberOfCells(); ++i)
    {
      const double value = volume.values->ofBrick(b)[i];
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
    const Volume volume = makeVolume(scene);
    const Coarser coarser(volume);
    const std::vector<std::int64_t>& width = scene.hierarchy.cellWidth;
    ASSERT_TRUE(coarser.volume);
    EXPECT_EQ(coarser.volume.structure->hierarchy.cellWidth.size(), width.size() - 1);
    EXPECT_EQ(coarser.volume.structure->hierarchy.cellWidth.back(), 1);
    const Mass before = massOf(volume, 1.0);
    const Mass after = massOf(coarser.volume, static_cast<double>(width[width.size() - 2]));
    EXPECT_DOUBLE_EQ(after.size, before.size);
    EXPECT_NEAR(after.value, before.value, 1e-6 * before.value);
    EXPECT_LT(coarser.volume.values->normalized.size(), volume.values->normalized.size());
    // The same space in other half cells.
    const glm::dvec3 corner(coarser.fromHalfCells * glm::dvec4(volume.structure->tree.size, 1.0));
    EXPECT_EQ(corner, glm::dvec3(coarser.volume.structure->tree.size));
  }
}

TEST(Coarsening, OfAnyHierarchyStaysInItsValues)
{
  // Absent cells, partly covered ones, blocks that end inside coarse cells.
  int coarsened = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const Volume volume = makeVolume(reference::randomScene(seed));
    const Coarser coarser(volume);
    if (!coarser.volume)
    {
      EXPECT_EQ(volume.structure->hierarchy.levels(), 1);
      continue;
    }
    ++coarsened;
    std::uint64_t absent = 0;
    for (const float value : coarser.volume.values->normalized)
    {
      ASSERT_TRUE(value == layout::ABSENT || (value >= 0.0f && value <= 1.0f)) << value;
      absent += value == layout::ABSENT;
    }
    EXPECT_EQ(coarser.volume.values->absentCells, absent);
    EXPECT_EQ(coarser.volume.values->range.min, volume.values->range.min);
  }
  EXPECT_GT(coarsened, 20);
}

TEST(Coarsening, OfCompletedLevelsCompletesThemToo)
{
  const Volume volume = makeVolume(reference::twoLevels());
  const Coarser plain(volume);
  const Coarser completed({ volume.structure, complete(*volume.structure, *volume.values) });
  ASSERT_TRUE(completed.volume);
  EXPECT_EQ(completed.volume.values->layer, 1);
  // Its bricks' own cells are those of the volume that is not completed.
  ASSERT_EQ(completed.volume.structure->bricks.size(), plain.volume.structure->bricks.size());
  const glm::ivec3 stored = plain.volume.structure->bricks.front().cells + 2;
  EXPECT_EQ(completed.volume.values->ofBrick(0)[1 + stored.x * (1 + stored.y)],
    plain.volume.values->ofBrick(0)[0]);
}

TEST(Coarsening, OfAnotherTimeStepKeepsTheStructure)
{
  reference::Scene scene = reference::twoLevels();
  const Volume first = makeVolume(scene);
  const auto coarser = coarsen(*first.structure);
  ASSERT_TRUE(coarser);
  scene.cells = reference::fillCells(scene.hierarchy, [](int, const Int3& c) { return c.x + 1.0; });
  const Volume second{ first.structure, makeValues(*first.structure, scene.cells) };
  const auto kept = coarsen(second, *coarser->structure);
  const Coarser anew(makeVolume(scene));
  EXPECT_EQ(kept->normalized, anew.volume.values->normalized);
  EXPECT_EQ(kept->ranges.regions.size(), coarser->structure->tree.regions.size());
}

TEST(Coarsening, StopsAtOneLevel)
{
  EXPECT_FALSE(coarsen(*makeVolume(reference::uniform()).structure));
}
