// SPDX-License-Identifier: BSD-3-Clause
// Jittering: what long steps leave out is noise, the same in each picture, in place of bands.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

namespace
{
// How alike the errors of pixels side by side are: 1 as the same, 0 as by chance.
double correlation(const test::Picture& picture, const test::Picture& truth)
{
  double products = 0.0;
  double squares = 0.0;
  for (int y = 0; y < picture.GetHeight(); ++y)
  {
    for (int x = 0; x + 1 < picture.GetWidth(); ++x)
    {
      const double here = picture.At(x, y)[0] - truth.At(x, y)[0];
      const double beside = picture.At(x + 1, y)[0] - truth.At(x + 1, y)[0];
      products += here * beside;
      squares += 0.5 * (here * here + beside * beside);
    }
  }
  return products / squares;
}
}

int TestJittering(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  test::Stage stage(
    test::makeAMR({ { 0, { 0, 0, 0 }, { 32, 32, 32 } } },
      [](double x, double y, double z) { return std::sin(0.6 * x) * std::cos(0.5 * y + 0.3 * z); }),
    60);
  test::setRamp(stage.Property(), -1.0, 1.0);
  stage.Property()->SetScalarOpacityUnitDistance(16.0);
  test::lookAlongZ(stage.renderer, 16.0, 16.0, 16.0, 32.0);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  mapper->SetStepScale(0.1);
  const test::Picture truth(stage.window);
  mapper->SetStepScale(4.0);
  const test::Picture plain(stage.window);
  mapper->UseJitteringOn();
  const test::Picture jittered(stage.window);

  const double before = correlation(plain, truth);
  const double after = correlation(jittered, truth);
  std::cout << "alike side by side: " << before << ", jittered " << after << "; "
            << plain.Decibel(truth) << " dB, jittered " << jittered.Decibel(truth) << " dB\n";
  checks.Expect(before > 0.8, "errors are bands");
  checks.Expect(after < 0.7 * before, "jittered errors are noise"); // but for what all steps lack
  checks.Expect(jittered.Decibel(truth) > plain.Decibel(truth) - 0.5, "and no greater");
  checks.Equal(test::Picture(stage.window).Difference(jittered), 0.0, "the same again");
  mapper->SetStepScale(0.1);
  checks.Expect(
    test::Picture(stage.window).Decibel(truth) > 50.0, "with short steps it is the same");
  mapper->SetStepScale(4.0);
  mapper->UseJitteringOff();
  checks.Equal(test::Picture(stage.window).Difference(plain), 0.0, "switched off");

  // Cells are exact, jittered or not; a maximum is found all the same.
  mapper->SetReconstructionToNearest();
  const test::Picture cells(stage.window);
  mapper->UseJitteringOn();
  checks.Equal(test::Picture(stage.window).Difference(cells), 0.0, "nearest");
  mapper->SetReconstructionToBasis();
  mapper->SetBlendModeToMaximumIntensity();
  mapper->SetStepScale(0.25);
  const test::Picture maximum(stage.window);
  mapper->UseJitteringOff();
  checks.Expect(test::Picture(stage.window).Decibel(maximum) > 40.0, "maximum");
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");
  return checks.Status();
}
