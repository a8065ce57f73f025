// SPDX-License-Identifier: BSD-3-Clause
// Samples at equal distances, in the data's own coordinates, in place of steps that follow the
// cells.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkTransform.h"

int TestSampleDistance(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  const auto field = [](double x, double y, double z)
  { return std::sin(0.11 * x) * std::cos(0.17 * y) + 0.01 * z; };
  test::Lattice lattice;
  lattice.spacing = { 10.0, 10.0, 10.0 };
  const auto looksAt = [&](test::Stage& stage)
  {
    test::setRamp(stage.Property(), -1.0, 1.6);
    stage.Property()->SetScalarOpacityUnitDistance(30.0);
    test::lookAlongZ(stage.renderer, 40.0, 40.0, 40.0, 80.0);
    stage.renderer->ResetCameraClippingRange();
  };

  // On one level it is the spacing times the step scale.
  test::Stage level(test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 8, 8 } } }, field, lattice), 40);
  looksAt(level);
  for (const double scale : { 0.3, 1.0, 2.0 })
  {
    level.mapper->SetSampleDistance(0.0);
    level.mapper->SetStepScale(scale);
    const test::Picture byScale(level.window);
    level.mapper->SetStepScale(1.0);
    level.mapper->SetSampleDistance(10.0 * scale);
    checks.Expect(test::Picture(level.window).Difference(byScale) <= test::OneStep,
      "distance of " + std::to_string(scale) + " cells");
  }

  // On two levels fine cells are sampled as seldom as coarse ones, and both as often as is asked.
  test::Stage levels(test::makeAMR(test::cornerRefined(), field, lattice), 40);
  looksAt(levels);
  levels.mapper->SetStepScale(0.05);
  const test::Picture truth(levels.window);
  double last = 20.0;
  for (const double distance : { 20.0, 5.0, 1.25 })
  {
    levels.mapper->SetSampleDistance(distance);
    const double decibel = test::Picture(levels.window).Decibel(truth);
    std::cout << "distance " << distance << ": " << decibel << " dB\n";
    checks.Expect(decibel >= last, "nearer with a distance of " + std::to_string(distance));
    last = decibel;
  }
  checks.Expect(last > 50.0, "near with small distances");

  // A tolerance chooses by itself.
  levels.mapper->SetSampleDistance(0.0);
  levels.mapper->SetErrorTolerance(0.003);
  const test::Picture byTolerance(levels.window);
  levels.mapper->SetSampleDistance(20.0);
  checks.Equal(test::Picture(levels.window).Difference(byTolerance), 0.0, "by tolerance");
  levels.mapper->SetErrorTolerance(0.0);
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");
  levels.mapper->SetSampleDistance(std::nan(""));
  test::Picture(levels.window);
  checks.Says(messages.TakeErrors(), { "SampleDistance", "nan" }, "no number");
  levels.mapper->SetSampleDistance(-3.0);
  checks.Equal(levels.mapper->GetSampleDistance(), 0.0, "least distance");
  return checks.Status();
}
