// SPDX-License-Identifier: BSD-3-Clause
// What else is set of a volume, a mapper or a scene does the same as with VTK's mappers.

#include "Parity.h"

#include "vtkActor.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

namespace
{
constexpr double Cells = 24.0;

void checkFunctions(test::Checks& checks)
{
  parity::Mappers mappers({ { 24, 24, 24 }, {}, parity::ball });
  mappers.ShowBall();
  vtkVolumeProperty* property = mappers.Property();
  mappers.ExpectSame(checks, "a ball");

  property->SetScalarOpacityUnitDistance(3.0);
  mappers.ExpectSame(checks, "unit distance 3");
  mappers.volume->SetScale(0.25);
  mappers.renderer->ResetCamera();
  mappers.renderer->GetActiveCamera()->Zoom(1.4);
  mappers.ExpectSame(checks, "a volume scaled down is as opaque");
  mappers.volume->SetScale(1.0);
  mappers.renderer->ResetCamera();
  mappers.renderer->GetActiveCamera()->Zoom(1.4);
  property->SetScalarOpacityUnitDistance(1.0);

  property->GetScalarOpacity()->ClampingOff();
  mappers.ExpectSame(checks, "opacity without clamping");
  property->GetScalarOpacity()->ClampingOn();

  const vtkSmartPointer<vtkColorTransferFunction> colors = property->GetRGBTransferFunction();
  colors->SetColorSpaceToHSV();
  mappers.ExpectSame(checks, "colors between nodes by hue");
  colors->SetColorSpaceToRGB();

  vtkNew<vtkDiscretizableColorTransferFunction> steps;
  steps->DeepCopy(colors);
  steps->SetNumberOfValues(5);
  steps->DiscretizeOn();
  steps->Build();
  const test::Picture smooth = mappers.Draw(mappers.mapper);
  property->SetColor(steps);
  checks.Expect(mappers.Draw(mappers.onGPU).Decibel(smooth) > 35.0, "VTK's mappers draw no steps");
  checks.Expect(mappers.Draw(mappers.mapper).Decibel(smooth) < 35.0, "ours does");
  property->SetColor(colors);

  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 1.0);
  gray->AddPoint(12.0, 0.2);
  property->SetColor(gray);
  mappers.ExpectSameAs(checks, mappers.fixedPoint, "shades of gray, which the GPU mapper ignores");
  property->SetColor(colors);
}

// The field's values are those of cells: of an image those of points in their middles, which VTK
// draws from the first to the last of them.
void checkNearest(test::Checks& checks)
{
  parity::Mappers mappers({ { 24, 24, 24 }, {}, parity::ball });
  mappers.ShowBall();
  mappers.Property()->SetInterpolationTypeToNearest();
  vtkNew<vtkImageData> image;
  image->SetOrigin(0.5, 0.5, 0.5);
  image->SetDimensions(24, 24, 24);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    const double* const at = image->GetPoint(point);
    image->GetPointData()->GetScalars()->SetComponent(point, 0, parity::ball(at[0], at[1], at[2]));
  }
  mappers.fixedPoint->SetInputData(image);
  mappers.onGPU->SetInputData(image);
  mappers.mapper->CroppingOn();
  mappers.mapper->SetCroppingRegionPlanes(0.5, 23.5, 0.5, 23.5, 0.5, 23.5);
  // The fixed-point mapper has other cells along rays: 27 dB to both.
  mappers.ExpectSameAsOnGPU(checks, "nearest");
}

void checkPictures(test::Checks& checks)
{
  parity::Mappers mappers({ { 24, 24, 24 }, {}, parity::ball });
  mappers.ShowBall();

  const auto setFinalColor = [&](float window, float level)
  {
    mappers.mapper->SetFinalColorWindow(window);
    mappers.mapper->SetFinalColorLevel(level);
    mappers.onGPU->SetFinalColorWindow(window);
    mappers.onGPU->SetFinalColorLevel(level);
    mappers.fixedPoint->SetFinalColorWindow(window);
    mappers.fixedPoint->SetFinalColorLevel(level);
  };
  setFinalColor(1.6f, 0.3f);
  mappers.ExpectSame(checks, "final color window and level");
  setFinalColor(1.0f, 0.5f);

  mappers.mapper->SetImageSampleDistance(3.0f);
  mappers.fixedPoint->SetImageSampleDistance(3.0f);
  mappers.ExpectSameAs(checks, mappers.fixedPoint, "a ray in three by three pixels", 33.0);
  mappers.mapper->SetImageSampleDistance(1.0f);
  mappers.fixedPoint->SetImageSampleDistance(1.0f);

  mappers.renderer->GetActiveCamera()->ParallelProjectionOn();
  mappers.renderer->ResetCamera();
  mappers.ExpectSame(checks, "parallel projection");
  mappers.renderer->GetActiveCamera()->ParallelProjectionOff();
  mappers.ShowBall();

  // Geometry in the middle of it, opaque and translucent.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(9.0, 10.0, 15.0);
  sphere->SetRadius(0.2 * Cells);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  vtkNew<vtkPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(sphereMapper);
  actor->GetProperty()->SetColor(0.1, 0.9, 0.3);
  mappers.renderer->AddActor(actor);
  mappers.ExpectSame(checks, "opaque geometry within");
  actor->GetProperty()->SetOpacity(0.6);
  mappers.renderer->SetUseDepthPeeling(true);
  mappers.renderer->SetUseDepthPeelingForVolumes(true);
  mappers.ExpectSameAsOnGPU(checks, "translucent geometry within");
}
}

int SettingsLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  checkFunctions(checks);
  checkNearest(checks);
  checkPictures(checks);
  return checks.Status();
}
