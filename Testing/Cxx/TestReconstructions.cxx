// SPDX-License-Identifier: BSD-3-Clause
// Reconstructions (above nearest, below basis) and two traversals, which give the same picture;
// and how the length of steps and early termination show.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkRegressionTestImage.h"

namespace
{
constexpr int Size = 200;

// Two cells: red 0 for x < 1, red 1 for x > 1. The colour is the value, as all is opaque.
void checkTwoCells(test::Checks& checks)
{
  test::Stage stage(test::makeAMR({ { 0, { 0, 0, 0 }, { 2, 1, 1 } } },
                      [](double x, double, double) { return x < 1.0 ? 0.0 : 1.0; }),
    Size);
  test::setConstantColor(stage.Property(), 1.0, { 0.0, 0.0, 0.0 });
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  test::lookAlongZ(stage.renderer, 1.0, 0.5, 0.5, 2.0);
  const test::Picture basis(stage.window);
  // Until a reconstruction is chosen, the property's interpolation type says which one is meant.
  stage.Property()->SetInterpolationTypeToNearest();
  const test::Picture byProperty(stage.window);
  stage.mapper->SetReconstructionToBasis();
  checks.Equal(test::Picture(stage.window).Difference(basis), 0.0, "basis is chosen");
  stage.mapper->SetReconstructionToNearest();
  const test::Picture nearest(stage.window);
  checks.Equal(byProperty.Difference(nearest), 0.0, "nearest by the property");
  for (int pixel = 2; pixel < Size; pixel += 5)
  {
    const double x = 2.0 * (pixel + 0.5) / Size;
    const std::string where = " at " + std::to_string(x);
    checks.Near(
      nearest.At(pixel, Size / 2)[0], x < 1.0 ? 0.0 : 1.0, test::OneStep, "nearest" + where);
    // Between the centres at 0.5 and 1.5 the two tents add up to 1; outside of them only one is
    // left.
    const double tents = std::min(1.0, std::max(0.0, x - 0.5));
    checks.Near(basis.At(pixel, Size / 2)[0], tents, test::OneStep, "basis" + where);
  }
}

// Across levels: the mean of the cells' values weighted with their tents of different width.
void checkTwoLevels(test::Checks& checks)
{
  test::Stage stage(
    test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 4, 4 } }, { 1, { 8, 0, 0 }, { 8, 8, 8 } } },
      [](double x, double, double) { return x < 4.0 ? 0.0 : 1.0; }),
    Size);
  test::setConstantColor(stage.Property(), 1.0, { 0.0, 0.0, 0.0 });
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  stage.mapper->SetStepScale(0.01); // opaque at once: what is seen is the value at the upper face
  test::lookAlongZ(stage.renderer, 4.0, 2.0, 2.0, 4.0);
  const test::Picture picture(stage.window);
  for (int pixel = 1; pixel < Size; pixel += 3)
  {
    const double x = 2.0 + 4.0 * (pixel + 0.5) / Size;
    // Coarse tents of width 1, fine ones of width 0.5. Along y the tents of a level add up to 1,
    // along z at the upper face to 1/2, so that x alone decides.
    const auto tent = [x](double center, double width)
    { return std::max(0.0, 1.0 - std::abs(x - center) / width); };
    const double coarse = tent(2.5, 1.0) + tent(3.5, 1.0) + tent(1.5, 1.0);
    double fine = 0.0;
    for (double center = 4.25; center < 8.0; center += 0.5)
    {
      fine += tent(center, 0.5);
    }
    checks.Near(picture.At(pixel, Size / 2)[0], fine / (coarse + fine), 2.0 * test::OneStep,
      "across levels at " + std::to_string(x));
  }
}

// A linear field across levels: completed draws it as it is, the basis leans to the coarse side.
void checkLinearField(test::Checks& checks)
{
  test::Stage stage(
    test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 4, 4 } }, { 1, { 8, 0, 0 }, { 8, 8, 8 } } },
      [](double x, double, double) { return x / 8.0; }),
    Size);
  test::setConstantColor(stage.Property(), 1.0, { 0.0, 0.0, 0.0 });
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  test::lookAlongZ(stage.renderer, 4.0, 2.0, 2.0, 4.0);
  const test::Picture basis(stage.window);
  stage.mapper->SetReconstructionToCompleted();
  const test::Picture completed(stage.window);
  double leaning = 0.0;
  for (int pixel = 1; pixel < Size; ++pixel)
  {
    const double x = 2.0 + 4.0 * (pixel + 0.5) / Size;
    checks.Near(completed.At(pixel, Size / 2)[0], x / 8.0, test::OneStep,
      "completed at " + std::to_string(x));
    leaning = std::max(leaning, x / 8.0 - basis.At(pixel, Size / 2)[0]);
  }
  // Half a fine cell of 1/2 at a slope of 1/8.
  checks.Near(leaning, 0.03125, 1.5 * test::OneStep, "the basis leans to the coarse side");
  // And back again: the volume is made anew each time.
  stage.mapper->SetReconstructionToBasis();
  checks.Near(test::Picture(stage.window).Difference(basis), 0.0, 0.0, "basis again");
}
}

int TestReconstructions(int argc, char* argv[])
{
  test::Checks checks;
  const test::KeepDisplay display;
  checkTwoCells(checks);
  checkTwoLevels(checks);
  checkLinearField(checks);

  const std::vector<test::Block> blocks{ { 0, { 0, 0, 0 }, { 8, 8, 8 } },
    { 1, { 4, 4, 4 }, { 8, 8, 8 } }, { 2, { 16, 8, 16 }, { 8, 8, 8 } } };
  test::Stage stage(
    test::makeAMR(blocks,
      [](double x, double y, double z) { return std::sin(x) + std::sin(1.3 * y) + std::cos(z); }),
    Size);
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(-2.0, 0.1, 0.3, 1.0);
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.9, 0.9, 0.9);
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(2.5, 1.0, 0.2, 0.0);
  stage.Property()->GetScalarOpacity()->AddPoint(0.3, 0.0);
  stage.Property()->GetScalarOpacity()->AddPoint(2.0, 0.9);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->SetPosition(20.0, 12.0, 30.0);
  camera->SetFocalPoint(4.0, 4.0, 4.0);
  stage.renderer->ResetCameraClippingRange();

  // Both traversals, for both reconstructions. Lavapipe before 24 has no ray queries.
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  for (const int reconstruction :
    { vtkExaBricksVolumeMapper::BASIS, vtkExaBricksVolumeMapper::NEAREST })
  {
    mapper->SetReconstruction(reconstruction);
    mapper->SetTraversalToKdTree();
    const test::Picture kdTree(stage.window);
    checks.Expect(mapper->GetTraversalUsed() == std::string("KdTree"), "k-d tree is used");
    checks.Expect(kdTree.Coverage() > 0.2, "there is something to compare");
    test::Messages messages;
    mapper->SetTraversalToRayQuery();
    const test::Picture rayQuery(stage.window);
    if (messages.Errors().empty())
    {
      checks.Expect(mapper->GetTraversalUsed() == std::string("RayQuery"), "ray query is used");
      checks.Expect(kdTree.Difference(rayQuery) <= test::OneStep,
        "both traversals give the same picture, found a difference of " +
          std::to_string(kdTree.Difference(rayQuery)));
    }
    else
    {
      checks.Says(messages.TakeErrors(), { "VK_KHR_ray_query" }, "a device without ray queries");
    }
  }
  mapper->SetTraversalToAutomatic();

  // Shorter steps change little, longer ones more.
  mapper->SetReconstructionToBasis();
  const auto with = [&](double scale)
  {
    mapper->SetStepScale(scale);
    return test::Picture(stage.window);
  };
  const test::Picture exact = with(0.05);
  const double half = exact.Difference(with(0.5));
  const double one = exact.Difference(with(1.0));
  const double four = exact.Difference(with(4.0));
  checks.Expect(half < 0.04 && half <= one && one < four,
    "the error grows with the step: " + std::to_string(half) + ", " + std::to_string(one) + ", " +
      std::to_string(four));
  mapper->SetStepScale(0.5);

  // Ending early leaves out what is hidden: no more than what the opacity lacks.
  mapper->SetEarlyTerminationOpacity(1.0);
  const test::Picture whole(stage.window);
  for (const double opacity : { 0.999, 0.95, 0.5 })
  {
    mapper->SetEarlyTerminationOpacity(opacity);
    const double lost = whole.Difference(test::Picture(stage.window));
    checks.Expect(
      lost <= 1.0 - opacity + test::OneStep, "lost by ending at " + std::to_string(opacity));
    checks.Expect((opacity > 0.9) != (lost > 0.1), "loss of " + std::to_string(lost));
  }
  mapper->SetEarlyTerminationOpacity(0.999);

  // For the eye: nearest above, basis below.
  mapper->SetReconstructionToNearest();
  stage.renderer->SetViewport(0.0, 0.5, 1.0, 1.0);
  camera->Zoom(1.4);
  vtkNew<vtkExaBricksVolumeMapper> smooth;
  smooth->SetInputDataObject(mapper->GetInputDataObject(0, 0));
  vtkNew<vtkVolume> volume;
  volume->SetMapper(smooth);
  volume->SetProperty(stage.Property());
  vtkNew<vtkRenderer> below;
  below->SetViewport(0.0, 0.0, 1.0, 0.5);
  below->SetActiveCamera(camera);
  below->AddVolume(volume);
  stage.window->AddRenderer(below);
  const int image = vtkRegressionTestImage(stage.window);
  return image == vtkTesting::FAILED ? EXIT_FAILURE : checks.Status();
}
