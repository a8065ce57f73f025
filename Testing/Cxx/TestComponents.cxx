// SPDX-License-Identifier: BSD-3-Clause
// Arrays of several components: independent ones with functions and weights of their own, a colour
// with an opacity, red, green and blue with an opacity. Rays through cells of known values have the
// colours that can be told by hand.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
constexpr double Thickness = 2.0; // of the data
using Color = test::Picture::Color;

// Two halves, side by side, along x from -2 to 0 and from 0 to 2.
vtkSmartPointer<vtkOverlappingAMR> makeHalves(
  const std::vector<double>& left, const std::vector<double>& right)
{
  auto amr = test::makeAMR({ { 0, { -2, 0, 0 }, { 4, 2, 2 } } }, test::constant(0.0));
  std::vector<test::Field> fields;
  for (std::size_t k = 0; k < left.size(); ++k)
  {
    fields.push_back([=](double x, double, double) { return x < 0.0 ? left[k] : right[k]; });
  }
  test::forEachGrid(amr, [&](unsigned int, vtkUniformGrid* grid) { test::addCells(grid, fields); });
  return amr;
}

// Of component `k`, one colour, and opacity 0 at the value 0, 0.4 at the value 1.
void setFunctions(vtkVolumeProperty* property, int k, const Color& color)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, color[0], color[1], color[2]);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 0.4);
  property->SetColor(k, colors);
  property->SetScalarOpacity(k, opacity);
}

double extinction(double opacity) { return -std::log(1.0 - opacity); }

struct Scene : test::Stage
{
  test::Checks& Checked;

  Scene(test::Checks& checks, vtkOverlappingAMR* amr)
    : Stage(amr, 20)
    , Checked(checks)
  {
    this->mapper->SetReconstructionToNearest();
    test::lookAlongZ(this->renderer, 0.0, 1.0, 1.0, 2.0);
  }

  // The colours of both halves, in front of black.
  void Shows(const Color& left, const Color& right, const std::string& what)
  {
    const test::Picture picture(this->window);
    for (int c = 0; c < 3; ++c)
    {
      const std::string channel = what + ", channel " + std::to_string(c);
      this->Checked.Near(picture.At(4, 10)[c], left[c], test::OneStep, channel + ", left");
      this->Checked.Near(picture.At(15, 10)[c], right[c], test::OneStep, channel + ", right");
    }
  }
};

// What a medium of these extinctions of red and blue looks like over the data's thickness.
Color mix(double red, double blue)
{
  const double sum = red + blue;
  const double opacity = 1.0 - std::exp(-sum * Thickness);
  return { opacity * red / sum, 0.0, opacity * blue / sum };
}
}

int TestComponents(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  const double shown = extinction(0.4);

  Scene two(checks, makeHalves({ 1.0, 0.0 }, { 0.5, 1.0 }));
  setFunctions(two.Property(), 0, { 1.0, 0.0, 0.0 });
  setFunctions(two.Property(), 1, { 0.0, 0.0, 1.0 });
  two.Shows(mix(shown, 0.0), mix(extinction(0.2), shown), "independent");
  two.Property()->SetComponentWeight(1, 0.25);
  two.Shows(mix(shown, 0.0), mix(extinction(0.2), 0.25 * shown), "a quarter of one");
  two.Property()->SetScalarOpacityUnitDistance(1, 0.5);
  two.Shows(mix(shown, 0.0), mix(extinction(0.2), 0.5 * shown), "with a unit distance of its own");
  two.Property()->SetScalarOpacityUnitDistance(1, 1.0);
  two.Property()->SetComponentWeight(0, 0.0);
  two.Property()->SetComponentWeight(1, 1.0);
  two.Shows({ 0.0, 0.0, 0.0 }, mix(0.0, shown), "without one");
  two.Property()->SetComponentWeight(0, 1.0);

  // One component, or the magnitude, with the functions of component 0.
  two.mapper->SetVectorModeToComponent();
  two.mapper->SetVectorComponent(1);
  two.Shows({ 0.0, 0.0, 0.0 }, mix(shown, 0.0), "component 1");
  two.mapper->SetVectorModeToMagnitude();
  two.Shows(mix(shown, 0.0), mix(shown, 0.0), "magnitude"); // more than 1 shows as 1 does
  two.mapper->SetVectorModeToDisabled();
  two.Shows(mix(shown, 0.0), mix(extinction(0.2), shown), "independent again");

  // The first one has colours, the second one opacity.
  two.Property()->IndependentComponentsOff();
  two.Property()->GetRGBTransferFunction(0)->AddRGBPoint(1.0, 0.0, 0.0, 1.0);
  two.Shows({ 0.0, 0.0, 0.0 }, mix(0.5 * shown, 0.5 * shown), "colour and opacity");

  // Each is lit by its own material, and projected by itself.
  two.Property()->IndependentComponentsOn();
  setFunctions(two.Property(), 0, { 1.0, 0.0, 0.0 });
  two.Property()->ShadeOn();
  for (int component = 0; component < 2; ++component)
  {
    two.Property()->SetAmbient(component, component == 0 ? 0.5 : 1.0);
    two.Property()->SetDiffuse(component, 0.0);
    two.Property()->SetSpecular(component, 0.0);
  }
  Color lit = mix(extinction(0.2), shown);
  lit[0] *= 0.5;
  two.Shows({ 0.5 * mix(shown, 0.0)[0], 0.0, 0.0 }, lit, "shaded");
  two.mapper->SetErrorTolerance(0.002);
  two.Shows({ 0.5 * mix(shown, 0.0)[0], 0.0, 0.0 }, lit, "within a tolerance");
  two.mapper->SetErrorTolerance(0.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.7);
  two.Property()->SetSliceFunction(plane);
  two.mapper->SetBlendModeToSlice();
  two.Shows({ 0.2, 0.0, 0.0 }, { 0.1, 0.0, 0.4 }, "a slice, shaded");
  two.Property()->ShadeOff();
  two.mapper->SetBlendModeToMaximumIntensity();
  two.Shows({ 0.4, 0.0, 0.0 }, { 0.2, 0.0, 0.4 }, "maximum");
  two.mapper->SetBlendModeToAdditive();
  // Values, as parts of their components' ranges, times opacities, over the thickness.
  two.Shows({ 0.8, 0.8, 0.8 }, { 0.8, 0.8, 0.8 }, "additive");
  two.mapper->SetBlendModeToComposite();
  two.Property()->IndependentComponentsOff();

  // Red, green, blue and opacity, in bytes.
  auto bytes = makeHalves({ 0.0 }, { 0.0 });
  test::forEachGrid(bytes,
    [](unsigned int, vtkUniformGrid* grid)
    {
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetName("colors");
      colors->SetNumberOfComponents(4);
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        const bool left = cell % 4 < 2;
        colors->InsertNextTuple4(left ? 255 : 51, left ? 102 : 204, left ? 0 : 153, left ? 1 : 0);
      }
      grid->GetCellData()->SetScalars(colors);
    });
  Scene rgba(checks, bytes);
  setFunctions(rgba.Property(), 0, { 1.0, 1.0, 1.0 });
  rgba.Property()->IndependentComponentsOff();
  const double opacity = 1.0 - std::exp(-shown * Thickness);
  rgba.Shows({ opacity, 0.4 * opacity, 0.0 }, { 0.0, 0.0, 0.0 }, "RGBA");
  rgba.Property()->GetScalarOpacity(0)->AddPoint(0.0, 0.4);
  rgba.Shows(
    { opacity, 0.4 * opacity, 0.0 }, { 0.2 * opacity, 0.8 * opacity, 0.6 * opacity }, "RGBA, both");

  // A cell of which one component is no number is absent.
  Scene holed(checks, makeHalves({ 1.0, std::numeric_limits<double>::quiet_NaN() }, { 1.0, 0.5 }));
  setFunctions(holed.Property(), 0, { 1.0, 0.0, 0.0 });
  setFunctions(holed.Property(), 1, { 0.0, 0.0, 1.0 });
  holed.Shows({ 0.0, 0.0, 0.0 }, mix(shown, extinction(0.2)), "NaN in one component");

  // Surfaces of independent components are those of the one of the greatest weight, lit by its
  // material.
  auto slopes = test::makeAMR(test::cornerRefined(), test::constant(0.0));
  const test::Field depth = [](double, double, double z) { return 0.1 * z; };
  const test::Field across = [](double, double y, double) { return 0.1 * y; };
  test::forEachGrid(slopes,
    [&](unsigned int, vtkUniformGrid* grid) {
      test::addCells(grid, std::vector<test::Field>{ depth, across, depth });
    });
  Scene surfaces(checks, slopes);
  test::lookAlongZ(surfaces.renderer, 4.0, 4.0, 4.0, 8.0);
  surfaces.mapper->SetReconstructionToBasis();
  surfaces.mapper->SetBlendModeToIsoSurface();
  setFunctions(surfaces.Property(), 0, { 1.0, 0.0, 0.0 });
  setFunctions(surfaces.Property(), 1, { 0.0, 1.0, 0.0 });
  setFunctions(surfaces.Property(), 2, { 0.0, 0.0, 1.0 });
  surfaces.Property()->GetIsoSurfaceValues()->SetValue(0, 0.5);
  surfaces.Shows({ 0.2, 0.0, 0.0 }, { 0.2, 0.0, 0.0 }, "surfaces of the first component");
  surfaces.Property()->SetComponentWeight(0, 0.4);
  surfaces.Property()->SetComponentWeight(1, 0.6);
  surfaces.Property()->SetComponentWeight(2, 0.7);
  surfaces.Shows({ 0.0, 0.0, 0.2 }, { 0.0, 0.0, 0.2 }, "surfaces of the heaviest component");
  // Lit, and less opaque by its gradient.
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.0, 0.5);
  surfaces.Property()->SetGradientOpacity(2, byGradient);
  surfaces.Property()->SetShade(2, true);
  surfaces.Property()->SetAmbient(2, 0.5);
  surfaces.Property()->SetDiffuse(2, 0.0);
  surfaces.Property()->SetSpecular(2, 0.0);
  surfaces.Shows({ 0.0, 0.0, 0.05 }, { 0.0, 0.0, 0.05 }, "lit surfaces of the heaviest component");
  surfaces.Property()->SetGradientOpacity(2, static_cast<vtkPiecewiseFunction*>(nullptr));
  surfaces.Property()->SetShade(2, false);
  // Its 2-D function.
  vtkNew<vtkImageData> yellow;
  yellow->SetDimensions(1, 1, 1);
  yellow->AllocateScalars(VTK_FLOAT, 4);
  yellow->GetPointData()->GetScalars()->SetTuple4(0, 1.0, 1.0, 0.0, 0.5);
  surfaces.Property()->SetTransferFunction2D(2, yellow);
  surfaces.Property()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  surfaces.Shows({ 0.5, 0.5, 0.0 }, { 0.5, 0.5, 0.0 }, "2-D");
  surfaces.Property()->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  surfaces.mapper->SetBlendModeToComposite();
  surfaces.Property()->SetComponentWeight(0, 0.0);
  surfaces.Property()->SetComponentWeight(2, 0.0);
  checks.Expect(test::Picture(surfaces.window).At(10, 10)[1] > 0.2, "all components again");
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");

  // What is not done is said.
  rgba.mapper->SetBlendModeToIsoSurface();
  rgba.Property()->GetIsoSurfaceValues()->SetValue(0, 0.5);
  test::Picture(rgba.window);
  checks.Says(messages.TakeErrors(), { "iso-surface", "red, green, blue" }, "iso-surfaces");
  Scene three(checks, makeHalves({ 1.0, 0.0, 0.0 }, { 0.5, 1.0, 0.0 }));
  three.Property()->IndependentComponentsOff();
  test::Picture(three.window);
  checks.Says(messages.TakeErrors(), { "2 or 4", "found 3" }, "three dependent components");
  Scene five(checks, makeHalves({ 1.0, 0.0, 0.0, 0.0, 0.0 }, { 0.5, 1.0, 0.0, 0.0, 0.0 }));
  test::Picture(five.window);
  checks.Says(messages.TakeErrors(), { "at most 4", "found 5", "SetVectorModeToMagnitude" },
    "five components");

  // Blocks that differ in their components.
  auto unequal = test::makeAMR(test::cornerRefined(), test::constant(0.0));
  test::forEachGrid(unequal,
    [](unsigned int level, vtkUniformGrid* grid)
    { test::addCells(grid, std::vector<test::Field>(level == 0 ? 2 : 4, test::constant(1.0))); });
  Scene differing(checks, unequal);
  test::Picture(differing.window);
  checks.Says(messages.TakeErrors(), { "same number of components", "2 and 4" }, "unequal blocks");
  return checks.Status();
}
