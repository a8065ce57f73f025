// SPDX-License-Identifier: BSD-3-Clause
// Small AMR made by code, the same way for every version of VTK.
#ifndef ExaBricksTestingAMR_h
#define ExaBricksTestingAMR_h

#include "Adapters/AMRCompatibility.h"

#include "vtkAMRBox.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkSmartPointer.h"
#include "vtkUniformGrid.h"

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace test
{
/// A box of cells of a level: its lowest cell, and how many there are along x, y and z.
struct Block
{
  unsigned int level;
  std::array<int, 3> first;
  std::array<int, 3> cells;
};

/// Where the lattice lies.
struct Lattice
{
  std::array<double, 3> origin{ 0.0, 0.0, 0.0 };
  std::array<double, 3> spacing{ 1.0, 1.0, 1.0 }; // of level 0
  int ratio = 2;                                  // of all levels, ...
  std::vector<int> ratios{};                      // ... or of each but level 0 to the one below

  std::array<double, 3> SpacingOf(unsigned int level) const
  {
    double scale = 1.0;
    for (unsigned int l = 0; l < level; ++l)
    {
      scale /= this->ratios.empty() ? this->ratio : this->ratios[l];
    }
    return { this->spacing[0] * scale, this->spacing[1] * scale, this->spacing[2] * scale };
  }
};

/// The value of a cell, from the position of its centre in the world.
using Field = std::function<double(double x, double y, double z)>;
inline Field constant(double value)
{
  return [value](double, double, double) { return value; };
}

/// Boxes and spacings, but null for every block. `blocks` of each level in the order of their
/// index. `description`: of the grids, as VTK numbers it; 3-D if negative.
inline vtkSmartPointer<vtkOverlappingAMR> makeNullBlocks(
  const std::vector<Block>& blocks, const Lattice& lattice = {}, int description = -1)
{
  std::vector<int> blocksPerLevel;
  for (const Block& block : blocks)
  {
    blocksPerLevel.resize(std::max<std::size_t>(blocksPerLevel.size(), block.level + 1));
    ++blocksPerLevel[block.level];
  }
  auto amr = vtkSmartPointer<vtkOverlappingAMR>::New();
  exabricks::initialize(amr, blocksPerLevel, description);
  amr->SetOrigin(lattice.origin.data());
  std::vector<unsigned int> next(blocksPerLevel.size(), 0);
  for (unsigned int level = 0; level < blocksPerLevel.size(); ++level)
  {
    amr->SetSpacing(level, lattice.SpacingOf(level).data());
  }
  for (const Block& block : blocks)
  {
    std::array<int, 3> last;
    for (int axis = 0; axis < 3; ++axis)
    {
      last[axis] = block.first[axis] + (block.cells[axis] - 1);
    }
    const vtkAMRBox box(block.first.data(), last.data());
    amr->SetAMRBox(block.level, next[block.level]++, box);
  }
  return amr;
}

/// The grid of a block, without arrays; larger than the block by `ghosts` layers of cells.
inline vtkSmartPointer<vtkUniformGrid> makeGrid(
  const Block& block, const Lattice& lattice = {}, int ghosts = 0)
{
  const std::array<double, 3> spacing = lattice.SpacingOf(block.level);
  std::array<double, 3> corner;
  std::array<int, 3> points;
  for (int axis = 0; axis < 3; ++axis)
  {
    corner[axis] = lattice.origin[axis] + (block.first[axis] - ghosts) * spacing[axis];
    points[axis] = block.cells[axis] + 2 * ghosts + 1;
  }
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->SetOrigin(corner.data());
  grid->SetSpacing(spacing.data());
  grid->SetDimensions(points.data());
  return grid;
}

/// Gives the grid a cell array of `field`, as its active scalars.
inline vtkDoubleArray* addCells(
  vtkUniformGrid* grid, const Field& field, const char* name = "value")
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  values->SetNumberOfTuples(grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    values->SetValue(cell,
      field(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
        0.5 * (bounds[4] + bounds[5])));
  }
  grid->GetCellData()->SetScalars(values);
  return values;
}

/// The same of several components.
inline vtkDoubleArray* addCells(
  vtkUniformGrid* grid, const std::vector<Field>& fields, const char* name = "value")
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  values->SetNumberOfComponents(static_cast<int>(fields.size()));
  values->SetNumberOfTuples(grid->GetNumberOfCells());
  for (std::size_t k = 0; k < fields.size(); ++k)
  {
    values->CopyComponent(static_cast<int>(k), addCells(grid, fields[k]), 0);
  }
  grid->GetCellData()->SetScalars(values);
  return values;
}

/// Calls `visit(block, grid)` for every block that is there.
inline void forEachGrid(vtkOverlappingAMR* amr,
  const std::function<void(unsigned int level, vtkUniformGrid* grid)>& visit)
{
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int index = 0; index < exabricks::numberOfBlocks(amr, level); ++index)
    {
      vtkDataSet* block = exabricks::getBlock(amr, level, index);
      if (auto* grid = vtkUniformGrid::SafeDownCast(block))
      {
        visit(level, grid);
      }
    }
  }
}

/// The same boxes with those of the blocks alone for which keep(level, index among all blocks) says
/// so. (A block that is there cannot be taken away: VTK ignores null.)
inline vtkSmartPointer<vtkOverlappingAMR> keepBlocks(
  vtkOverlappingAMR* amr, const std::function<bool(unsigned int, unsigned int)>& keep)
{
  auto kept = vtkSmartPointer<vtkOverlappingAMR>::New();
  std::vector<int> count;
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    count.push_back(static_cast<int>(exabricks::numberOfBlocks(amr, level)));
  }
  exabricks::initialize(kept, count, amr->GetGridDescription());
  kept->SetOrigin(amr->GetOrigin());
  unsigned int number = 0;
  for (unsigned int level = 0; level < count.size(); ++level)
  {
    double spacing[3];
    amr->GetSpacing(level, spacing);
    kept->SetSpacing(level, spacing);
    for (unsigned int i = 0; i < exabricks::numberOfBlocks(amr, level); ++i, ++number)
    {
      kept->SetAMRBox(level, i, amr->GetAMRBox(level, i));
      auto* grid = vtkUniformGrid::SafeDownCast(exabricks::getBlock(amr, level, i));
      if (grid && keep(level, number))
      {
        kept->SetDataSet(level, i, grid);
      }
    }
  }
  return kept;
}

/// All blocks there, with a cell array "value".
inline vtkSmartPointer<vtkOverlappingAMR> makeAMR(
  const std::vector<Block>& blocks, const Field& field, const Lattice& lattice = {})
{
  auto amr = makeNullBlocks(blocks, lattice);
  std::vector<unsigned int> next(amr->GetNumberOfLevels(), 0);
  for (const Block& block : blocks)
  {
    auto grid = makeGrid(block, lattice);
    addCells(grid, field);
    amr->SetDataSet(block.level, next[block.level]++, grid);
  }
  return amr;
}

/// A cube from 0 to 8 of cells of width 1, refined in one eighth of it.
inline std::vector<Block> cornerRefined()
{
  return { { 0, { 0, 0, 0 }, { 8, 8, 8 } }, { 1, { 0, 0, 0 }, { 8, 8, 8 } } };
}
}

#endif
