// SPDX-License-Identifier: BSD-3-Clause
// The first picture of data that nobody has looked at yet: colors, opacities and a camera are
// chosen from the data, and show what is rare in them.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksFirstPicture.h"
#include "vtkMatrix4x4.h"

namespace
{
// A cube from 0 to 16 of 32^3 cells.
std::vector<test::Block> cube() { return { { 0, { 0, 0, 0 }, { 32, 32, 32 } } }; }

test::Lattice lattice()
{
  test::Lattice result;
  result.spacing = { 0.5, 0.5, 0.5 };
  return result;
}

// A ball with a radius of 2 around (11, 5, 9) in a constant.
double ball(double x, double y, double z)
{
  return 1.0 + std::max(0.0, 2.0 - std::hypot(x - 11.0, y - 5.0, z - 9.0));
}

vtkExaBricksData* update(test::Stage& stage)
{
  stage.mapper->Update();
  return stage.mapper->GetBuilder()->GetOutput();
}
}

int TestFirstPicture(int, char*[])
{
  test::Checks checks;
  test::Messages messages;

  // What is common is clear, what is rare shows, and the camera frames it.
  test::Stage stage(test::makeAMR(cube(), ball, lattice()), 100);
  vtkNew<vtkExaBricksFirstPicture> first;
  checks.Expect(first->Choose(update(stage)), "chosen");
  first->InitializeProperty(stage.Property());
  first->InitializeCamera(stage.renderer->GetActiveCamera(), 1.0);
  stage.renderer->ResetCameraClippingRange();
  const double* bounds = first->GetShownBounds();
  const double middle[3] = { 11.0, 5.0, 9.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    checks.Near(bounds[2 * axis], middle[axis] - 1.7, 0.6, "where the ball begins");
    checks.Near(bounds[2 * axis + 1], middle[axis] + 1.7, 0.6, "where the ball ends");
  }
  checks.Near(first->GetScalarOpacityUnitDistance(), 0.06, 0.02, "a hundredth of its diagonal");
  checks.Near(first->GetColorRange()[0], 1.0, 1e-12, "the least value");
  checks.Near(first->GetColorRange()[1], 2.8, 0.3, "the greatest value");
  checks.Equal(first->GetScalarOpacity()->GetValue(1.0), 0.0, "the common value is clear");
  checks.Expect(first->GetScalarOpacity()->GetValue(2.5) > 0.01, "a rare one is not");
  checks.Expect(!first->GetLogarithmWanted(), "no logarithm");
  const test::Picture picture(stage.window);
  const test::Picture::Color center = picture.Center();
  const double brightest = *std::max_element(center.begin(), center.end());
  checks.Expect(brightest > 0.4, "the ball is bright, " + std::to_string(brightest));
  checks.Expect(picture.Coverage() > 0.15 && picture.Coverage() < 0.8,
    "the ball fills the picture, " + std::to_string(picture.Coverage()));
  checks.Equal(picture.At(2, 2)[0] + picture.At(2, 2)[1] + picture.At(2, 2)[2], 0.0,
    "nothing shows beside it");

  // The whole of some bounds is in the picture, and touches its margin.
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(1.0, 2.0, 3.0);
  camera->SetPosition(4.0, -5.0, 8.0);
  const double box[6] = { -1.0, 5.0, 0.0, 3.0, 2.0, 9.0 };
  vtkExaBricksFirstPicture::FitCamera(camera, box, 1.5);
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double place[4] = { box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2)], 1.0 };
    camera->GetCompositeProjectionTransformMatrix(1.5, -1.0, 1.0)->MultiplyPoint(place, place);
    farthest = std::max({ farthest, std::abs(place[0] / place[3]), std::abs(place[1] / place[3]) });
  }
  checks.Near(farthest, 1.0 / 1.05, 0.02, "the corner that is nearest to the edge");

  // Six decades, most of them in few cells: logarithms show more.
  const auto decades = [](double x, double y, double z)
  { return std::exp2(-8.0 * std::hypot(x - 8.0, y - 8.0, z - 8.0) / 4.0); };
  test::Stage wide(test::makeAMR(cube(), decades, lattice()), 100);
  checks.Expect(first->Choose(update(wide)), "chosen");
  checks.Expect(first->GetLogarithmWanted(), "a logarithm");
  const auto logarithm = [&](double x, double y, double z)
  { return std::log10(decades(x, y, z)) * 3.0; };
  test::Stage logs(test::makeAMR(cube(), logarithm, lattice()), 100);
  first->LogarithmicOn();
  checks.Expect(first->Choose(update(logs)), "chosen");
  checks.Expect(!first->GetLogarithmWanted(), "logarithms are none of logarithms");
  checks.Near(
    first->GetColorRange()[1] - first->GetColorRange()[0], 8.0, 1e-9, "eight decades at most");
  first->LogarithmicOff();

  // One value alone: all is shown, as a mist, with a color of its own.
  test::Stage flat(test::makeAMR(cube(), test::constant(7.0), lattice()), 100);
  checks.Expect(first->Choose(update(flat)), "chosen");
  first->InitializeProperty(flat.Property());
  first->InitializeCamera(flat.renderer->GetActiveCamera(), 1.0);
  flat.renderer->ResetCameraClippingRange();
  checks.Near(first->GetShownBounds()[1], 16.0, 1e-9, "all of the bounds");
  const test::Picture mist(flat.window);
  checks.Expect(mist.Center()[1] > 0.1, "a mist");

  // Other ways of blending show all values: the greatest one by an opacity that rises, sums by a
  // unit distance that makes them neither dark nor white, in all of the bounds.
  vtkNew<vtkExaBricksFirstPicture> other;
  other->SetBlendMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  checks.Expect(other->Choose(update(stage)), "chosen");
  checks.Equal(other->GetScalarOpacity()->GetValue(other->GetColorRange()[0]), 0.0, "the least");
  checks.Equal(other->GetScalarOpacity()->GetValue(other->GetColorRange()[1]), 1.0, "the greatest");
  for (const int mode : { vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::SLICE_BLEND })
  {
    other->SetBlendMode(mode);
    checks.Expect(other->Choose(update(stage)), "chosen");
    checks.Equal(other->GetScalarOpacity()->GetValue(other->GetColorRange()[0]), 1.0, "as it is");
    checks.Near(other->GetShownBounds()[1], 16.0, 1e-9, "all of the bounds");
  }
  const auto sloped = [](double x, double, double) { return x; };
  test::Stage sums(test::makeAMR(cube(), sloped, lattice()), 100);
  sums.mapper->SetBlendModeToAdditive();
  other->SetBlendMode(vtkVolumeMapper::ADDITIVE_BLEND);
  checks.Expect(other->Choose(update(sums)), "chosen");
  other->InitializeProperty(sums.Property());
  other->InitializeCamera(sums.renderer->GetActiveCamera(), 1.0);
  sums.renderer->ResetCameraClippingRange();
  const double sum = test::Picture(sums.window).Center()[1];
  checks.Expect(sum > 0.2 && sum < 0.8, "a sum through the middle, " + std::to_string(sum));

  // Words where nothing can be chosen; then all is as it was.
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");
  checks.Expect(!first->Choose(nullptr), "no data");
  checks.Says(messages.TakeErrors(), { "no data", "Update" }, "no data");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  test::Stage empty(test::makeAMR(cube(), test::constant(nan), lattice()), 10);
  checks.Expect(!first->Choose(update(empty)), "no value");
  checks.Says(messages.TakeErrors(), { "found none" }, "no value");
  checks.Near(first->GetColorRange()[0], 7.0, 1e-12, "as it was");
  first->SetColorMap("rainbow");
  checks.Says(messages.TakeErrors(), { "viridis", "'rainbow'" }, "an unknown color map");
  checks.Expect(first->GetColorMap() == "viridis", "as it was");
  return checks.Status();
}
