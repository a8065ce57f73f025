// SPDX-License-Identifier: BSD-3-Clause
// A screenshot larger than the window is drawn in tiles: no seams, and with an error tolerance one
// choice of levels and steps for all tiles, that of the same picture in one piece. A still picture
// does not change, whatever was drawn meanwhile.

#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksSceneSource.h"
#include "vtkImageData.h"
#include "vtkTransform.h"
#include "vtkWindowToImageFilter.h"

namespace
{
constexpr int Small = 64;
constexpr int Scale = 3;

// The greatest difference in any channel between a window's picture and one that is drawn in tiles.
double differenceOfTiles(vtkRenderWindow* window, const test::Picture& whole)
{
  vtkNew<vtkWindowToImageFilter> tiles;
  tiles->SetInput(window);
  tiles->SetScale(Scale);
  tiles->ReadFrontBufferOff();
  tiles->Update();
  vtkImageData* image = tiles->GetOutput();
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (dimensions[0] != whole.GetWidth() || dimensions[1] != whole.GetHeight())
  {
    return 1.0;
  }
  double most = 0.0;
  for (int y = 0; y < dimensions[1]; ++y)
  {
    for (int x = 0; x < dimensions[0]; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        most = std::max(most, std::abs(*bytes++ - whole.At(x, y)[c] / test::OneStep));
      }
    }
  }
  // A whole number of steps, but for rounding.
  return std::round(most) * test::OneStep;
}
}

int TestLargeScreenshots(int, char*[])
{
  test::Checks checks;
  const test::KeepDisplay display;
  vtkNew<vtkExaBricksSceneSource> source;
  source->SetSceneToCloud();
  source->SetNumberOfLeafCells(20000);
  // The same scene in a small window and in a large one.
  test::Stage small(Small);
  test::Stage large(Small * Scale);
  vtkNew<vtkTransform> turned;
  turned->RotateWXYZ(50.0, 0.2, 1.0, 0.3);
  for (test::Stage* stage : { &small, &large })
  {
    stage->mapper->SetInputConnection(source->GetOutputPort());
    stage->mapper->SelectScalarArray("value");
    source->InitializeProperty(stage->Property());
    source->InitializeCamera(stage->renderer->GetActiveCamera());
    stage->renderer->GetActiveCamera()->SetModelTransformMatrix(turned->GetMatrix());
    stage->renderer->ResetCameraClippingRange();
  }
  for (const double tolerance : { 0.0, 0.03 })
  {
    for (const bool stereo : { false, true })
    {
      for (test::Stage* stage : { &small, &large })
      {
        stage->mapper->SetErrorTolerance(tolerance);
        stage->window->SetStereoTypeToRight();
        stage->window->SetStereoRender(stereo);
      }
      const std::string what =
        "tolerance " + std::to_string(tolerance) + (stereo ? ", stereo" : "");
      const test::Picture whole(large.window);
      checks.Expect(whole.Coverage() > 0.1, "something is drawn, " + what);
      // VTK keeps the view angle of tiles in single precision: a ray may get an interval more.
      checks.Near(differenceOfTiles(small.window, whole), 0.0,
        (tolerance > 0.0 ? 2.5 : 1.0) * test::OneStep, "tiles, " + what);
      checks.Equal(small.mapper->GetLevelsLeftOut(), large.mapper->GetLevelsLeftOut(),
        "levels left out, " + what);

      // Still, and the same after something else.
      const test::Picture still(large.window);
      checks.Equal(still.Difference(whole), 0.0, "still, " + what);
      large.renderer->GetActiveCamera()->Zoom(0.3);
      large.mapper->SetErrorTolerance(0.1);
      test::Picture(large.window);
      large.renderer->GetActiveCamera()->Zoom(1.0 / 0.3);
      large.mapper->SetErrorTolerance(tolerance);
      checks.Near(test::Picture(large.window).Difference(whole), 0.0, 0.0, "again, " + what);
    }
  }
  return checks.Status();
}
