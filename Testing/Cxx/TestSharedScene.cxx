// SPDX-License-Identifier: BSD-3-Clause
// Several volumes in one view, several views in one window, several windows, multisampling and
// windows that change their size: all mappers of the process share one device.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkSphereSource.h"

namespace
{
// A second volume beside (or before) that of the stage.
struct Extra
{
  vtkNew<vtkExaBricksVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;

  Extra(vtkOverlappingAMR* amr, double opacity, const test::Picture::Color& color)
  {
    this->mapper->SetInputData(amr);
    this->volume->SetMapper(this->mapper);
    test::setConstantColor(this->volume->GetProperty(), opacity, color);
    this->volume->GetProperty()->SetScalarOpacityUnitDistance(8.0);
  }
};
}

int TestSharedScene(int argc, char* argv[])
{
  test::Checks checks;
  auto amr = test::makeAMR(test::cornerRefined(), test::constant(2.0));
  test::Stage stage(amr, 200);
  test::setConstantColor(stage.Property(), 0.5, { 0.0, 1.0, 0.0 });
  stage.Property()->SetScalarOpacityUnitDistance(8.0);

  // Two volumes one before the other, sorted by the renderer as it sorts volumes.
  Extra front(amr, 0.25, { 1.0, 0.0, 0.0 });
  front.volume->SetPosition(0.0, 0.0, 10.0);
  stage.renderer->AddVolume(front.volume);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 8.0, 10.0);
  const auto both = test::Picture(stage.window).Center();
  const auto of = [&](double a) { return test::opacityOf(a, 8.0, 8.0); };
  checks.Near(both[0], of(0.25), 1.5 * test::OneStep, "red of the volume in front");
  checks.Near(both[1], (1.0 - of(0.25)) * of(0.5), 1.5 * test::OneStep, "green through it");
  checks.Expect(stage.mapper->GetDeviceName() == std::string(front.mapper->GetDeviceName()),
    "both mappers render on one device");

  // Four views: each draws into its own part of the window only.
  stage.renderer->SetViewport(0.0, 0.0, 0.5, 0.5);
  vtkNew<vtkRenderer> views[3];
  const test::Picture::Color colors[3] = { { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 1.0 },
    { 1.0, 0.0, 1.0 } };
  std::vector<Extra> extras;
  extras.reserve(3);
  for (int i = 0; i < 3; ++i)
  {
    const double x = i == 1 ? 0.0 : 0.5;
    const double y = i == 0 ? 0.0 : 0.5;
    views[i]->SetViewport(x, y, x + 0.5, y + 0.5);
    stage.window->AddRenderer(views[i]);
    extras.emplace_back(amr, 0.75, colors[i]);
    views[i]->AddVolume(extras[i].volume);
    test::lookAlongZ(views[i], 4.0, 4.0, 4.0, 16.0);
  }
  const test::Picture four(stage.window);
  checks.Near(four.At(50, 50)[1], both[1], test::OneStep, "first view");
  for (int i = 0; i < 3; ++i)
  {
    const int x = i == 1 ? 0 : 100;
    const int y = i == 0 ? 0 : 100;
    const auto middle = four.At(x + 50, y + 50);
    const auto mean = four.Mean(x, y, x + 100, y + 100);
    for (int c = 0; c < 3; ++c)
    {
      checks.Near(middle[c], 0.75 * colors[i][c], test::OneStep, "view " + std::to_string(i + 1));
      // The cube fills a quarter of its view.
      checks.Near(mean[c], 0.25 * 0.75 * colors[i][c], 2.0 * test::OneStep,
        "mean of view " + std::to_string(i + 1));
    }
  }

  // Multisampling: opaque geometry inside keeps its place, whatever the number of samples.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(4.0, 4.0, 4.0);
  sphere->SetRadius(2.0);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(sphereMapper);
  ball->GetProperty()->SetColor(0.0, 0.0, 1.0);
  ball->GetProperty()->LightingOff();
  test::Stage smooth(amr);
  smooth.window->SetMultiSamples(4);
  test::setConstantColor(smooth.Property(), 0.5, { 1.0, 0.0, 0.0 });
  smooth.Property()->SetScalarOpacityUnitDistance(8.0);
  smooth.renderer->AddActor(ball);
  test::lookAlongZ(smooth.renderer, 4.0, 4.0, 4.0, 10.0);
  const test::Picture samples(smooth.window);
  checks.Near(samples.Center()[0], test::opacityOf(0.5, 2.0, 8.0), 2.0 * test::OneStep,
    "red in front of the ball, multisampled");
  checks.Near(samples.Center()[2], 1.0 - test::opacityOf(0.5, 2.0, 8.0), 2.0 * test::OneStep,
    "blue of the ball, multisampled");
  checks.Near(samples.At(15, 50)[0], 0.5, test::OneStep, "red beside the ball, multisampled");

  // Another size of the second window, while the first is there.
  for (const int size : { 31, 160, 100 })
  {
    smooth.window->SetSize(size, size);
    const test::Picture resized(smooth.window);
    checks.Equal(resized.GetWidth(), size, "width after a change of size");
    checks.Near(resized.Coverage(), 0.64, 0.08, "coverage at size " + std::to_string(size));
    checks.Near(resized.Center()[2], samples.Center()[2], 4.0 * test::OneStep, "middle, resized");
  }
  checks.Expect(
    four.Difference(test::Picture(stage.window)) == 0.0, "the first window is unchanged");

  const int image = vtkRegressionTestImage(stage.window);
  return image == vtkTesting::FAILED ? EXIT_FAILURE : checks.Status();
}
