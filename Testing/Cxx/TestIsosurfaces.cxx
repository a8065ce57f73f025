// SPDX-License-Identifier: BSD-3-Clause
// Iso-surfaces: each of its colour and opacity, one behind the other, lit, and where the field has
// the value, to a hundredth of a cell: opaque geometry that is as much nearer hides them.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkContourValues.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace
{
// Values rise along z, on two levels; the reconstruction Completed has them as they are.
vtkSmartPointer<vtkOverlappingAMR> makeSlope()
{
  return test::makeAMR(test::cornerRefined(), [](double, double, double z) { return z; });
}
}

int TestIsosurfaces(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(makeSlope(), 50);
  vtkVolumeProperty* property = stage.Property();
  property->GetRGBTransferFunction()->AddRGBPoint(2.0, 1.0, 0.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(6.0, 0.0, 1.0, 0.0);
  property->GetScalarOpacity()->AddPoint(2.0, 0.8);
  property->GetScalarOpacity()->AddPoint(6.0, 0.4);
  stage.mapper->SetBlendModeToIsoSurface();
  stage.mapper->SetReconstructionToCompleted();
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);

  // Without values nothing is drawn, and that is said.
  vtkContourValues* values = property->GetIsoSurfaceValues();
  values->SetNumberOfContours(0);
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "no values");
  checks.Says(messages.TakeWarnings(), { "Nothing is drawn", "no iso-value" }, "no values");
  values->SetValue(0, std::nan(""));
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "finite iso-values", "nan" }, "no number");

  // Two surfaces, the nearer one first whatever the order of the values.
  values->SetValue(0, 6.0);
  values->SetValue(1, 2.0);
  const auto shows = [&](double red, double green, const std::string& what)
  {
    const test::Picture picture(stage.window);
    for (const int place : { 10, 25, 40 }) // coarse and fine cells
    {
      checks.Near(picture.At(place, place)[0], red, test::OneStep, what + ", red");
      checks.Near(picture.At(place, place)[1], green, test::OneStep, what + ", green");
    }
  };
  shows(0.6 * 0.8, 0.4, "two surfaces");
  values->SetNumberOfContours(1);
  shows(0.0, 0.4, "one surface");

  // Lit: the normal is along the ray.
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.0);
  shows(0.0, 0.4 * 0.7, "lit");
  property->ShadeOff();
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.0, 0.5);
  property->SetGradientOpacity(byGradient);
  shows(0.0, 0.5 * 0.4, "less opaque by its gradient");
  property->SetGradientOpacity(nullptr);

  // A blue sheet a little before the surface, and behind it.
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> sheetMapper;
  vtkNew<vtkActor> sheet;
  sheetMapper->SetInputConnection(plane->GetOutputPort());
  sheet->SetMapper(sheetMapper);
  sheet->GetProperty()->SetColor(0.0, 0.0, 1.0);
  sheet->GetProperty()->LightingOff();
  stage.renderer->AddActor(sheet);
  for (const double iso : { 2.3, 4.0, 5.61 })
  {
    values->SetValue(0, iso);
    property->GetScalarOpacity()->RemoveAllPoints();
    property->GetScalarOpacity()->AddPoint(0.0, 1.0);
    for (const double off : { -0.005, 0.005 }) // hundredths of a finest cell
    {
      plane->SetOrigin(-1.0, -1.0, iso + off);
      plane->SetPoint1(9.0, -1.0, iso + off);
      plane->SetPoint2(-1.0, 9.0, iso + off);
      stage.renderer->ResetCameraClippingRange();
      const test::Picture picture(stage.window);
      for (const int place : { 10, 25, 40 })
      {
        checks.Near(picture.At(place, place)[2], off > 0.0 ? 1.0 : 0.0, test::OneStep,
          "a sheet at " + std::to_string(iso + off));
      }
    }
  }
  sheet->VisibilityOff();

  // Cells of one value each have their surface at the face between two of them.
  stage.mapper->SetReconstructionToNearest();
  values->SetValue(0, 4.2);
  checks.Expect(test::Picture(stage.window).Coverage() > 0.9, "surfaces of cells");

  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");

  // A ray that passes a surface and comes back between two samples meets it twice. The field rises
  // to 0.996 at 5.5; with steps of 2 cells it is sampled at 6 and 4, where it is less.
  test::Stage ridge(test::makeAMR({ { 0, { 0, 0, 0 }, { 4, 4, 12 } } },
                      [](double, double, double z) { return 1.0 - std::pow((z - 5.25) / 4.0, 2); }),
    10);
  test::setConstantColor(ridge.Property(), 0.5);
  ridge.mapper->SetBlendModeToIsoSurface();
  ridge.Property()->GetIsoSurfaceValues()->SetValue(0, 0.98);
  test::lookAlongZ(ridge.renderer, 2.0, 2.0, 6.0, 1.0);
  for (const double step : { 0.1, 0.5, 1.0, 2.0 })
  {
    ridge.mapper->SetStepScale(step);
    checks.Near(test::Picture(ridge.window).Center()[0], 0.75, test::OneStep,
      "twice through a surface, step " + std::to_string(step));
  }
  return checks.Status();
}
