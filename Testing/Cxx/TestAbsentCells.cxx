// SPDX-License-Identifier: BSD-3-Clause
// What of an AMR is there: hidden cells, NaN and missing blocks leave holes, ghost layers and
// duplicates do not count, and coarse cells under a missing fine block are drawn. Below a bowl, cut
// by hidden cells.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkRegressionTestImage.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
constexpr double Opacity = 0.1;
constexpr double Junk = 1e9; // the value of cells that are not to be seen

// Marks the cells for which `marked` holds.
void mark(vtkUniformGrid* grid, unsigned char kind, const test::Field& marked)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double b[6];
    grid->GetCellBounds(cell, b);
    const bool is = marked(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5])) != 0.0;
    ghosts->SetValue(cell, is ? kind : 0);
  }
  grid->GetCellData()->AddArray(ghosts);
}

double upperHalf(double, double, double z) { return z > 4.0 ? 1.0 : 0.0; }

struct Scene
{
  test::Checks& checks;
  test::Stage& stage;

  // All values seen are 1, with rays of `length` at (x, 2).
  vtkExaBricksData* Show(
    vtkOverlappingAMR* amr, double length, const std::string& what, double x = 6.0) const
  {
    this->stage.mapper->SetInputData(amr);
    const test::Picture picture(this->stage.window);
    this->checks.Near(picture.At(static_cast<int>(x * 25.0), 50)[0],
      test::opacityOf(Opacity, length), test::OneStep, what + ", opacity");
    vtkExaBricksData* data = this->stage.mapper->GetBuilder()->GetOutput();
    double range[2];
    data->GetScalarRange(range);
    this->checks.Equal(range[0], 1.0, what + ", least value");
    this->checks.Equal(range[1], 1.0, what + ", greatest value");
    return data;
  }
};
}

int TestAbsentCells(int argc, char* argv[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(200);
  test::setConstantColor(stage.Property(), Opacity);
  const Scene scene{ checks, stage };
  const auto blocks = test::cornerRefined();
  stage.mapper->SetInputData(test::makeAMR(blocks, test::constant(1.0)));
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  const vtkIdType leaves = 8 * 8 * 8 - 4 * 4 * 4 + 8 * 8 * 8;

  // Hidden cells, NaN and infinite values are transparent.
  const auto junkAbove = [](double x, double y, double z)
  { return upperHalf(x, y, z) != 0.0 ? Junk : 1.0; };
  auto hidden = test::makeAMR(blocks, junkAbove);
  test::forEachGrid(hidden,
    [](unsigned int, vtkUniformGrid* grid)
    { mark(grid, vtkDataSetAttributes::HIDDENCELL, upperHalf); });
  vtkExaBricksData* data = scene.Show(hidden, 4.0, "hidden cells");
  checks.Equal(data->GetNumberOfLeafCells(), leaves, "hidden cells are leaf cells");
  checks.Equal(data->GetNumberOfAbsentCells(), 8 * 8 * 4, "hidden cells are absent");
  for (const double value : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    auto holes = test::makeAMR(blocks,
      [value](double x, double y, double z) { return upperHalf(x, y, z) != 0.0 ? value : 1.0; });
    scene.Show(holes, 4.0, "value " + std::to_string(value));
  }

  // Cells at a hidden point are, as vtkUniformGrid::IsCellVisible() says.
  auto blanked = test::makeAMR(blocks, junkAbove);
  test::forEachGrid(blanked,
    [](unsigned int, vtkUniformGrid* grid)
    {
      for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
      {
        if (grid->GetPoint(point)[2] > 4.0)
        {
          grid->BlankPoint(point);
        }
      }
    });
  data = scene.Show(blanked, 4.0, "hidden points");
  checks.Equal(data->GetNumberOfAbsentCells(), 8 * 8 * 4, "cells at hidden points are absent");

  // Cells marked as refined (wrongly so here) are found anew from the blocks.
  auto refined = test::makeAMR(blocks, test::constant(1.0));
  test::forEachGrid(refined,
    [](unsigned int, vtkUniformGrid* grid)
    { mark(grid, vtkDataSetAttributes::REFINEDCELL, upperHalf); });
  scene.Show(refined, 8.0, "marked as refined");

  // Grids larger than their AMR boxes.
  auto ghosts = test::makeNullBlocks(blocks);
  for (const test::Block& block : blocks)
  {
    auto grid = test::makeGrid(block, {}, 2);
    const double size = block.level == 0 ? 8.0 : 4.0;
    test::addCells(grid,
      [size](double x, double y, double z)
      {
        const bool inside = std::min({ x, y, z }) > 0.0 && std::max({ x, y, z }) < size;
        return inside ? 1.0 : Junk;
      });
    ghosts->SetDataSet(block.level, 0, grid);
  }
  data = scene.Show(ghosts, 8.0, "ghost layers");
  checks.Equal(data->GetNumberOfLeafCells(), leaves, "ghost layers are not counted");

  // Two blocks of a level that overlap: where they do, the second holds duplicates.
  const std::vector<test::Block> overlap{ { 0, { 0, 0, 0 }, { 6, 8, 8 } },
    { 0, { 4, 0, 0 }, { 4, 8, 8 } } };
  auto duplicates = test::makeNullBlocks(overlap);
  const auto shared = [](double x, double, double) { return x < 6.0 ? 1.0 : 0.0; };
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto grid = test::makeGrid(overlap[i]);
    test::addCells(grid, [&](double x, double, double) { return i == 1 && x < 6.0 ? Junk : 1.0; });
    mark(grid, vtkDataSetAttributes::DUPLICATECELL, i == 1 ? shared : test::constant(0.0));
    duplicates->SetDataSet(0, i, grid);
  }
  data = scene.Show(duplicates, 8.0, "duplicates", 5.0);
  checks.Equal(data->GetNumberOfLeafCells(), 8 * 8 * 8, "duplicates are counted once");

  // Duplicates that no block here owns are another process's to draw.
  auto foreign = test::makeNullBlocks(blocks);
  for (const test::Block& block : blocks)
  {
    auto grid = test::makeGrid(block);
    test::addCells(grid, [](double, double, double z) { return z > 6.0 ? Junk : 1.0; });
    mark(grid, vtkDataSetAttributes::DUPLICATECELL,
      [](double, double, double z) { return z > 6.0 ? 1.0 : 0.0; });
    foreign->SetDataSet(block.level, 0, grid);
  }
  data = scene.Show(foreign, 6.0, "duplicates of another process");
  checks.Equal(data->GetNumberOfAbsentCells(), 8 * 8 * 2, "they are absent");

  // A fine block that is not there does not cover anything; a coarse one leaves a hole.
  auto withoutFine = test::makeNullBlocks(blocks);
  auto coarse = test::makeGrid(blocks[0]);
  test::addCells(coarse, test::constant(1.0));
  withoutFine->SetDataSet(0, 0, coarse);
  data = scene.Show(withoutFine, 8.0, "without the fine block", 2.0);
  checks.Equal(data->GetNumberOfLeafCells(), 8 * 8 * 8, "leaf cells without the fine block");
  checks.Equal(data->GetNumberOfLevels(), 1, "levels without the fine block");
  checks.Says(messages.TakeWarnings(), { "Of 2 levels 1 was read", "53 %" }, "a level not read");
  auto withoutCoarse = test::makeNullBlocks(blocks);
  auto fine = test::makeGrid(blocks[1]);
  test::addCells(fine, test::constant(1.0));
  withoutCoarse->SetDataSet(1, 0, fine);
  scene.Show(withoutCoarse, 4.0, "without the coarse block", 2.0);

  // Finer blocks that cover coarse cells in part: said once, and seamless.
  checks.Silent(messages.TakeWarnings(), "no warnings");
  const std::vector<test::Block> misaligned{ { 0, { 0, 0, 0 }, { 8, 8, 8 } },
    { 1, { 1, 1, 1 }, { 6, 6, 6 } }, { 1, { 9, 9, 9 }, { 3, 3, 3 } } };
  data = scene.Show(test::makeAMR(misaligned, test::constant(1.0)), 8.0, "misaligned blocks", 2.0);
  checks.Near(test::Picture(stage.window).Coverage(), 1.0, 0.0, "misaligned blocks leave no gap");
  checks.Equal(messages.Warnings().size(), 1, "warnings of misaligned blocks");
  checks.Says(messages.TakeWarnings(), { "in part" }, "warning of misaligned blocks");
  checks.Silent(messages.TakeErrors(), "no errors");

  // For the eye.
  auto bowl =
    test::makeAMR({ { 0, { 0, 0, 0 }, { 16, 16, 16 } }, { 1, { 8, 8, 0 }, { 16, 16, 16 } } },
      [](double x, double y, double z) { return std::hypot(x - 8.0, y - 8.0, z - 8.0); });
  test::forEachGrid(bowl,
    [](unsigned int, vtkUniformGrid* grid)
    {
      mark(grid, vtkDataSetAttributes::HIDDENCELL,
        [](double, double, double z) { return z > 9.0 ? 1.0 : 0.0; });
    });
  stage.mapper->SetInputData(bowl);
  stage.mapper->SetStepScale(0.25); // an edge of hidden cells is as sharp as a step
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(4.0, 1.0, 0.9, 0.3);
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(7.0, 0.8, 0.1, 0.1);
  stage.Property()->GetScalarOpacity()->RemoveAllPoints();
  stage.Property()->GetScalarOpacity()->AddPoint(4.0, 0.0);
  stage.Property()->GetScalarOpacity()->AddPoint(6.0, 0.7);
  stage.Property()->GetScalarOpacity()->AddPoint(8.0, 0.0);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(22.0, -8.0, 40.0);
  camera->SetFocalPoint(8.0, 8.0, 4.0);
  stage.renderer->ResetCameraClippingRange();
  const int image = vtkRegressionTestImage(stage.window);
  return image == vtkTesting::FAILED ? EXIT_FAILURE : checks.Status();
}
