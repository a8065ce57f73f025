// SPDX-License-Identifier: BSD-3-Clause
// Cells and blocks that are absent, hidden, held twice, or alone.
#include "MakeAMR.h"

#include "Cxx/AMR.h"

#include "vtkDataSetAttributes.h"

namespace exabricks
{
namespace stability
{
namespace
{
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr char secondOrder[] =
  "as without them: they are transparent and touch no neighbour; steps of a quarter of a cell";

// The shell with some cells of this value.
Setting withCellsOf(double value)
{
  const Hierarchy hierarchy = twoLevels();
  const reference::CellField shell = shellField(hierarchy);
  return fieldSetting(hierarchy,
    [=](int level, const Int3& cell)
    { return reference::noise(level, cell, 3) < 0.05 ? value : shell(level, cell); });
}

Setting withInfiniteCells()
{
  const Hierarchy hierarchy = twoLevels();
  const reference::CellField shell = shellField(hierarchy);
  return fieldSetting(hierarchy,
    [=](int level, const Int3& cell)
    {
      const double chance = reference::noise(level, cell, 4);
      const double infinity = std::numeric_limits<double>::infinity();
      return chance < 0.03 ? infinity : chance < 0.06 ? -infinity : shell(level, cell);
    });
}

// Hidden by vtkUniformGrid, with values that are anything but harmless.
Setting withBlankedCells()
{
  const Hierarchy hierarchy = twoLevels();
  const reference::CellField shell = shellField(hierarchy);
  const auto hidden = [](int level, const Int3& cell)
  { return reference::noise(level, cell, 5) < 0.05; };
  Setting setting = fieldSetting(hierarchy,
    [=](int level, const Int3& cell) { return hidden(level, cell) ? 1e30 : shell(level, cell); });
  setting.field = [=](int level, const Int3& cell)
  { return hidden(level, cell) ? none : shell(level, cell); };
  test::forEachGrid(setting.amr,
    [](unsigned int, vtkUniformGrid* grid)
    {
      vtkDataArray* values = grid->GetCellData()->GetScalars();
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        if (values->GetTuple1(cell) > 1e20)
        {
          grid->BlankCell(cell);
        }
      }
    });
  return setting;
}

// The cells under it are marked as covered, and are there to be seen.
Setting withNullBlocks()
{
  AMROptions options;
  options.nullBlock = 2;
  const Hierarchy hierarchy = twoLevels();
  Setting setting = fieldSetting(hierarchy, shellField(hierarchy), 30.0, options);
  setting.hierarchy.blocks.erase(setting.hierarchy.blocks.begin() + options.nullBlock);
  return setting;
}

// Arrays larger than the AMR boxes, with wrong values in the layers around.
Setting withGhostLayers(bool marked)
{
  AMROptions options;
  options.ghosts = 2;
  options.ghostValue = 0.9;
  options.ghostsMarked = marked;
  const Hierarchy hierarchy = twoLevels();
  return fieldSetting(hierarchy, shellField(hierarchy), 30.0, options);
}

// Two blocks of a level hold the same cells; all but one mark them as duplicates, and are wrong.
Setting withOverlappingBlocks()
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(8, 12, 12) } }, { 0, { Int3(5, 0, 0), Int3(12) } },
    { 1, { Int3(6), Int3(16, 18, 14) } }, { 1, { Int3(10, 4, 8), Int3(20, 20, 20) } } };
  Setting setting = shellSetting(hierarchy);
  // The first of the two is right.
  const Box common[2] = { { Int3(5, 0, 0), Int3(8, 12, 12) },
    { Int3(10, 6, 8), Int3(16, 18, 14) } };
  for (unsigned int level = 0; level < 2; ++level)
  {
    auto* grid = vtkUniformGrid::SafeDownCast(getBlock(setting.amr, level, 1));
    vtkDataArray* values = grid->GetCellData()->GetScalars();
    vtkDataArray* marks = grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
    const Box& cells = hierarchy.blocks[2 * level + 1].cells;
    vtkIdType i = 0;
    Int3 c;
    for (c.z = cells.lo.z; c.z < cells.hi.z; ++c.z)
    {
      for (c.y = cells.lo.y; c.y < cells.hi.y; ++c.y)
      {
        for (c.x = cells.lo.x; c.x < cells.hi.x; ++c.x, ++i)
        {
          if (common[level].contains(c))
          {
            values->SetTuple1(i, 0.8);
            marks->SetTuple1(
              i, static_cast<int>(marks->GetTuple1(i)) | vtkDataSetAttributes::DUPLICATECELL);
          }
        }
      }
    }
  }
  return setting;
}

// Blocks of one cell on a checkerboard: tents that meet at edges and corners alone.
Setting checkerboard()
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  constexpr int n = 8;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Int3 lo(i % n, i / n % n, i / (n * n));
    if ((lo.x + lo.y + lo.z) % 2 == 0)
    {
      hierarchy.blocks.push_back({ 0, { lo, lo + std::int64_t(1) } });
    }
  }
  return fieldSetting(
    hierarchy, [](int level, const Int3& cell) { return reference::noise(level, cell, 6); });
}

// Blocks of one cell without neighbours: towards their corners their one tent falls to the weight
// 1/8, and beyond the faces there is none. Each cell keeps its value.
Setting islands()
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  constexpr int n = 6;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Int3 lo(2 * (i % n), 2 * (i / n % n), 2 * (i / (n * n)));
    hierarchy.blocks.push_back({ 0, { lo, lo + std::int64_t(1) } });
  }
  return fieldSetting(
    hierarchy, [](int level, const Int3& cell) { return reference::noise(level, cell, 8); });
}

// The same, as cells of one block whose others are absent.
Setting islandsAmongAbsentCells()
{
  return fieldSetting(oneBlock(Int3(11)),
    [](int level, const Int3& cell)
    {
      const bool there = cell.x % 2 == 0 && cell.y % 2 == 0 && cell.z % 2 == 0;
      return there ? reference::noise(level, cell, 8) : none;
    });
}

// Single fine cells that stand out of an absent coarse one: at the bounds of the data tents end,
// and those of two levels have small weights side by side.
Setting thinRemains()
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 4, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(4) } }, { 1, { Int3(4, 4, 4), Int3(5, 12, 5) } },
    { 1, { Int3(8, 7, 7), Int3(12, 8, 8) } }, { 1, { Int3(11, 11, 11), Int3(12, 12, 16) } } };
  return fieldSetting(hierarchy,
    [](int level, const Int3& cell)
    {
      return level == 0 && reference::noise(level, cell, 9) < 0.4
        ? none
        : reference::noise(level, cell, 10);
    });
}

// A dense constant that ends at the bounds: what lies outside must not be mixed in, nor cut the
// first and last intervals.
Setting bounds()
{
  Setting setting = fieldSetting(oneBlock(Int3(7, 6, 5)),
    [](int, const Int3& cell) { return cell == Int3(3, 3, 2) ? 0.0 : 1.0; });
  setting.transfer = constantNodes(0.2);
  return setting;
}
}

std::vector<Case> cellCases()
{
  return {
    { "NaNCells", "drawn black, or nothing is drawn at all", [] { return withCellsOf(none); }, 60.0,
      100.0, secondOrder },
    { "InfiniteCells", "the range becomes infinite: nothing is drawn", withInfiniteCells, 60.0,
      100.0, secondOrder },
    { "BlankedCells", "blanking is ignored, or takes the points around with it", withBlankedCells,
      60.0, 100.0, secondOrder },
    { "NullBlocks", "a crash, or the whole level is missing", withNullBlocks, 60.0, 100.0,
      secondOrder },
    { "GhostLayers", "arrays larger than the AMR box: shifted, or drawn twice",
      [] { return withGhostLayers(false); }, 60.0, 100.0,
      "as without them: cells outside the AMR box do not exist" },
    { "GhostLayersMarked", "as GhostLayers, though the cells say so",
      [] { return withGhostLayers(true); }, 60.0, 100.0,
      "as without them: cells outside the AMR box do not exist" },
    { "OverlappingBlocks", "cells that two blocks hold are drawn twice", withOverlappingBlocks,
      60.0, 100.0, "as with every cell once, with the value of the block that does not mark it" },
    { "OneCellBlocks", "interpolation needs two cells along each axis; one texture for each block",
      checkerboard, 55.0, 100.0,
      "noise has a kink in every cell, which costs second order some dB; nearest is exact" },
    { "WeightsNearZero", "0 / 0 where no tent is left: black or white dots", islands, 90.0, 100.0,
      "a lone cell's mean is its value, however small its weight" },
    { "IslandsAmongAbsentCells",
      "absent cells count with some value, or take their neighbours along", islandsAmongAbsentCells,
      60.0, 100.0, "as WeightsNearZero: the same picture" },
    { "ThinRemains", "weights of two levels near zero side by side: noise", thinRemains, 50.0,
      100.0,
      "noise has a kink in every cell, met at second order: 11 dB for half the step; the least "
      "weight in a cell that is there is 1/8 of its own" },
    { "DataBounds", "values fade to those outside; first and last steps are cut or doubled", bounds,
      90.0, 100.0, "a constant is exact whatever the step" },
  };
}
}
}
