// SPDX-License-Identifier: BSD-3-Clause
// Blend modes of vtkVolumeMapper: a ray through layers of known values and thickness has the colour
// that can be told by hand. Maximum and minimum show one value, at whatever length; average and
// additive are grey and opaque, as VTK's GPU mapper draws them.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkPiecewiseFunction.h"

namespace
{
constexpr double Thickness = 2.0; // of a layer
const double Values[4] = { 1.0, 4.0, 2.0, 0.0 };

// A tower of layers, each of one value, the first at the bottom.
vtkSmartPointer<vtkOverlappingAMR> makeLayers()
{
  std::vector<test::Block> blocks;
  for (int i = 0; i < 4; ++i)
  {
    blocks.push_back({ 0, { 0, 0, 2 * i }, { 2, 2, 2 } });
  }
  return test::makeAMR(blocks,
    [](double, double, double z) { return Values[static_cast<std::size_t>(z / Thickness)]; });
}

// Colour is the value's part of the range, and opacity half as much.
double partOf(double value) { return value / 4.0; }
double opacityOf(double value) { return 0.5 * partOf(value); }
}

int TestBlendModes(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(makeLayers(), 20);
  vtkVolumeProperty* property = stage.Property();
  property->GetRGBTransferFunction()->RemoveAllPoints();
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(4.0, 1.0, 0.0, 0.0);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  property->GetScalarOpacity()->AddPoint(4.0, 0.5);
  property->SetScalarOpacityUnitDistance(8.0);
  stage.mapper->SetReconstructionToNearest(); // the layers' values alone
  test::lookAlongZ(stage.renderer, 1.0, 1.0, 4.0, 2.0);

  const auto shows = [&](double red, double green, double blue, const std::string& what)
  {
    const test::Picture::Color color = test::Picture(stage.window).Center();
    checks.Near(color[0], red, test::OneStep, what + ", red");
    checks.Near(color[1], green, test::OneStep, what + ", green");
    checks.Near(color[2], blue, test::OneStep, what + ", blue");
    checks.Expect(stage.mapper->GetDrawn(), what + " is drawn");
  };

  stage.mapper->SetBlendModeToMaximumIntensity();
  shows(opacityOf(4.0) * 1.0, 0.0, 0.0, "maximum");

  // The least value is not to be seen here: its opacity is 0. In front of a white background:
  stage.mapper->SetBlendModeToMinimumIntensity();
  stage.renderer->SetBackground(1.0, 1.0, 1.0);
  shows(1.0, 1.0, 1.0, "minimum");
  property->GetScalarOpacity()->AddPoint(0.0, 0.25);
  shows(0.75, 1.0, 0.75, "minimum, seen");
  property->GetScalarOpacity()->AddPoint(0.0, 0.0);

  // Means and sums of a value's part of the range times its opacity.
  double sum = 0.0;
  for (const double value : Values)
  {
    sum += opacityOf(value) * partOf(value);
  }
  stage.mapper->SetBlendModeToAverageIntensity();
  shows(sum / 4.0, sum / 4.0, sum / 4.0, "average");
  stage.mapper->SetAverageIPScalarRange(1.0, 2.0); // both ends count
  const double some = 0.5 * (opacityOf(1.0) * partOf(1.0) + opacityOf(2.0) * partOf(2.0));
  shows(some, some, some, "average of a range");
  stage.mapper->SetAverageIPScalarRange(2.5, 3.5);
  shows(1.0, 1.0, 1.0, "average of a range that no value is in");

  stage.mapper->SetBlendModeToAdditive();
  const double added = sum * Thickness / property->GetScalarOpacityUnitDistance();
  shows(added, added, added, "additive");

  stage.renderer->SetBackground(0.0, 0.0, 0.0);
  stage.mapper->SetBlendModeToComposite();
  checks.Expect(test::Picture(stage.window).Center()[0] > 0.1, "composite again");
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");

  // An error tolerance holds in every mode.
  test::Stage smooth(
    test::makeAMR(test::cornerRefined(),
      [](double x, double y, double z) { return std::sin(x) * std::cos(1.3 * y) + 0.1 * z; }),
    50);
  test::setRamp(smooth.Property(), -1.0, 1.8);
  smooth.renderer->ResetCamera();
  for (const int mode : { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    smooth.mapper->SetBlendMode(mode);
    smooth.mapper->SetErrorTolerance(0.0);
    smooth.mapper->SetStepScale(0.125);
    const test::Picture fine(smooth.window);
    smooth.mapper->SetErrorTolerance(0.01);
    const double decibel = test::Picture(smooth.window).Decibel(fine);
    checks.Expect(decibel > 36.0,
      "mode " + std::to_string(mode) + " by tolerance: " + std::to_string(decibel) + " dB");
  }
  return checks.Status();
}
