// SPDX-License-Identifier: BSD-3-Clause
// Several components, independent and dependent, show the same as with VTK's GPU mapper. Where
// several independent ones show at one place, ours adds their extinctions up; VTK's GPU mapper
// takes a mean of opacities, each weighted with itself and divided by the components' weights, and
// its two mappers differ by 10 dB: that is not compared, nor weights.

#include "Parity.h"

#include "vtkContourValues.h"

namespace
{
// Another ball, where the first one does not show.
double besideBall(double x, double y, double z) { return std::hypot(x - 18.0, y - 6.0, z - 6.5); }

void setFunctions(vtkVolumeProperty* property, int component, const std::array<double, 3>& color)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, color[0], color[1], color[2]);
  colors->AddRGBPoint(9.0, color[2], color[0], color[1]);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.3);
  opacity->AddPoint(4.5, 0.05);
  opacity->AddPoint(5.0, 0.0);
  property->SetColor(component, colors);
  property->SetScalarOpacity(component, opacity);
}
}

int ComponentsLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  parity::Scene scene;
  scene.field = parity::ball;
  scene.furtherFields = { besideBall };
  parity::Mappers mappers(scene);
  mappers.ShowBall(); // for its view
  vtkVolumeProperty* property = mappers.Property();
  setFunctions(property, 0, { 0.9, 0.2, 0.1 });
  setFunctions(property, 1, { 0.1, 0.3, 1.0 });
  mappers.ExpectSameAsOnGPU(checks, "two independent components");

  for (int component = 0; component < 2; ++component)
  {
    property->GetScalarOpacity(component)->AddPoint(13.0, 0.0); // far off, where maxima are
    property->GetScalarOpacity(component)->AddPoint(24.0, 0.5);
  }
  mappers.ForEach([](vtkVolumeMapper* mapper) { mapper->SetBlendModeToMaximumIntensity(); });
  mappers.ExpectSameAsOnGPU(checks, "maximum of each of two independent components");
  mappers.ForEach([](vtkVolumeMapper* mapper) { mapper->SetBlendModeToComposite(); });
  setFunctions(property, 0, { 0.9, 0.2, 0.1 });
  setFunctions(property, 1, { 0.1, 0.3, 1.0 });

  // Of iso-surfaces the component of the greatest weight has them.
  constexpr double Value = 4.2;
  mappers.ForEach([](vtkVolumeMapper* mapper) { mapper->SetBlendModeToIsoSurface(); });
  property->GetIsoSurfaceValues()->SetValue(0, Value);
  property->SetComponentWeight(0, 0.3);
  property->SetComponentWeight(1, 0.9);
  const test::Picture surface = mappers.Draw(mappers.mapper);
  // VTK's mapper takes the value for one of the first component's range, whichever it draws.
  double ranges[2][2];
  for (int component = 0; component < 2; ++component)
  {
    mappers.onGPU->GetInput()->GetPointData()->GetScalars()->GetRange(ranges[component], component);
  }
  const double part = (Value - ranges[1][0]) / (ranges[1][1] - ranges[1][0]);
  property->GetIsoSurfaceValues()->SetValue(0, ranges[0][0] + part * (ranges[0][1] - ranges[0][0]));
  checks.Expect(surface.Coverage() > 0.02, "the surface shows");
  const double decibel = surface.Decibel(mappers.Draw(mappers.onGPU));
  std::cout << "iso-surface of the heavier of two independent components: " << decibel << " dB\n";
  checks.Expect(decibel >= 35.0, "iso-surface, " + std::to_string(decibel) + " dB");
  property->SetComponentWeight(0, 1.0);
  property->SetComponentWeight(1, 1.0);
  mappers.ForEach([](vtkVolumeMapper* mapper) { mapper->SetBlendModeToComposite(); });

  // Diffuse light alone, as the fixed-point mapper leaves ambient out.
  property->ShadeOn();
  for (int component = 0; component < 2; ++component)
  {
    property->SetAmbient(component, 0.0);
    property->SetDiffuse(component, 0.9);
    property->SetSpecular(component, 0.0);
  }
  mappers.ExpectSameAsOnGPU(checks, "two independent components, shaded");

  // Of dependent ones, the fixed-point mapper and ours shade by the gradient of the last one, which
  // has opacity, VTK's GPU mapper by that of the first of two.
  property->IndependentComponentsOff();
  mappers.ExpectSameAs(checks, mappers.fixedPoint, "colour and opacity, shaded");
  property->ShadeOff();
  mappers.ExpectSame(checks, "colour and opacity");
  return checks.Status();
}
