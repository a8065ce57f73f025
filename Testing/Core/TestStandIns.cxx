// SPDX-License-Identifier: BSD-3-Clause
// The stand-ins for the paper's models have the structure that they stand for, at every size.
#include "Core/ActiveRegions.h"
#include "Core/Volume.h"
#include "Scenes/MergeCells.h"
#include "Scenes/StandIn.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <set>

using namespace exabricks;

namespace
{
std::string nameOf(const ::testing::TestParamInfo<StandInKind>& info)
{
  std::string name = describe(info.param).name;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

// The sum of the leaf cells of each level, as shares of all.
std::vector<double> sharesOf(const std::vector<Brick>& bricks, int levels)
{
  std::vector<double> fraction(levels, 0.0);
  double all = 0.0;
  for (const Brick& brick : bricks)
  {
    fraction[brick.level] += static_cast<double>(brick.numberOfCells());
    all += static_cast<double>(brick.numberOfCells());
  }
  for (double& s : fraction)
  {
    s /= all;
  }
  return fraction;
}

// A sum that depends on every value and its place.
double checksum(const StandIn& made)
{
  double sum = 0.0;
  std::vector<double> values;
  for (std::size_t b = 0; b < made.hierarchy.blocks.size(); b += 7)
  {
    const Box& cells = made.hierarchy.blocks[b].cells;
    values.resize(static_cast<std::size_t>(cells.volume()));
    made.cells->read(static_cast<int>(b), cells, values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sum += values[i] * static_cast<double>(1 + (i + b) % 97);
    }
  }
  return sum;
}

class StandIns : public ::testing::TestWithParam<StandInKind>
{
};
INSTANTIATE_TEST_SUITE_P(All, StandIns,
  ::testing::Values(StandInKind::Cloud, StandInKind::Impact5K, StandInKind::Impact20K,
    StandInKind::Impact46K, StandInKind::Wind, StandInKind::Gear, StandInKind::ExajetRear,
    StandInKind::ExajetWing),
  nameOf);
}

TEST_P(StandIns, HaveTheStructureTheyStandForAtEverySize)
{
  const StandInDescription& description = describe(GetParam());
  for (const std::uint64_t asked : { std::uint64_t(200000), std::uint64_t(3000000) })
  {
    const std::uint64_t cells = std::max(asked, description.leastLeafCells);
    const StandIn made = makeStandIn(GetParam(), asked);
    EXPECT_EQ(findFault(made.hierarchy), "");
    // As buildStructure() does, without the regions, which take longest.
    const LeafBoxes leaves = findLeafBoxes(made.hierarchy);
    const std::vector<Brick> bricks = buildBricks(leaves, made.hierarchy.cellWidth);
    EXPECT_EQ(leaves.partlyCoveredBoxes, 0u);
    EXPECT_NEAR(static_cast<double>(leaves.cells) / static_cast<double>(cells), 1.0, 0.2);
    const double cellsPerBrick =
      static_cast<double>(leaves.cells) / static_cast<double>(bricks.size());
    EXPECT_NEAR(cellsPerBrick / description.cellsPerBrick, 1.0, 0.25) << asked << " leaf cells";

    const int levels = static_cast<int>(description.fractions.size());
    ASSERT_EQ(made.hierarchy.levels(), levels);
    const std::vector<double> fraction = sharesOf(bricks, levels);
    for (int level = 0; level < levels; ++level)
    {
      EXPECT_NEAR(fraction[level], description.fractions[level], 0.07)
        << "level " << level << " of " << asked << " leaf cells";
    }
  }
}

TEST_P(StandIns, CoverWholeCoarserCellsOnce)
{
  const StandIn made = makeStandIn(GetParam(), 100000);
  const Hierarchy& hierarchy = made.hierarchy;
  std::vector<LatticeVolume> inLevel(hierarchy.levels());
  for (std::size_t b = 0; b < hierarchy.blocks.size(); ++b)
  {
    const Block& block = hierarchy.blocks[b];
    inLevel[block.level] += hierarchy.logicalBox(block).volume();
    LatticeVolume below;
    for (std::size_t other = 0; other < hierarchy.blocks.size(); ++other)
    {
      const Block& candidate = hierarchy.blocks[other];
      if (candidate.level == block.level && other != b)
      {
        ASSERT_FALSE(candidate.cells.intersects(block.cells));
      }
      if (candidate.level == block.level - 1)
      {
        below +=
          intersection(hierarchy.logicalBox(candidate), hierarchy.logicalBox(block)).volume();
      }
    }
    if (block.level > 0)
    {
      ASSERT_TRUE(alignedTo(block.cells, 2)) << "not whole coarse cells";
      ASSERT_TRUE(below == hierarchy.logicalBox(block).volume()) << "not inside the coarser level";
    }
  }
  for (int level = 1; level < hierarchy.levels(); ++level)
  {
    EXPECT_LT(inLevel[level], inLevel[level - 1]);
  }
}

TEST_P(StandIns, HaveValuesInTheirRangeAndEmptySpace)
{
  const StandIn made = makeStandIn(GetParam(), 200000);
  const auto structure = std::make_shared<const Structure>(buildStructure(made.hierarchy));
  const Volume subject{ structure, makeValues(*structure, *made.cells) };
  const Values& values = *subject.values;
  EXPECT_EQ(values.absentCells, 0u);
  EXPECT_GE(values.range.min, made.range.min);
  EXPECT_LE(values.range.max, made.range.max);
  EXPECT_GT(values.range.max - values.range.min, 0.6 * (made.range.max - made.range.min));

  const auto volume = [](const glm::ivec3& lo, const glm::ivec3& hi)
  {
    const glm::dvec3 size(hi - lo);
    return size.x * size.y * size.z;
  };
  double fraction = 0.0;
  for (const layout::ActiveBox& box :
    selectActiveRegions(subject, made.transferFor(values.range)).boxes)
  {
    fraction += volume(box.lo, box.hi) / volume(glm::ivec3(0), structure->tree.size);
  }
  EXPECT_GT(fraction, 0.1) << "the transfer function shows too little";
  EXPECT_LT(fraction, 0.97) << "the transfer function skips too little";

  // Most of what is not empty is nearly transparent, some is dense.
  double visible = 0.0;
  double dense = 0.0;
  const TransferFunction transfer = made.transferFor(values.range);
  for (const float value : values.normalized)
  {
    const double opacity = transfer.evaluate(value).a;
    visible += opacity > 0.0;
    dense += opacity > 0.3;
  }
  EXPECT_GT(visible, 0.05 * static_cast<double>(values.normalized.size()));
  EXPECT_LT(visible, 0.8 * static_cast<double>(values.normalized.size()));
  EXPECT_GT(dense, 0.001 * static_cast<double>(values.normalized.size()));
  EXPECT_LT(dense, 0.5 * visible);
}

TEST_P(StandIns, AreTheSameEachTime)
{
  const StandIn once = makeStandIn(GetParam(), 60000);
  const StandIn again = makeStandIn(GetParam(), 60000);
  EXPECT_TRUE(once.hierarchy.sameStructure(again.hierarchy));
  EXPECT_EQ(checksum(once), checksum(again));
  EXPECT_GT(checksum(once), 0.0);
}

TEST_P(StandIns, HaveValuesThatChangeLittleFromCellToCell)
{
  const StandIn made = makeStandIn(GetParam(), 200000);
  double change = 0.0;
  double cells = 0.0;
  std::vector<double> values;
  for (std::size_t b = 0; b < made.hierarchy.blocks.size(); ++b)
  {
    const Box& box = made.hierarchy.blocks[b].cells;
    values.resize(static_cast<std::size_t>(box.volume()));
    made.cells->read(static_cast<int>(b), box, values.data());
    for (std::size_t i = 1; i < values.size(); ++i)
    {
      if (i % static_cast<std::size_t>(box.size().x) != 0)
      {
        change += std::abs(values[i] - values[i - 1]);
        cells += 1.0;
      }
    }
  }
  EXPECT_GT(change / cells, 0.001) << "no structure on the scale of cells";
  EXPECT_LT(change / cells, 0.12) << "noise from cell to cell";
}

TEST_P(StandIns, HaveACameraThatLooksAtThem)
{
  const StandIn made = makeStandIn(GetParam(), 60000);
  Box box;
  for (const Block& block : made.hierarchy.blocks)
  {
    box = unite(box, made.hierarchy.logicalBox(block));
  }
  const glm::dvec3 lo = made.hierarchy.origin + made.hierarchy.spacing * glm::dvec3(box.lo);
  const glm::dvec3 hi = made.hierarchy.origin + made.hierarchy.spacing * glm::dvec3(box.hi);
  const glm::dvec3 focus = made.camera.focalPoint;
  EXPECT_TRUE(glm::all(glm::lessThan(lo, focus)) && glm::all(glm::lessThan(focus, hi)));
  EXPECT_GT(glm::distance(made.camera.position, focus), 0.2 * glm::distance(lo, hi));
  EXPECT_GT(made.opacityUnitDistance, 0.0);
  EXPECT_LT(made.opacityUnitDistance, glm::distance(lo, hi));

  EXPECT_EQ(made.mesh.triangles.empty(), !describe(GetParam()).hasMesh);
  for (const glm::dvec3& p : made.mesh.points)
  {
    ASSERT_TRUE(glm::all(glm::lessThan(lo - 0.1 * (hi - lo), p)) &&
      glm::all(glm::lessThan(p, hi + 0.1 * (hi - lo))));
  }
  // Closed: each edge is shared by two triangles, that run along it in opposite directions.
  std::set<std::pair<int, int>> edges;
  for (const glm::ivec3& t : made.mesh.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(edges.insert({ t[i], t[(i + 1) % 3] }).second);
    }
  }
  for (const auto& edge : edges)
  {
    ASSERT_EQ(edges.count({ edge.second, edge.first }), 1u);
  }
}

TEST(StandInLattice, OfExajetLiesFarFromZero)
{
  const StandIn rear = makeStandIn(StandInKind::ExajetRear, 100000);
  const StandIn wing = makeStandIn(StandInKind::ExajetWing, 100000);
  EXPECT_TRUE(rear.hierarchy.sameStructure(wing.hierarchy)) << "two views of one data set";
  EXPECT_EQ(checksum(rear), checksum(wing));
  EXPECT_NE(rear.camera.position, wing.camera.position);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(rear.hierarchy.spacing[axis], 8.0);
    EXPECT_NEAR(rear.hierarchy.origin[axis], 1.2e6, 2e4);
    EXPECT_EQ(std::fmod(rear.hierarchy.origin[axis], 64.0), 0.0);
  }
  EXPECT_EQ(rear.hierarchy.cellWidth.front() * 8, 64);
}

TEST(StandInSize, IsTheLeastWhereLessIsAsked)
{
  const std::uint64_t least = describe(StandInKind::Gear).leastLeafCells;
  EXPECT_TRUE(makeStandIn(StandInKind::Gear, 1)
                .hierarchy.sameStructure(makeStandIn(StandInKind::Gear, least).hierarchy));
}

TEST(MergeCells, KeepsAllMarkedCellsAndNoOthers)
{
  const Box box{ Int3(-3, 5, 2), Int3(8, 12, 9) };
  std::vector<unsigned char> marks(static_cast<std::size_t>(box.volume()));
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    marks[i] = (i * i / 7 + i / 3) % 4 != 0;
  }
  const std::vector<unsigned char> wanted = marks;
  std::vector<int> found(marks.size(), 0);
  const std::vector<Box> merged = mergeCells(box, marks, 4);
  for (const Box& part : merged)
  {
    EXPECT_TRUE(box.contains(part));
    EXPECT_LE(std::max({ part.size().x, part.size().y, part.size().z }), 4);
    Int3 p;
    for (p.z = part.lo.z; p.z < part.hi.z; ++p.z)
    {
      for (p.y = part.lo.y; p.y < part.hi.y; ++p.y)
      {
        for (p.x = part.lo.x; p.x < part.hi.x; ++p.x)
        {
          const Int3 at = p - box.lo;
          ++found[at.x + box.size().x * (at.y + box.size().y * at.z)];
        }
      }
    }
  }
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    EXPECT_EQ(found[i], wanted[i]);
  }
  EXPECT_LT(merged.size() * 2, marks.size());
}
