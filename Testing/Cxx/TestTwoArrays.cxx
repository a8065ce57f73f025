// SPDX-License-Identifier: BSD-3-Clause
// Two arrays in one picture: one has the colours and another one the opacity, or both are the
// variables of a 2-D transfer function.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

namespace
{
double heat(double x, double, double) { return x; }
double dust(double, double y, double) { return 0.1 * y; }
double depth(double, double, double z) { return z; }

// Cells with the arrays "heat", "dust" and "depth", and, of the first two, "pair".
vtkSmartPointer<vtkOverlappingAMR> makeAMR()
{
  auto amr = test::makeAMR(test::cornerRefined(), test::constant(0.0));
  test::forEachGrid(amr,
    [](unsigned int, vtkUniformGrid* grid)
    {
      const vtkSmartPointer<vtkDataArray> dusts = test::addCells(grid, dust, "dust");
      const vtkSmartPointer<vtkDataArray> pairs =
        test::addCells(grid, std::vector<test::Field>{ heat, dust }, "pair");
      const vtkSmartPointer<vtkDataArray> depths = test::addCells(grid, depth, "depth");
      test::addCells(grid, heat, "heat"); // which takes their place as active scalars
      grid->GetCellData()->AddArray(dusts);
      grid->GetCellData()->AddArray(depths);
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

constexpr int Pixels = 60; // for a width of 8
double middle(int pixel) { return (pixel + 0.5) * 8.0 / Pixels; }
// The function's pixels have their middles at 1/4 and 3/4; arrays go from 0.25 to 7.5 of their
// unit.
double share(double place) { return std::clamp((place - 0.25) / 7.25, 0.0, 1.0); }
double red(double place) { return std::clamp(2.0 * share(place) - 0.5, 0.0, 1.0); }
double dustOpacity(double y) { return red(y); }
double coarseMiddle(double place) { return std::floor(place) + 0.5; }

int TestTwoArrays(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(makeAMR(), Pixels);
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

  // A surface of one array, across the window, with its colour and the opacity of the other one.
  mapper->SelectScalarArray("depth");
  mapper->SetOpacityArrayName("dust");
  mapper->SetReconstructionToCompleted(); // has linear fields exactly, across levels
  mapper->SetBlendModeToIsoSurface();
  property->GetIsoSurfaceValues()->SetValue(0, 4.0);
  const test::Picture surface(stage.window);
  for (const int row : { 8, 25, 52 })
  {
    const double opacity = 0.3 * 0.1 * middle(row) / 0.8;
    checks.Near(surface.At(10, row)[0], 0.5 * opacity, test::OneStep, "a surface's red");
    checks.Near(surface.At(10, row)[1], 0.3 * opacity, test::OneStep, "a surface's green");
  }
  // By gradients that of the one with opacity counts: here 0.1 along y, and 1 along z of the other.
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.1, 0.5);
  byGradient->AddPoint(0.4, 1.0);
  property->SetGradientOpacity(byGradient);
  const test::Picture lessened(stage.window);
  property->SetGradientOpacity(nullptr);
  checks.Near(
    lessened.At(10, 52)[0], 0.5 * surface.At(10, 52)[0], test::OneStep, "by the gradient");
  mapper->SelectScalarArray("heat");
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
  checks.Near(plane.At(30, 55)[0], red(middle(30)), test::OneStep, "half of the heat");
  checks.Near(plane.At(30, 55)[2], 1.0, test::OneStep, "much dust is opaque");
  checks.Near(plane.At(30, 4)[2], 0.0, test::OneStep, "little does not show");
  checks.Expect(mapper->GetDrawn(), "it is drawn");

  // With other blend modes too: along a ray neither heat nor dust changes, so that all of it is
  // like its greatest value and a slice.
  vtkNew<vtkPlane> slice;
  slice->SetOrigin(0.0, 0.0, 3.3);
  slice->SetNormal(0.0, 0.0, 1.0);
  property->SetSliceFunction(slice);
  for (const int mode : { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::SLICE_BLEND })
  {
    mapper->SetBlendMode(mode);
    const test::Picture picture(stage.window);
    const std::string what = std::string("2-D, blend mode ") + std::to_string(mode);
    for (const int row : { 20, 30, 40 })
    {
      const double opacity = dustOpacity(middle(row));
      checks.Near(picture.At(45, row)[2], opacity, test::OneStep, what + ", opacity");
      checks.Near(picture.At(45, row)[0], red(middle(45)) * opacity, test::OneStep, what + ", red");
    }
  }
  // The mean of opacity times value, over values up to 6.
  mapper->SetBlendModeToAverageIntensity();
  mapper->SetAverageIPScalarRange(0.0, 6.0);
  const test::Picture mean(stage.window);
  for (const int column : { 10, 20, 40, 55 })
  {
    const double expected = share(middle(column)) * dustOpacity(middle(33));
    checks.Near(mean.At(column, 33)[1], middle(column) > 6.0 ? 0.0 : expected, test::OneStep,
      "2-D, average of a range");
  }
  // A surface of the depth, coloured by the one and opaque by the other variable.
  mapper->SelectScalarArray("depth");
  mapper->SetBlendModeToIsoSurface();
  property->GetIsoSurfaceValues()->SetValue(0, 3.0);
  for (const int reconstruction : { mapper->COMPLETED, mapper->NEAREST })
  {
    mapper->SetReconstruction(reconstruction);
    const test::Picture picture(stage.window);
    for (const int row : { 4, 33, 56 })
    {
      const double y = reconstruction == mapper->NEAREST ? coarseMiddle(middle(row)) : middle(row);
      checks.Near(picture.At(45, row)[0], red(3.0) * dustOpacity(y), test::OneStep,
        "2-D, a surface's colour");
      checks.Near(
        picture.At(45, row)[2], dustOpacity(y), test::OneStep, "2-D, a surface's opacity");
    }
  }
  mapper->SetReconstructionToCompleted();
  mapper->SelectScalarArray("heat");
  mapper->SetBlendModeToComposite();

  // The gradient of the heat alone is the same everywhere, and small.
  mapper->SetTransfer2DYAxisArray(nullptr);
  checks.Near(test::Picture(stage.window).Coverage(), 1.0, 1e-9, "by the gradient");
  // Here a finest cell of half a unit has 0.276 of the greatest gradient, a quarter of the range.
  const double steepness = 0.6 + 0.4 * 2.0 * (4.0 * 0.5 / 7.25 - 0.25);
  vtkDataArray* function = property->GetTransferFunction2D()->GetPointData()->GetScalars();
  function->SetTuple4(0, 0.0, 0.0, 1.0, 0.6);
  function->SetTuple4(1, 1.0, 0.0, 1.0, 0.6);
  property->GetTransferFunction2D()->Modified();
  mapper->SelectScalarArray("depth");
  mapper->SetReconstructionToCompleted();
  slice->SetOrigin(0.0, 0.0, 5.0);
  property->GetIsoSurfaceValues()->SetValue(0, 5.0);
  for (const int mode : { vtkVolumeMapper::SLICE_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND })
  {
    mapper->SetBlendMode(mode);
    const test::Picture picture(stage.window);
    const std::string what = "a value and its gradient, blend mode " + std::to_string(mode);
    checks.Near(picture.At(20, 20)[2], steepness, test::OneStep, what + ", opacity");
    checks.Near(picture.At(20, 20)[0], steepness * red(5.0), test::OneStep, what + ", red");
  }

  // A maximum by the 1-D functions right after one by the 2-D one.
  mapper->SetBlendModeToMaximumIntensity();
  checks.Expect(test::Picture(stage.window).Coverage() > 0.9, "a maximum, 2-D");
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  const test::Picture maximum(stage.window);
  test::Stage fresh(makeAMR(), Pixels);
  fresh.mapper->SetScalarModeToUseCellFieldData();
  fresh.mapper->SelectScalarArray("depth");
  fresh.mapper->SetReconstructionToCompleted();
  fresh.mapper->SetBlendModeToMaximumIntensity();
  fresh.Property()->DeepCopy(property);
  test::lookAlongZ(fresh.renderer, 4.0, 4.0, 4.0, 8.0);
  checks.Expect(std::isinf(maximum.Decibel(test::Picture(fresh.window))), "a maximum, 1-D");
  checks.Expect(maximum.Coverage() > 0.9, "it shows");
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  mapper->SetBlendModeToComposite();

  // By all components of an array there is none.
  mapper->SelectScalarArray("pair");
  test::Picture(stage.window);
  checks.Says(messages.TakeWarnings(), { "2-D", "one component", "1-D" }, "of two components");
  checks.Silent(messages.TakeErrors(), "no errors");
  return checks.Status();
}
