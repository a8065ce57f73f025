// SPDX-License-Identifier: BSD-3-Clause
// Where the eye is, opaque geometry says: each eye of a stereo picture, of every kind, and a camera
// with a model transform see an opaque volume where they see a solid of the same shape, and a
// translucent one as VTK's fixed-point mapper draws it.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

#include <iostream>

namespace
{
// The cube from 0 to 8 three times: our volume, VTK's volume, and a solid.
struct Cubes
{
  test::Stage stage{ test::makeAMR(test::cornerRefined(), test::constant(1.0)), 150 };
  vtkNew<vtkFixedPointVolumeRayCastMapper> peer;
  vtkSmartPointer<vtkActor> solid{ test::addBox(stage.renderer, 0.0, 8.0, 0.0, 8.0, 0.0, 8.0) };

  Cubes()
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(33, 33, 33);
    image->SetSpacing(0.25, 0.25, 0.25);
    image->AllocateScalars(VTK_FLOAT, 1);
    image->GetPointData()->GetScalars()->Fill(1.0);
    image->GetPointData()->GetScalars()->SetComponent(0, 0, 0.0); // VTK's mappers want a range
    this->peer->SetInputData(image);
    this->solid->GetProperty()->LightingOff();
    this->solid->VisibilityOff();
    vtkCamera* camera = this->stage.renderer->GetActiveCamera();
    camera->SetPosition(20.0, 15.0, 26.0);
    camera->SetFocalPoint(4.0, 4.0, 4.0);
    camera->SetEyeAngle(8.0);
    this->stage.renderer->ResetCameraClippingRange();
  }

  test::Picture DrawSolid()
  {
    this->solid->VisibilityOn();
    this->stage.volume->VisibilityOff();
    test::Picture picture(this->stage.window);
    this->solid->VisibilityOff();
    this->stage.volume->VisibilityOn();
    return picture;
  }

  test::Picture DrawPeer()
  {
    this->stage.volume->SetMapper(this->peer);
    test::Picture picture(this->stage.window);
    this->stage.volume->SetMapper(this->stage.mapper);
    return picture;
  }
};

// Part of the pixels that differ by more than half a colour: at edges, a pixel is one or the other.
double differing(const test::Picture& a, const test::Picture& b)
{
  int count = 0;
  for (int y = 0; y < a.GetHeight(); ++y)
  {
    for (int x = 0; x < a.GetWidth(); ++x)
    {
      double most = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        most = std::max(most, std::abs(a.At(x, y)[c] - b.At(x, y)[c]));
      }
      count += most > 0.5;
    }
  }
  return static_cast<double>(count) / (a.GetWidth() * a.GetHeight());
}
}

int TestStereo(int, char*[])
{
  test::Checks checks;
  Cubes cubes;
  test::Stage& stage = cubes.stage;

  stage.window->StereoCapableWindowOn();
  // Each camera with the opaque cube, which an edge of pixels may tell apart, and a translucent
  // one.
  const auto compare = [&](const std::string& what)
  {
    test::setConstantColor(stage.Property(), 1.0);
    stage.Property()->SetScalarOpacityUnitDistance(1.0);
    const test::Picture opaque(stage.window);
    const test::Picture solid = cubes.DrawSolid();
    checks.Expect(solid.Coverage() > 0.1 && solid.Coverage() < 0.8, "the solid shows, " + what);
    const double off = differing(opaque, solid);
    checks.Expect(off <= 0.004, "beside the solid, " + what + ": " + std::to_string(off));
    test::setConstantColor(stage.Property(), 0.3, { 0.2, 0.9, 0.4 });
    stage.Property()->SetScalarOpacityUnitDistance(4.0);
    const double likeness = test::Picture(stage.window).Decibel(cubes.DrawPeer());
    checks.Expect(likeness >= 35.0,
      "beside the fixed-point mapper, " + what + ": " + std::to_string(likeness) + " dB");
    std::cout << what << ": " << 100.0 * off << " % of the pixels differ from the solid's, "
              << likeness << " dB beside the fixed-point mapper\n";
    return opaque;
  };
  const test::Picture both = compare("no stereo");

  stage.window->StereoRenderOn();
  const std::pair<int, const char*> kinds[] = { { VTK_STEREO_LEFT, "left eye" },
    { VTK_STEREO_RIGHT, "right eye" }, { VTK_STEREO_RED_BLUE, "red and blue" },
    { VTK_STEREO_ANAGLYPH, "anaglyph" }, { VTK_STEREO_INTERLACED, "interlaced" },
    { VTK_STEREO_DRESDEN, "Dresden" }, { VTK_STEREO_CHECKERBOARD, "checkerboard" },
    { VTK_STEREO_SPLITVIEWPORT_HORIZONTAL, "split viewport" } };
  for (const auto& [kind, name] : kinds)
  {
    stage.window->SetStereoType(kind);
    stage.renderer->GetActiveCamera()->Modified(); // or VTK's geometry has the last eye once more
    const test::Picture picture = compare(name);
    checks.Expect(picture.Difference(both) > 0.5, std::string("the eyes are apart, ") + name);
  }

  // With an error tolerance, both eyes have the same steps: those of the picture from between them.
  stage.mapper->SetErrorTolerance(0.01);
  compare("tolerance");
  stage.mapper->SetErrorTolerance(0.0);
  stage.window->StereoRenderOff();
  checks.Equal(compare("no stereo again").Difference(both), 0.0, "without stereo, as before");

  // The camera's model transform moves what it sees. (The fixed-point mapper does not heed it.)
  vtkNew<vtkTransform> transform;
  transform->Translate(1.0, -2.0, 0.5);
  transform->RotateWXYZ(25.0, 0.3, 1.0, 0.2);
  stage.renderer->GetActiveCamera()->SetModelTransformMatrix(transform->GetMatrix());
  test::setConstantColor(stage.Property(), 1.0);
  stage.Property()->SetScalarOpacityUnitDistance(1.0);
  const test::Picture moved(stage.window);
  checks.Expect(moved.Difference(both) > 0.5, "the model transform moves the volume");
  const double off = differing(moved, cubes.DrawSolid());
  checks.Expect(off <= 0.004, "beside the solid, model transform: " + std::to_string(off));
  return checks.Status();
}
