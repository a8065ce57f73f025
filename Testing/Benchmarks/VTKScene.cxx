// SPDX-License-Identifier: BSD-3-Clause
#include "VTKScene.h"

#include "Cxx/AMR.h"

#include "vtkAMRUtilities.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <cmath>

namespace exabricks
{
namespace benchmarks
{
namespace
{
test::Lattice latticeOf(const Hierarchy& hierarchy)
{
  test::Lattice lattice;
  for (int axis = 0; axis < 3; ++axis)
  {
    lattice.origin[axis] = hierarchy.origin[axis];
    lattice.spacing[axis] =
      hierarchy.spacing[axis] * static_cast<double>(hierarchy.cellWidth.front());
  }
  for (int level = 1; level < hierarchy.levels(); ++level)
  {
    lattice.ratios.push_back(
      static_cast<int>(hierarchy.cellWidth[level - 1] / hierarchy.cellWidth[level]));
  }
  return lattice;
}

vtkSmartPointer<vtkOverlappingAMR> makeAMR(const Model& model, const char* array)
{
  const Hierarchy& hierarchy = model.hierarchy;
  const test::Lattice lattice = latticeOf(hierarchy);
  std::vector<test::Block> blocks;
  for (const Block& block : hierarchy.blocks)
  {
    test::Block box{ static_cast<unsigned int>(block.level), {}, {} };
    for (int axis = 0; axis < 3; ++axis)
    {
      box.first[axis] = static_cast<int>(block.cells.lo[axis]);
      box.cells[axis] = static_cast<int>(block.cells.size()[axis]);
    }
    blocks.push_back(box);
  }
  auto amr = test::makeNullBlocks(blocks, lattice);
  std::vector<unsigned int> next(amr->GetNumberOfLevels(), 0);
  std::vector<double> row;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    auto grid = test::makeGrid(blocks[b], lattice);
    row.resize(static_cast<std::size_t>(grid->GetNumberOfCells()));
    model.cells->read(static_cast<int>(b), hierarchy.blocks[b].cells, row.data());
    vtkNew<vtkFloatArray> values;
    values->SetName(array);
    values->SetNumberOfTuples(grid->GetNumberOfCells());
    std::copy(row.begin(), row.end(), values->GetPointer(0));
    grid->GetCellData()->SetScalars(values);
    amr->SetDataSet(blocks[b].level, next[blocks[b].level]++, grid);
  }
  for (int level = 0; level + 1 < hierarchy.levels(); ++level)
  {
    amr->SetRefinementRatio(level, lattice.ratios[level]);
  }
  vtkAMRUtilities::BlankCells(amr);
  return amr;
}

vtkSmartPointer<vtkVolumeProperty> makeProperty(const Scene& scene)
{
  const Range& range = scene.scalars().range;
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacity;
  double last = -std::numeric_limits<double>::infinity();
  for (const TransferFunction::Point& point : scene.transfer().points())
  {
    double value = range.min + point.value * (range.max - range.min);
    if (value <= last) // a jump: VTK keeps one node for a value
    {
      value = std::nextafter(last, std::numeric_limits<double>::infinity());
    }
    colors->AddRGBPoint(value, point.color.r, point.color.g, point.color.b);
    opacity->AddPoint(value, point.color.a);
    last = value;
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(scene.model().opacityUnitDistance);
  return property;
}
}

std::shared_ptr<VTKScene> makeVTKScene(const Scene& scene)
{
  auto made = std::make_shared<VTKScene>();
  made->array = "value";
  made->amr = makeAMR(scene.model(), made->array.c_str());
  made->property = makeProperty(scene);
  return made;
}

vtkSmartPointer<vtkActor> makeSurfaceActor(const Surface& surface)
{
  if (surface.triangles.empty())
  {
    return nullptr;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& p : surface.points)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const glm::ivec3& t : surface.triangles)
  {
    triangles->InsertNextCell({ t.x, t.y, t.z });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkCamera> makeCamera(const Model& model)
{
  const reference::Camera& from = model.camera;
  const glm::dvec3 position = model.hierarchy.origin + from.position;
  const glm::dvec3 focus = model.hierarchy.origin + from.focalPoint;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(from.viewUp.x, from.viewUp.y, from.viewUp.z);
  camera->SetClippingRange(from.nearest, from.farthest);
  if (from.viewAngle > 0.0)
  {
    camera->SetViewAngle(from.viewAngle);
  }
  else
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(from.parallelScale);
  }
  return camera;
}

PeerData makePeerData(const Scene& scene)
{
  const VTKScene& vtk = scene.vtk();
  const Hierarchy& hierarchy = scene.model().hierarchy;
  const Box& bounds = scene.structure().tree.bounds;
  const glm::dvec3& spacing = hierarchy.spacing;
  return { vtk.amr, vtk.array, vtk.component, hierarchy.origin + spacing * glm::dvec3(bounds.lo),
    hierarchy.origin + spacing * glm::dvec3(bounds.hi),
    std::min({ spacing.x, spacing.y, spacing.z }) };
}
}
}
