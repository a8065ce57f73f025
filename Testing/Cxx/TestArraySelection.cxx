// SPDX-License-Identifier: BSD-3-Clause
// The mapper draws the array that it is told to, by VTK's own setters: active scalars of cells or
// points, arrays by name or by number, and of vectors the magnitude or a component.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkPointData.h"

namespace
{
void addArray(
  vtkDataSetAttributes* data, vtkIdType tuples, const char* name, const std::vector<double>& tuple)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(tuple.size()));
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    array->SetTuple(i, tuple.data());
  }
  data->AddArray(array);
}

// Arrays of one value each, to be told apart by it.
vtkSmartPointer<vtkOverlappingAMR> makeManyArrays()
{
  auto amr = test::makeAMR(test::cornerRefined(), test::constant(1.0)); // "value", active
  test::forEachGrid(amr,
    [](unsigned int, vtkUniformGrid* grid)
    {
      addArray(grid->GetCellData(), grid->GetNumberOfCells(), "other", { 2.0 });
      addArray(grid->GetCellData(), grid->GetNumberOfCells(), "vector", { 3.0, 4.0, 12.0 });
      addArray(grid->GetPointData(), grid->GetNumberOfPoints(), "points", { 6.0 });
    });
  return amr;
}

struct Selection
{
  test::Checks& checks;
  test::Stage& stage;

  // The array drawn, and its only value, seen as white of that much in 20.
  void Is(const std::string& name, double value, const std::string& what) const
  {
    const double drawn = test::Picture(this->stage.window).Center()[0];
    vtkExaBricksData* data = this->stage.mapper->GetBuilder()->GetOutput();
    const char* array = data->GetArrayName();
    double range[2];
    data->GetScalarRange(range);
    this->checks.Expect(array && array == name,
      what + ": expected array " + name + ", found " + (array ? array : "none"));
    this->checks.Near(range[0], value, 1e-12, what + ": least value");
    this->checks.Near(range[1], value, 1e-12, what + ": greatest value");
    this->checks.Near(drawn, value / 20.0, test::OneStep, what + ": colour");
  }
};
}

int TestArraySelection(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  auto amr = makeManyArrays();
  test::Stage stage(amr, 50);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  test::setConstantColor(stage.Property(), 1.0, { 0.0, 0.0, 0.0 });
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(20.0, 1.0, 1.0, 1.0);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  const Selection selection{ checks, stage };

  selection.Is("value", 1.0, "default mode, active scalars of cells only");
  mapper->SetScalarModeToUseCellData();
  selection.Is("value", 1.0, "active scalars of cells");
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray("other");
  selection.Is("other", 2.0, "cell array by name");
  mapper->SelectScalarArray(0);
  selection.Is("value", 1.0, "cell array by number 0");
  mapper->SelectScalarArray(1);
  selection.Is("other", 2.0, "cell array by number 1");

  mapper->SelectScalarArray("vector");
  mapper->SetVectorModeToMagnitude();
  selection.Is("vector", 13.0, "magnitude");
  mapper->SetVectorModeToComponent();
  for (int component = 0; component < 3; ++component)
  {
    mapper->SetVectorComponent(component);
    selection.Is(
      "vector", component == 2 ? 12.0 : 3.0 + component, "component " + std::to_string(component));
  }
  mapper->SelectScalarArray("other");
  selection.Is("other", 2.0, "an array of one component has no others");
  mapper->SetVectorModeToMagnitude();
  checks.Expect(messages.Warnings().empty(), "cell arrays need no warning");

  // Point arrays are converted to cells, which is said once.
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("points");
  selection.Is("points", 6.0, "point array by name");
  mapper->SelectScalarArray(0);
  selection.Is("points", 6.0, "point array by number");
  test::forEachGrid(amr,
    [](unsigned int, vtkUniformGrid* grid) { grid->GetPointData()->SetActiveScalars("points"); });
  amr->Modified();
  mapper->SetScalarModeToUsePointData();
  selection.Is("points", 6.0, "active scalars of points");
  mapper->SetScalarModeToDefault();
  selection.Is("points", 6.0, "default mode prefers points");
  checks.Equal(messages.Warnings().size(), 1, "warnings of point arrays");
  checks.Says(messages.TakeWarnings(), { "'points' is a point array" }, "warning of point arrays");
  checks.Silent(messages.TakeErrors(), "no errors");

  // All this without new bricks.
  checks.Equal(mapper->GetBuilder()->GetNumberOfStructureBuilds(), 1, "builds of the structure");
  return checks.Status();
}
