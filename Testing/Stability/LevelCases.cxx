// SPDX-License-Identifier: BSD-3-Clause
// Where cells of different levels meet.
#include "MakeAMR.h"

namespace exabricks
{
namespace stability
{
namespace
{
constexpr char secondOrder[] =
  "basis: steps of a quarter of a cell on a field with kinks at the cells' "
  "centres, as MatchesOracle; nearest: exact for every cell, float32 alone errs";

Hierarchy skippingLevels()
{
  // Level 2 lies in level 0 on some sides, without level 1 around it.
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 4, 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(8) } }, { 1, { Int3(4, 4, 4), Int3(12, 10, 12) } },
    { 2, { Int3(4, 8, 8), Int3(24, 20, 16) } }, { 2, { Int3(12, 20, 12), Int3(20, 28, 24) } } };
  return hierarchy;
}

Hierarchy sixteenLevels()
{
  Hierarchy hierarchy;
  for (int level = 0; level < 16; ++level)
  {
    hierarchy.cellWidth.push_back(std::int64_t(1) << (15 - level));
    hierarchy.blocks.push_back({ level, { Int3(0), Int3(4) } });
  }
  return hierarchy;
}

Setting sixteen()
{
  // From outside, where the coarsest levels are most of the picture.
  const Hierarchy hierarchy = sixteenLevels();
  Setting setting = fieldSetting(
    hierarchy, [](int level, const Int3& cell) { return reference::noise(level, cell, 7); });
  setting.unitDistance = 4096.0;
  setting.width = setting.height = 32;
  return setting;
}

// The same, with the camera in a corner of the finest level: sixteen levels lie behind one another.
Setting sixteenFromWithin()
{
  Setting setting = sixteen();
  setting.transfer = layers(0.0, 3.0); // thin
  setting.unitDistance = 64.0;
  setting.camera.position = glm::dvec3(0.7, 0.6, 0.5);
  setting.camera.focalPoint = glm::dvec3(100.0, 101.0, 99.0);
  setting.camera.viewUp = glm::dvec3(0.0, 0.0, 1.0);
  setting.camera.viewAngle = 60.0;
  setting.camera.nearest = 0.1;
  setting.camera.farthest = 4e5;
  return setting;
}

// The levels' tents have to add up to one: a constant must stay one. Another value, which the range
// needs, lies in a block out of sight.
Setting constantAcrossLevels()
{
  Hierarchy hierarchy = reference::mixedRatios().hierarchy;
  const Box seen = reference::boundsOf(hierarchy);
  hierarchy.blocks.insert(hierarchy.blocks.begin(), { 0, { Int3(-40), Int3(-39) } });
  Setting setting =
    fieldSetting(hierarchy, [](int, const Int3& cell) { return cell.x < 0 ? 0.0 : 1.0; });
  setting.transfer = { { 0.0, { 0.2, 0.4, 0.9, 0.0 } }, { 0.9, { 0.2, 0.4, 0.9, 0.0 } },
    { 1.0, { 0.9, 0.7, 0.2, 0.05 } } };
  setting.camera = reference::frame(hierarchy, seen, { -0.6, 0.5, -0.4 }, 30.0, 1.0);
  return setting;
}
}

std::vector<Case> levelCases()
{
  const auto shellOfRatios = [](const std::vector<int>& ratios, int coarse, int block)
  { return [=] { return shellSetting(reference::refinedAtShell(ratios, coarse, block)); }; };
  return {
    { "Ratio2", "seams at level boundaries, refined patches drawn twice",
      shellOfRatios({ 2 }, 16, 4), 60.0, 100.0, secondOrder },
    { "Ratio3", "ratios other than powers of two are refused or shifted by half a cell",
      shellOfRatios({ 3 }, 8, 4), 60.0, 100.0, secondOrder },
    { "Ratio4", "more than one hanging node to an edge: cracks in dual grids",
      shellOfRatios({ 4 }, 8, 4), 60.0, 100.0, secondOrder },
    { "MixedRatios", "one ratio is taken for all levels", shellOfRatios({ 3, 2 }, 12, 6), 60.0,
      100.0, secondOrder },
    { "RatiosOf4And3", "one ratio is taken for all levels", shellOfRatios({ 4, 3 }, 4, 2), 60.0,
      100.0, secondOrder },
    { "LevelsSkipped", "neighbours differ by more than one level: cracks, wrong neighbours",
      [] { return shellSetting(skippingLevels()); }, 60.0, 100.0, secondOrder },
    { "ChildrenNotAligned", "coarse cells covered in part: holes, or drawn twice",
      [] { return shellSetting(reference::partlyCovered().hierarchy); }, 60.0, 100.0, secondOrder },
    { "ConstantAcrossLevels", "weights that do not add up to one show every boundary",
      constantAcrossLevels, 90.0, 100.0, "the field is constant, where any step is exact" },
    { "SixteenLevels", "texture units, resampled grids and float coordinates run out", sixteen,
      45.0, 90.0,
      "noise has a kink in every cell of every level, met at second order: 10 dB for half the "
      "step, "
      "up to 80; float32 positions on cells 2^15 wide" },
    { "SixteenLevelsFromWithin", "the step of one level is used for all of them", sixteenFromWithin,
      50.0, 90.0, "as above, along rays from the smallest cells to the largest" },
  };
}
}
}
