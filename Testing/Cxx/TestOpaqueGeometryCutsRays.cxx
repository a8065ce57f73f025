// SPDX-License-Identifier: BSD-3-Clause
// Opaque geometry hides what of the volume is behind it: rays end at its depth, so that a plane in
// the middle leaves half the length.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkSphereSource.h"

namespace
{
constexpr double Unit = 8.0; // all through the cube: opacity 0.5
constexpr double Opacity = 0.5;

// A red square across the left half of the view, at height z.
void setPlane(vtkPlaneSource* plane, double z)
{
  plane->SetOrigin(-1.0, -1.0, z);
  plane->SetPoint1(4.0, -1.0, z);
  plane->SetPoint2(-1.0, 9.0, z);
}
}

int TestOpaqueGeometryCutsRays(int argc, char* argv[])
{
  test::Checks checks;
  test::Stage stage(test::makeAMR(test::cornerRefined(), test::constant(3.0)), 200);
  test::setConstantColor(stage.Property(), Opacity, { 0.0, 1.0, 0.0 });
  stage.Property()->SetScalarOpacityUnitDistance(Unit);

  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> planeMapper;
  planeMapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(planeMapper);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  stage.renderer->AddActor(actor);
  setPlane(plane, 4.0);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);

  // The volume reaches from 0 to 8 along the rays, which come from above.
  for (const bool perspective : { false, true })
  {
    vtkCamera* camera = stage.renderer->GetActiveCamera();
    camera->SetParallelProjection(!perspective);
    camera->SetPosition(4.0, 4.0, perspective ? 4000.0 : 84.0); // rays are parallel from afar too
    camera->SetViewAngle(perspective ? 0.115 : 30.0);
    for (const double z : { -1.0, 0.5, 4.0, 6.5, 9.0 })
    {
      setPlane(plane, z);
      stage.renderer->ResetCameraClippingRange();
      const test::Picture picture(stage.window);
      const double length = std::min(8.0, std::max(0.0, 8.0 - z));
      const double green = test::opacityOf(Opacity, length, Unit);
      const std::string where = " with the plane at " + std::to_string(z);
      // The depth buffer has 24 bits: between near and far planes that is less than a colour's
      // step.
      checks.Near(picture.At(50, 100)[1], green, 1.5 * test::OneStep, "green" + where);
      checks.Near(picture.At(50, 100)[0], 1.0 - green, 1.5 * test::OneStep, "red" + where);
      checks.Near(picture.At(150, 100)[1], Opacity, test::OneStep, "green beside it" + where);
      checks.Near(picture.At(150, 100)[0], 0.0, test::OneStep, "red beside it" + where);
    }
  }

  // A sphere inside, a plane behind and a ball in front, seen from the side.
  setPlane(plane, -1.0);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(5.0, 4.0, 4.0);
  sphere->SetRadius(3.0);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> inside;
  inside->SetMapper(sphereMapper);
  vtkNew<vtkActor> inFront;
  inFront->SetMapper(sphereMapper);
  inFront->SetScale(0.3);
  inFront->SetPosition(8.0, 1.0, 10.0);
  stage.renderer->AddActor(inside);
  stage.renderer->AddActor(inFront);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->SetViewAngle(30.0);
  camera->SetPosition(14.0, -6.0, 26.0);
  stage.renderer->ResetCamera();
  camera->Zoom(1.5);
  const int image = vtkRegressionTestImage(stage.window);
  return image == vtkTesting::FAILED ? EXIT_FAILURE : checks.Status();
}
