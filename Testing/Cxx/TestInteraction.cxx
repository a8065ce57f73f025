// SPDX-License-Identifier: BSD-3-Clause
// While something moves, a picture has fewer rays, and is filled in between them, but not across
// edges of geometry; when it stands still it is whole again.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace
{
constexpr double Still = 0.0001; // a window's desired update rate while nothing moves
constexpr double Hasty = 1e6;    // a rate at which nothing is coarse enough

// A square from (0, 0) to (x, 8) at a height.
vtkSmartPointer<vtkActor> makeSquare(double x, double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, z);
  plane->SetPoint1(x, 0.0, z);
  plane->SetPoint2(0.0, 8.0, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

double bowl(double x, double y, double z)
{
  return std::sqrt((x - 4.0) * (x - 4.0) + (y - 4.0) * (y - 4.0) + (z - 4.0) * (z - 4.0));
}
}

int TestInteraction(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(test::makeAMR(test::cornerRefined(), bowl), 100);
  test::setRamp(stage.Property(), 1.0, 7.0);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  vtkRenderWindow* window = stage.window;
  const test::Picture whole(window);
  checks.Equal(mapper->GetUsedImageSampleDistance(), 1.0, "a ray for each pixel");

  // As many rays as are asked for.
  for (const auto& [distance, least] : { std::pair{ 2.0f, 55.0 }, { 4.0f, 50.0 }, { 3.7f, 50.0 } })
  {
    mapper->SetImageSampleDistance(distance);
    const double decibel = test::Picture(window).Decibel(whole);
    std::cout << "a ray in " << distance << " x " << distance << " pixels: " << decibel << " dB\n";
    checks.Expect(decibel > least, "filled in between rays");
    checks.Equal(mapper->GetUsedImageSampleDistance(), distance, "distance of rays");
  }

  // A square in front hides the volume up to its edge, within pixels of four by four.
  mapper->SetImageSampleDistance(4.0f);
  const auto square = makeSquare(3.5, 10.0);
  stage.renderer->AddActor(square);
  stage.renderer->ResetCameraClippingRange();
  {
    const test::Picture picture(window);
    bool allRed = true;
    for (int x = 0; x < 43; ++x)
    {
      allRed = allRed && picture.At(x, 50) == test::Picture::Color{ 1.0, 0.0, 0.0 };
    }
    checks.Expect(allRed, "nothing of the volume shows on the square");
    checks.Expect(picture.At(45, 50)[2] > 0.1, "the volume shows beside it");
    mapper->SetImageSampleDistance(1.0f);
    checks.Expect(picture.Decibel(test::Picture(window)) > 38.0, "with geometry");
  }

  // With translucent geometry in it, each layer has as few rays.
  square->GetProperty()->SetOpacity(0.5);
  square->SetPosition(0.0, 0.0, -6.0);
  stage.renderer->SetUseDepthPeeling(true);
  stage.renderer->SetUseDepthPeelingForVolumes(true);
  {
    const test::Picture full(window);
    mapper->SetImageSampleDistance(4.0f);
    const double decibel = test::Picture(window).Decibel(full);
    std::cout << "with translucent geometry: " << decibel << " dB\n";
    checks.Expect(decibel > 44.0, "with translucent geometry");
    mapper->SetImageSampleDistance(8.0f);
    window->Render();
    mapper->SetImageSampleDistance(1.0f);
    checks.Equal(test::Picture(window).Difference(full), 0.0,
      "all passes of a whole picture are whole, whatever was drawn before");
  }
  stage.renderer->SetUseDepthPeeling(false);
  stage.renderer->RemoveActor(square);

  // As many as the time allows, while the window is to be drawn often.
  window->SetDesiredUpdateRate(Hasty);
  test::Picture hasty(window);
  checks.Equal(mapper->GetUsedImageSampleDistance(), 10.0, "no more than the greatest distance");
  checks.Equal(mapper->GetUsedStepGrowth(), 4.0, "then steps grow");
  checks.Expect(hasty.Decibel(whole) > 20.0, "still the same to look at");
  mapper->SetMaximumImageSampleDistance(5.0f);
  window->Render();
  checks.Equal(mapper->GetUsedImageSampleDistance(), 5.0, "another greatest distance");
  window->SetDesiredUpdateRate(1.5);
  window->Render();
  checks.Equal(mapper->GetUsedStepGrowth(), 1.0, "there is time enough");

  // Within a tolerance, levels and steps are those of the last whole picture.
  mapper->SetErrorTolerance(0.01);
  window->SetDesiredUpdateRate(Still);
  const test::Picture tolerant(window);
  window->SetDesiredUpdateRate(Hasty);
  checks.Expect(test::Picture(window).Decibel(tolerant) > 20.0, "within a tolerance, in a hurry");
  checks.Equal(mapper->GetUsedImageSampleDistance(), 5.0, "within a tolerance");
  window->SetDesiredUpdateRate(Still);
  checks.Equal(test::Picture(window).Difference(tolerant), 0.0, "the tolerance again");
  mapper->SetErrorTolerance(0.0);

  // What stands still is the same bits, whatever was drawn before.
  checks.Equal(test::Picture(window).Difference(whole), 0.0, "still");
  checks.Equal(mapper->GetUsedImageSampleDistance(), 1.0, "still, a ray for each pixel");

  // Who adjusts them: from a rate on, always, or never.
  window->SetDesiredUpdateRate(Hasty);
  mapper->SetInteractiveUpdateRate(10.0 * Hasty);
  checks.Equal(test::Picture(window).Difference(whole), 0.0, "below the interactive rate");
  mapper->SetInteractiveUpdateRate(1.0);
  mapper->InteractiveAdjustSampleDistancesOff();
  window->Render();
  checks.Equal(mapper->GetUsedImageSampleDistance(), 5.0, "always");
  mapper->AutoAdjustSampleDistancesOff();
  checks.Equal(test::Picture(window).Difference(whole), 0.0, "never");

  // Where cells lie closer together than rays, their level is left out, once it was made without
  // it; the still picture has all levels.
  test::Stage far(test::makeAMR(test::cornerRefined(), bowl), 100);
  test::setRamp(far.Property(), 1.0, 7.0);
  test::lookAlongZ(far.renderer, 4.0, 4.0, 4.0, 100.0); // half a pixel for a fine cell
  far.mapper->SetMaximumImageSampleDistance(3.0f);
  const test::Picture still(far.window);
  checks.Equal(far.mapper->GetLevelsLeftOut(), 0, "all levels, still");
  far.window->SetDesiredUpdateRate(Hasty);
  for (int i = 0; i < 1000 && far.mapper->GetLevelsLeftOut() == 0; ++i)
  {
    far.window->Render();
  }
  checks.Equal(far.mapper->GetLevelsLeftOut(), 1, "levels left out while it moves");
  checks.Expect(test::Picture(far.window).Decibel(still) > 15.0, "without a level, in a hurry");
  far.window->SetDesiredUpdateRate(Still);
  checks.Equal(test::Picture(far.window).Difference(still), 0.0, "still again");
  checks.Equal(far.mapper->GetLevelsLeftOut(), 0, "all levels, still again");
  // Other values are not those that were made without the level.
  far.window->SetDesiredUpdateRate(Hasty);
  far.mapper->SetInputDataObject(test::makeAMR(test::cornerRefined(), test::constant(6.9)));
  for (int i = 0; i < 1000 && (i < 3 || far.mapper->GetLevelsLeftOut() == 0); ++i)
  {
    checks.Expect(test::Picture(far.window).Center()[0] > 0.5, "other values are red");
  }
  checks.Equal(far.mapper->GetLevelsLeftOut(), 1, "levels left out of other values");
  // Cells are shown as they are by the nearest reconstruction.
  far.mapper->SetReconstructionToNearest();
  for (int i = 0; i < 20; ++i)
  {
    far.window->Render();
    checks.Equal(far.mapper->GetLevelsLeftOut(), 0, "nearest");
  }
  far.mapper->SetReconstructionToBasis();
  far.mapper->SetInputDataObject(test::makeAMR(test::cornerRefined(), bowl));
  // With the eye among the cells, those before it are large.
  far.renderer->GetActiveCamera()->ParallelProjectionOff();
  far.renderer->GetActiveCamera()->SetPosition(4.0, 4.0, 6.0);
  far.renderer->ResetCameraClippingRange();
  for (int i = 0; i < 20; ++i)
  {
    far.window->Render();
    checks.Equal(far.mapper->GetLevelsLeftOut(), 0, "from within");
  }

  checks.Silent(messages.TakeErrors(), "nothing to say");
  checks.Silent(messages.TakeWarnings(), "nothing to say");
  return checks.Status();
}
