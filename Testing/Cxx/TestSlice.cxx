// SPDX-License-Identifier: BSD-3-Clause
// Blend mode slice: a plane through two levels has the colours and opacities of the values there,
// exactly at the plane, in the world, cut by opaque geometry, clipping planes and cropping.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkPlane.h"
#include "vtkProperty.h"
#include "vtkSphere.h"
#include "vtkTransform.h"

namespace
{
constexpr int Size = 80; // pixels for a width of 8

double field(double x, double y, double z) { return 0.05 * x + 0.02 * y + 0.07 * z; }

// Grey as the value, and half opaque.
void setGrey(vtkVolumeProperty* property)
{
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
  property->GetScalarOpacity()->AddPoint(0.0, 0.5);
}

double middle(int pixel) { return (pixel + 0.5) * 8.0 / Size; }
}

int TestSlice(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(test::makeAMR(test::cornerRefined(), field), Size);
  setGrey(stage.Property());
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  mapper->SetReconstructionToCompleted(); // has linear fields exactly, across levels
  mapper->SetBlendModeToSlice();
  stage.Property()->SetScalarOpacityUnitDistance(17.0); // of no importance to a slice

  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "no slice function draws nothing");
  checks.Says(messages.TakeErrors(), { "vtkPlane", "found none", "SetSliceFunction" }, "none");
  vtkNew<vtkSphere> sphere;
  stage.Property()->SetSliceFunction(sphere);
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "vtkPlane", "vtkSphere" }, "a sphere");

  // z = 4 + 0.3 (x - 4) - 0.2 (y - 4)
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(4.0, 4.0, 4.0);
  plane->SetNormal(-0.3, 0.2, 1.0);
  stage.Property()->SetSliceFunction(plane);
  const auto expects = [&](const test::Picture& picture, double moved, const std::string& what)
  {
    // A cell from the bounds on the field is linear.
    for (int y = 12; y < Size - 12; y += 7)
    {
      for (int x = 12; x < Size - 12; x += 7)
      {
        const double px = middle(x);
        const double py = middle(y);
        const double pz = 4.0 + 0.3 * (px - 4.0) - 0.2 * (py - 4.0) - moved;
        checks.Near(picture.At(x, y)[1], 0.5 * field(px, py, pz), test::OneStep, what);
      }
    }
  };
  expects(test::Picture(stage.window), 0.0, "a slice");

  // Lit by the gradient, and less opaque by it; the field has the same one everywhere.
  const test::Picture flat(stage.window);
  stage.Property()->ShadeOn();
  stage.Property()->SetAmbient(0.3);
  stage.Property()->SetDiffuse(0.5);
  stage.Property()->SetSpecular(0.0);
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.0, 0.8);
  stage.Property()->SetGradientOpacity(byGradient);
  const test::Picture lit(stage.window);
  stage.Property()->SetGradientOpacity(nullptr);
  stage.Property()->ShadeOff();
  for (int place = 12; place < Size - 12; place += 7)
  {
    const double towardsLight = 0.07 / std::hypot(0.05, 0.02, 0.07);
    checks.Near(lit.At(place, 30)[1], (0.3 + 0.5 * towardsLight) * 0.8 * flat.At(place, 30)[1],
      test::OneStep, "lit");
  }

  // The plane lies in the world, and the volume moves under it.
  vtkNew<vtkTransform> transform;
  transform->Translate(0.0, 0.0, 1.0);
  stage.volume->SetUserTransform(transform);
  expects(test::Picture(stage.window), 1.0, "a slice of a moved volume");
  stage.volume->SetUserTransform(nullptr);

  // Cells as they are.
  mapper->SetReconstructionToNearest();
  const test::Picture cells(stage.window);
  checks.Near(cells.At(65, 65)[1], 0.5 * field(6.5, 6.5, 4.5), test::OneStep, "a cell");
  checks.Near(cells.At(22, 32)[1], 0.5 * field(2.25, 3.25, 3.75), test::OneStep, "a fine cell");
  mapper->SetReconstructionToBasis();
  checks.Near(test::Picture(stage.window).At(65, 65)[1], 0.5 * field(6.55, 6.55, 4.255),
    test::OneStep, "the basis within a level");
  mapper->SetErrorTolerance(0.01);
  checks.Near(test::Picture(stage.window).At(65, 65)[1], 0.5 * field(6.55, 6.55, 4.255), 0.01,
    "the basis by tolerance");
  mapper->SetErrorTolerance(0.0);
  mapper->SetReconstructionToCompleted();

  // What hides or cuts it. In one half a cube before it, in the other one behind it.
  const test::Picture whole(stage.window);
  const auto actor = test::addBox(stage.renderer, 0.0, 4.0, 0.0, 8.0, 6.0, 7.0);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  const test::Picture hidden(stage.window);
  checks.Near(hidden.At(20, 40)[1], 0.0, test::OneStep, "hidden by geometry");
  checks.Near(hidden.At(60, 40)[1], whole.At(60, 40)[1], test::OneStep, "beside geometry");
  stage.renderer->RemoveActor(actor);
  vtkNew<vtkPlane> clip;
  clip->SetOrigin(4.0, 0.0, 0.0);
  clip->SetNormal(1.0, 0.0, 0.0);
  mapper->AddClippingPlane(clip);
  const test::Picture clipped(stage.window);
  checks.Equal(clipped.At(20, 40)[1], 0.0, "clipped");
  checks.Equal(clipped.At(60, 40)[1], whole.At(60, 40)[1], "not clipped");
  mapper->RemoveAllClippingPlanes();

  // Along a ray, and beside the volume, it is not seen.
  plane->SetNormal(1.0, 0.0, 0.0);
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "a slice along the rays");
  plane->SetNormal(0.0, 0.0, 1.0);
  plane->SetOrigin(0.0, 0.0, 9.0);
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "a slice beside the volume");
  plane->SetNormal(0.0, 0.0, 0.0);
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "normal", "not 0" }, "no normal");
  checks.Silent(messages.TakeWarnings(), "no warnings");
  return checks.Status();
}
