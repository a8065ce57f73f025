// SPDX-License-Identifier: BSD-3-Clause
// Volumes are lit as with VTK's mappers: by the headlight, with each kind of material, and by
// lights of the scene. The fixed-point mapper is like both others where light is diffuse alone: it
// leaves ambient out, and takes coloured lights otherwise.

#include "Parity.h"

#include "vtkLight.h"
#include "vtkVersion.h"
#include "vtkVersionMacros.h"

int ShadingLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  parity::Mappers mappers({ { 24, 24, 24 }, {}, parity::ball });
  mappers.ShowBall();
  vtkVolumeProperty* property = mappers.Property();
  const test::Picture flat = mappers.Draw(mappers.mapper);
  property->ShadeOn();

  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  mappers.ExpectSame(checks, "diffuse");
  checks.Expect(flat.Decibel(mappers.Draw(mappers.mapper)) < 30.0, "it is shaded");
  property->SetDiffuse(0.5);
  property->SetAmbient(0.4);
  mappers.ExpectSameAsOnGPU(checks, "ambient and diffuse");
  property->SetSpecular(0.4);
  property->SetSpecularPower(12.0);
  // VTK's geometry, and from 9.2 on its GPU mapper, reflect light as ours does; before that, the
  // mapper had Blinn's wider highlights (31 dB).
  if (vtkVersion::GetVTKMinorVersion() >= 2 || vtkVersion::GetVTKMajorVersion() > 9)
  {
    mappers.ExpectSameAsOnGPU(checks, "specular");
  }

  // A light from the side. VTK's GPU mapper leaves ambient out then, as a light's ambient colour is
  // black by default; geometry does not, and ours does as geometry.
  property->SetAmbient(0.0);
  property->SetSpecular(0.0);
  property->SetDiffuse(0.9);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(-60.0, -20.0, 40.0);
  light->SetFocalPoint(12.0, 12.0, 12.0);
  light->SetDiffuseColor(1.0, 0.8, 0.6);
  mappers.renderer->AddLight(light);
  mappers.ExpectSameAsOnGPU(checks, "a light of the scene");

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  // Light that the medium scatters, and shadows. VTK's rays to the light take steps of the
  // picture's own, from each of its samples; ours are found at cells.
  // And VTK's samples are at most as bright as can be, where ours add up: two lights are dim enough
  // for that.
  property->SetDiffuse(0.45);
  const auto expectSame = [&](float blending, float reach, const std::string& what)
  {
    mappers.mapper->SetVolumetricScatteringBlending(blending);
    mappers.mapper->SetGlobalIlluminationReach(reach);
    mappers.onGPU->SetVolumetricScatteringBlending(blending);
    mappers.onGPU->SetGlobalIlluminationReach(reach);
    mappers.ExpectSameAsOnGPU(checks, what);
  };
  expectSame(2.0f, 1.0f, "shadows");
  checks.Expect(mappers.Draw(mappers.mapper).Decibel(flat) < 30.0, "there are shadows");
  expectSame(2.0f, 0.3f, "shorter shadows");
  expectSame(1.0f, 1.0f, "shadows of surfaces and medium");
  property->SetScatteringAnisotropy(0.4);
  expectSame(2.0f, 1.0f, "scattered onwards");
  property->SetScatteringAnisotropy(0.0);
  property->SetDiffuse(0.9);
  expectSame(0.0f, 0.0f, "surfaces again");
#endif

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  // Normals of opacity, which falls where values rise, of one side.
  mappers.renderer->SetTwoSidedLighting(false);
  const test::Picture ofValues = mappers.Draw(mappers.mapper);
  mappers.mapper->ComputeNormalFromOpacityOn();
  mappers.onGPU->ComputeNormalFromOpacityOn();
  mappers.ExpectSameAsOnGPU(checks, "normals of opacity");
  checks.Expect(mappers.Draw(mappers.mapper).Decibel(ofValues) < 25.0, "they are others");
#endif
  return checks.Status();
}
