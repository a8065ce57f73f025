// SPDX-License-Identifier: BSD-3-Clause
// The camera may stand inside the volume, and look in parallel or in perspective: rays start at its
// near plane.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkRegressionTestImage.h"

int TestCameraInside(int argc, char* argv[])
{
  test::Checks checks;
  constexpr double opacity = 0.2;
  auto amr = test::makeAMR(test::cornerRefined(), test::constant(-7.0));
  test::Stage stage(amr, 200);
  test::setConstantColor(stage.Property(), opacity);
  vtkCamera* camera = stage.renderer->GetActiveCamera();

  // In the middle of a pixel the ray is (almost) the axis: what is left is the length to z = 0.
  for (const bool parallel : { false, true })
  {
    for (const double z : { 2.0, 5.0, 7.0 })
    {
      const double near = 0.1;
      camera->SetParallelProjection(parallel);
      camera->SetParallelScale(2.0);
      camera->SetPosition(4.0, 4.0, z);
      camera->SetFocalPoint(4.0, 4.0, 0.0);
      camera->SetClippingRange(near, 20.0);
      const double expected = test::opacityOf(opacity, z - near);
      checks.Near(test::Picture(stage.window).Center()[0], expected, 1.5 * test::OneStep,
        "opacity from z = " + std::to_string(z) + (parallel ? ", parallel" : ", perspective"));
    }
  }

  // The far plane cuts too.
  camera->SetParallelProjection(true);
  camera->SetPosition(4.0, 4.0, 7.0);
  camera->SetClippingRange(1.0, 4.0);
  checks.Near(test::Picture(stage.window).Center()[0], test::opacityOf(opacity, 3.0), test::OneStep,
    "opacity between near and far plane");

  // Perspective rays off the middle are longer: at 45 degrees by the square root of 2.
  camera->SetParallelProjection(false);
  camera->SetViewAngle(90.0);
  camera->SetPosition(4.0, 4.0, 3.0);
  camera->SetClippingRange(1e-3, 20.0);
  const double distance = 3.0 * std::sqrt(1.0 + std::pow(2.0 * 199.5 / 200.0 - 1.0, 2));
  checks.Near(test::Picture(stage.window).At(199, 100)[0], test::opacityOf(opacity, distance),
    1.5 * test::OneStep, "opacity of a slanted ray");

  // For the eye: shells around the middle, seen from between two of them.
  stage.mapper->SetInputData(
    test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 8, 8 } }, { 1, { 0, 0, 0 }, { 16, 16, 8 } } },
      [](double x, double y, double z) { return std::hypot(x - 4.0, y - 4.0, z - 4.0); }));
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(1.0, 1.0, 0.1, 0.0);
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(5.0, 0.0, 0.4, 1.0);
  vtkPiecewiseFunction* shells = stage.Property()->GetScalarOpacity();
  shells->RemoveAllPoints();
  for (const double radius : { 1.5, 3.5, 5.5 })
  {
    shells->AddPoint(radius - 0.6, 0.0);
    shells->AddPoint(radius, 0.6);
    shells->AddPoint(radius + 0.6, 0.0);
  }
  camera->SetPosition(4.0, 1.5, 4.5);
  camera->SetFocalPoint(4.0, 4.0, 4.0);
  camera->SetClippingRange(0.01, 20.0);
  const int image = vtkRegressionTestImage(stage.window);
  return image == vtkTesting::FAILED ? EXIT_FAILURE : checks.Status();
}
