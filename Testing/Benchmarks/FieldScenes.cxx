// SPDX-License-Identifier: BSD-3-Clause
// Fields with a formula, sampled on grids: pictures are compared with those of the fields
// themselves, so that the reconstruction's error counts and not that of the integration alone.
#include "SceneTable.h"

#include "Accuracy/PictureAccuracy.h"

namespace exabricks
{
namespace benchmarks
{
namespace
{
using namespace accuracy;

Grid makeGrid(Hierarchy hierarchy, int coarseCells)
{
  Grid grid{ std::move(hierarchy), {}, coarseCells, 1.0 };
  grid.leaves = findLeafBoxes(grid.hierarchy);
  grid.cellShare = 1.0 / static_cast<double>(coarseCells * grid.hierarchy.cellWidth[0]);
  return grid;
}

Model makeFieldModel(
  const std::string& name, Grid grid, const Field& field, const TransferFunction& transfer)
{
  PictureSettings settings;
  settings.step = 1.0 / 1024;
  Model model;
  model.name = name;
  model.hierarchy = grid.hierarchy;
  model.hierarchy.spacing = glm::dvec3(grid.cellShare); // the unit cube
  model.cells = std::make_shared<reference::ArraySource>(
    reference::fillCells(grid.hierarchy, atCenters(grid, field)));
  model.transfer = [transfer](const Range& range)
  {
    std::vector<TransferFunction::Point> points = transfer.points();
    for (TransferFunction::Point& point : points)
    {
      point.value = range.normalize(point.value);
    }
    return TransferFunction(points);
  };
  model.opacityUnitDistance = settings.unitDistance;
  // as renderField looks
  model.camera = reference::frame(
    model.hierarchy, reference::boundsOf(model.hierarchy), { 1.0, 0.7, -0.4 }, 0.0, 1.0);
  model.truth = [=](const Size& size)
  {
    PictureSettings sized = settings;
    sized.pixels = size[0];
    return renderField(field.value, transfer, sized);
  };
  return model;
}
}

std::vector<SceneKind> listFieldScenes()
{
  struct Case
  {
    std::string name;
    std::function<Grid()> grid;
    Field field;
  };
  const Field bell = gaussian({ 0.4, 0.45, 0.55 }, 0.3);
  const Field front = movingFront(0.35, 0.02); // about a fine cell wide
  const Case cases[] = {
    { "shell field, 2 levels", [] { return makeShellGrid({ 2 }, 32); }, shellAndBlobs() },
    { "shell field, 3 levels",
      [] {
        return makeShellGrid({ 2, 2 }, 32);
      },
      shellAndBlobs() },
    { "shell field, ratio 4", [] { return makeShellGrid({ 4 }, 32); }, shellAndBlobs() },
    { "shell field, 3 levels in blocks of 16",
      [] {
        return makeGrid(reference::refinedAtShell({ 2, 2 }, 64, 16), 64);
      },
      shellAndBlobs() },
    { "Gaussian, ratio 2", [] { return makeBoxGrid(2, 32); }, bell },
    { "Gaussian, ratio 4", [] { return makeBoxGrid(4, 16); }, bell },
    { "front, ratio 2", [] { return makeBoxGrid(2, 32); }, front },
    { "front, ratio 4", [] { return makeBoxGrid(4, 16); }, front },
  };
  std::vector<SceneKind> scenes;
  for (const Case& c : cases)
  {
    for (const bool ramp : { true, false })
    {
      const std::string name = c.name + (ramp ? ", ramp" : ", veils");
      scenes.push_back({ name, "field", false, false, [=](double) {
                          return makeFieldModel(
                            name, c.grid(), c.field, ramp ? rampTransfer() : veilTransfer());
                        } });
    }
  }
  return scenes;
}
}
}
