// SPDX-License-Identifier: BSD-3-Clause
// Very small and very large pictures and data.
#include "MakeAMR.h"

#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

namespace exabricks
{
namespace stability
{
namespace
{
// Every second cell along each axis, each a block: a million bricks of one cell. Cells without
// neighbours keep their value, so that one block with all others absent is the same picture.
Setting millionBlocks()
{
  constexpr std::int64_t n = 100;
  const auto value = [](int level, const Int3& cell) { return reference::noise(level, cell, 11); };
  Setting setting;
  setting.hierarchy.cellWidth = { 1 };
  Int3 i;
  for (i.z = 0; i.z < n; ++i.z)
  {
    for (i.y = 0; i.y < n; ++i.y)
    {
      for (i.x = 0; i.x < n; ++i.x)
      {
        const Int3 lo = i * std::int64_t(2);
        setting.hierarchy.blocks.push_back({ 0, { lo, lo + std::int64_t(1) } });
      }
    }
  }
  setting.cells = std::make_shared<FieldSource>(setting.hierarchy, value);
  setting.transfer = layers();
  setting.unitDistance = 4.0;
  setting.leastBricks = n * n * n;
  look(setting, { -0.6, 0.5, -0.4 }, 30.0);
  setting.truth = [=, unit = setting.unitDistance, nodes = setting.transfer](
                    const reference::View& view, reference::Reconstruction)
  {
    const Hierarchy one = oneBlock(Int3(2 * n - 1));
    const FieldSource cells(one,
      [value](int level, const Int3& cell)
      {
        const bool there = cell.x % 2 == 0 && cell.y % 2 == 0 && cell.z % 2 == 0;
        return there ? value(level, cell) : std::numeric_limits<double>::quiet_NaN();
      });
    const reference::Oracle oracle(one, findLeafBoxes(one), cells);
    reference::Oracle::Settings settings;
    settings.reconstruction = reference::Reconstruction::Nearest; // as basis, and cheaper
    settings.opacityUnitDistance = unit;
    return oracle.render(view, normalize(nodes, oracle.range()), settings);
  };
  return setting;
}

// Slabs of fine cells along all axes, which leave single coarse cells between them: more bricks and
// regions than 16 bits can count, of few blocks.
Setting manyBricks()
{
  constexpr std::int64_t holes = 27; // along each axis
  constexpr std::int64_t coarse = 2 * holes + 1;
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(coarse) } } };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::int64_t slab = 0; slab <= holes; ++slab)
    {
      Box cells{ Int3(0), Int3(2 * coarse) };
      cells.lo[axis] = 4 * slab;
      cells.hi[axis] = 4 * slab + 2;
      hierarchy.blocks.push_back({ 1, cells });
    }
  }
  AMROptions options;
  const vtkNew<vtkUnsignedCharArray> bytes;
  options.like = bytes;
  Setting setting = fieldSetting(
    hierarchy,
    [](int level, const Int3& cell)
    { return level == 0 ? 200.0 : std::floor(100.0 * reference::noise(level, cell, 12)); },
    30.0, options);
  setting.transfer = layers(0.0, 255.0);
  setting.unitDistance = 8.0;
  setting.width = setting.height = 32;
  setting.leastBricks = 1 << 16;
  setting.leastRegions = 1 << 16;
  return setting;
}

// More than 128 MiB of float32, the storage buffer that every device has and few exceed by much.
Setting manyCells()
{
  constexpr std::int64_t n = 328;
  AMROptions options;
  const vtkNew<vtkUnsignedCharArray> bytes;
  options.like = bytes;
  Setting setting = fieldSetting(
    oneBlock(Int3(n)),
    [](int, const Int3& cell)
    {
      // A ripple that tells every part of the block from the others.
      const std::int64_t sum = 3 * cell.x + 2 * cell.y + cell.z;
      return static_cast<double>((sum + cell.x * cell.z / 64) % 256);
    },
    30.0, options);
  setting.transfer = layers(0.0, 255.0);
  setting.unitDistance = 16.0;
  setting.width = setting.height = 24;
  return setting;
}

Setting manyBuffers()
{
  Setting setting = shellSetting(twoLevels());
  setting.largestValueBuffer = 4096;
  return setting;
}

Setting onePixel()
{
  Setting setting = shellSetting(twoLevels());
  setting.width = setting.height = 1;
  return setting;
}

Setting widePicture()
{
  Setting setting = shellSetting(twoLevels(), 0.0);
  setting.width = 4097;
  setting.height = 3;
  setting.camera.parallelScale = 0.5 * 48.0 * setting.height / setting.width;
  return setting;
}
}

std::vector<Case> sizeCases()
{
  constexpr char asSmall[] = "as a picture of any other size";
  return {
    { "OnePixel", "1 / (width - 1)", onePixel, 60.0, 100.0, asSmall },
    { "4097Pixels", "textures and tables of 4096", widePicture, 60.0, 100.0, asSmall },
    { "ManyValueBuffers", "addresses of the wrong buffer", manyBuffers, 60.0, 100.0,
      "as with one buffer" },
    { "ThirtyFiveMillionCells", "one buffer or texture holds no more than 128 MiB", manyCells, 50.0,
      90.0, "a ripple with a kink in every cell; rays of 500 cells each add float32's rounding" },
    { "MoreThan16Bits", "bricks and regions counted in 16 bits; blocks sorted in every frame",
      manyBricks, 50.0, 90.0, "noise has a kink in every cell; rays of 300 fine cells" },
    { "AMillionOneCellBricks", "a texture, a draw call or a tree node for each of them",
      millionBlocks, 90.0, 90.0, "each cell has one value, where any step is exact" },
  };
}

std::vector<Theme> allThemes()
{
  return { { "Levels", levelCases() }, { "Cells", cellCases() }, { "Geometry", geometryCases() },
    { "Rays", rayCases() }, { "Transfer", transferCases() }, { "Values", valueCases() },
    { "Sizes", sizeCases() } };
}
}
}
