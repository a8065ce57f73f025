// SPDX-License-Identifier: BSD-3-Clause
// Two arrays in one picture: one has the colours and another one the opacity, or both are the
// variables of a 2-D transfer function.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

namespace
{
double heat(double x, double, double) { return x; }
double dust(double, double y, double) { return 0.1 * y; }

// Cells with the arrays "heat", "dust" and, of both, "pair".
vtkSmartPointer<vtkOverlappingAMR> makeAMR()
{
  auto amr = test::makeAMR(test::cornerRefined(), test::constant(0.0));
  test::forEachGrid(amr,
    [](unsigned int, vtkUniformGrid* grid)
    {
      const vtkSmartPointer<vtkDataArray> dusts = test::addCells(grid, dust, "dust");
      const vtkSmartPointer<vtkDataArray> pairs =
        test::addCells(grid, std::vector<test::Field>{ heat, dust }, "pair");
      test::addCells(grid, heat, "heat"); // which takes their place as active scalars
      grid->GetCellData()->AddArray(dusts);
      grid->GetCellData()->AddArray(pairs);
    });
  return amr;
}

// Of two variables in [0, 1]: opaque from the half of the second one on, red by the first.
vtkSmartPointer<vtkImageData> makeFunction()
{
  auto function = vtkSmartPointer<vtkImageData>::New();
  function->SetDimensions(2, 2, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  auto* colors = vtkFloatArray::SafeDownCast(function->GetPointData()->GetScalars());
  colors->SetTuple4(0, 0.0, 0.0, 1.0, 0.0);
  colors->SetTuple4(1, 1.0, 0.0, 1.0, 0.0);
  colors->SetTuple4(2, 0.0, 0.0, 1.0, 1.0);
  colors->SetTuple4(3, 1.0, 0.0, 1.0, 1.0);
  return function;
}
}

int TestTwoArrays(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(makeAMR(), 60);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  vtkVolumeProperty* property = stage.Property();
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SetReconstructionToBasis();
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 0.2, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(8.0, 0.0, 0.4, 1.0);
  property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  property->GetScalarOpacity()->AddPoint(0.8, 0.3);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);

  // The same as an array that has both.
  mapper->SelectScalarArray("pair");
  property->IndependentComponentsOff();
  const test::Picture pair(stage.window);
  property->IndependentComponentsOn();
  mapper->SelectScalarArray("heat");
  mapper->SetOpacityArrayName("dust");
  const test::Picture two(stage.window);
  checks.Expect(pair.Coverage() > 0.5, "something shows");
  checks.Expect(
    std::isinf(two.Decibel(pair)), "opacity of another array, as of a second component");
  mapper->SetOpacityArrayName("pair");
  mapper->SetOpacityComponent(1);
  checks.Expect(
    std::isinf(test::Picture(stage.window).Decibel(pair)), "of a component of another array");
  mapper->SetOpacityComponent(0);
  checks.Expect(test::Picture(stage.window).Decibel(pair) < 40.0, "of another component");

  // An array that is not there.
  mapper->SetOpacityArrayName("smoke");
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "without the array");
  checks.Says(messages.TakeErrors(), { "'smoke'", "'dust'", "SetOpacityArrayName" }, "no array");
  mapper->SetOpacityArrayName("dust");
  mapper->SetBlendModeToIsoSurface();
  property->GetIsoSurfaceValues()->SetValue(0, 4.0);
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "iso-surface", "two arrays" }, "iso-surfaces");
  mapper->SetBlendModeToComposite();

  // Both as variables: half red, and opaque where there is much dust.
  mapper->SetOpacityArrayName(nullptr);
  mapper->SetTransfer2DYAxisArray("dust");
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "2-D transfer function", "SetTransferFunctionMode" },
    "a second variable without a function of two");
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "four components", "none" }, "no 2-D function");
  property->SetTransferFunction2D(makeFunction());
  const test::Picture plane(stage.window);
  // Heat goes from 0.25 to 7.5; the function's pixels have their middles at 1/4 and 3/4.
  const double variable = (8.0 * 30.5 / 60.0 - 0.25) / 7.25;
  checks.Near(plane.At(30, 55)[0], 2.0 * variable - 0.5, 2.0 * test::OneStep, "half of the heat");
  checks.Near(plane.At(30, 55)[2], 1.0, test::OneStep, "much dust is opaque");
  checks.Near(plane.At(30, 4)[2], 0.0, test::OneStep, "little does not show");
  checks.Expect(mapper->GetDrawn(), "it is drawn");

  // The gradient of the heat alone is the same everywhere, and small.
  mapper->SetTransfer2DYAxisArray(nullptr);
  checks.Near(test::Picture(stage.window).Coverage(), 1.0, 1e-9, "by the gradient");
  mapper->SetBlendModeToMaximumIntensity();
  test::Picture(stage.window);
  checks.Says(
    messages.TakeWarnings(), { "2-D", "composite", "1-D" }, "maximum with a 2-D function");
  checks.Silent(messages.TakeErrors(), "no errors");
  return checks.Status();
}
