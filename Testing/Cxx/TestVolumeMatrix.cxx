// SPDX-License-Identifier: BSD-3-Clause
// A volume that is moved, turned and scaled looks as to a camera that is moved the other way. The
// opacity unit distance is a length in the data's own coordinates, as in VTK's mappers: scale does
// not change how opaque the volume is.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

namespace
{
// The cube of test::cornerRefined() of one value, for VTK's own mappers.
vtkSmartPointer<vtkImageData> makeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 9, 9);
  image->AllocateScalars(VTK_FLOAT, 1);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  values->Fill(1.0);
  values->SetComponent(0, 0, 0.0); // VTK's mappers want a range
  return image;
}

double ball(double x, double y, double z) { return std::hypot(x - 3.0, y - 4.0, z - 5.0); }

// A ball off the middle, its rim bluer.
void showBall(vtkVolumeProperty* property)
{
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 0.8, 0.2);
  property->GetRGBTransferFunction()->AddRGBPoint(4.0, 0.0, 0.2, 1.0);
  property->GetScalarOpacity()->AddPoint(0.0, 0.6);
  property->GetScalarOpacity()->AddPoint(4.0, 0.0);
}

void placeCamera(vtkRenderer* renderer, vtkTransform* toWorld)
{
  const double eye[3] = { 16.0, -12.0, 22.0 };
  const double middle[3] = { 4.0, 4.0, 4.0 };
  double up[3] = { 0.0, 1.0, 0.0 };
  double position[3];
  double focus[3];
  toWorld->TransformPoint(eye, position);
  toWorld->TransformPoint(middle, focus);
  toWorld->TransformVector(up, up);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(up);
  const double distance = camera->GetDistance();
  camera->SetClippingRange(0.1 * distance, 3.0 * distance);
}
}

int TestVolumeMatrix(int, char*[])
{
  test::Checks checks;
  auto amr = test::makeAMR(test::cornerRefined(), ball);
  test::Stage stage(amr);
  showBall(stage.Property());
  vtkNew<vtkTransform> transform;
  placeCamera(stage.renderer, transform);
  const test::Picture still(stage.window);
  checks.Expect(still.Coverage() > 0.1 && still.Coverage() < 0.9, "the ball is in the picture");

  // Rigid: by the volume's own place and orientation, and by a matrix.
  transform->Translate(30.0, -20.0, 5.0);
  transform->RotateWXYZ(70.0, 1.0, 2.0, 3.0);
  placeCamera(stage.renderer, transform);
  stage.volume->SetUserMatrix(transform->GetMatrix());
  checks.Expect(still.Difference(test::Picture(stage.window)) <= test::OneStep, "user matrix");
  stage.volume->SetUserMatrix(nullptr);
  stage.volume->SetPosition(transform->GetPosition());
  stage.volume->SetOrientation(transform->GetOrientation());
  checks.Expect(
    still.Difference(test::Picture(stage.window)) <= test::OneStep, "position and orientation");

  // Three times as large, seen from three times as far.
  stage.volume->SetPosition(0.0, 0.0, 0.0);
  stage.volume->SetOrientation(0.0, 0.0, 0.0);
  stage.volume->SetScale(3.0);
  transform->Identity();
  transform->Scale(3.0, 3.0, 3.0);
  placeCamera(stage.renderer, transform);
  checks.Expect(still.Difference(test::Picture(stage.window)) <= test::OneStep, "scale");

  // By closed form, and beside VTK's mappers: stretched along the rays only, and turned around.
  test::Stage block(test::makeAMR(test::cornerRefined(), test::constant(1.0)));
  test::setConstantColor(block.Property(), 0.05);
  block.Property()->SetScalarOpacityUnitDistance(0.5);
  const auto image = makeImage();
  vtkNew<vtkFixedPointVolumeRayCastMapper> fixedPoint;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> onGPU;
  for (vtkVolumeMapper* peer :
    { static_cast<vtkVolumeMapper*>(fixedPoint), static_cast<vtkVolumeMapper*>(onGPU) })
  {
    peer->SetInputDataObject(image);
  }
  for (const double stretch : { 0.25, 1.0, 5.0, -5.0 })
  {
    block.volume->SetScale(1.0, 1.0, stretch);
    test::lookAlongZ(block.renderer, 4.0, 4.0, 4.0 * stretch, 8.0);
    block.renderer->GetActiveCamera()->SetPosition(4.0, 4.0, 100.0);
    block.renderer->ResetCameraClippingRange();
    const std::string what = "opacity at stretch " + std::to_string(stretch);
    const double expected = test::opacityOf(0.05, 8.0, 0.5);
    checks.Near(test::Picture(block.window).Center()[0], expected, test::OneStep, what);
    for (vtkVolumeMapper* peer :
      { static_cast<vtkVolumeMapper*>(fixedPoint), static_cast<vtkVolumeMapper*>(onGPU) })
    {
      if (stretch < 0.0 && peer == onGPU)
      {
        continue; // it does not draw a mirrored volume right
      }
      block.volume->SetMapper(peer);
      checks.Near(test::Picture(block.window).Center()[0], expected, 0.03,
        what + ", by " + peer->GetClassName());
    }
    block.volume->SetMapper(block.mapper);
  }
  return checks.Status();
}
