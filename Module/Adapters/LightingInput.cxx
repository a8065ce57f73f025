// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/LightingInput.h"

#include "Adapters/Matrices.h"
#include "Layout.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>

namespace exabricks
{
namespace
{
glm::dvec3 toVector(const double v[3]) { return { v[0], v[1], v[2] }; }

// Those that are switched on.
std::vector<vtkLight*> findLights(vtkRenderer* ren)
{
  std::vector<vtkLight*> lights;
  vtkCollectionSimpleIterator cookie;
  vtkLightCollection* all = ren->GetLights();
  all->InitTraversal(cookie);
  while (vtkLight* light = all->GetNextLight(cookie))
  {
    if (light->GetSwitch())
    {
      lights.push_back(light);
    }
  }
  return lights;
}

// `corner`: of the data's bounds, in the world.
Light makeLight(vtkLight* from, const glm::dvec3& corner)
{
  double position[3];
  double focalPoint[3];
  from->GetTransformedPosition(position);
  from->GetTransformedFocalPoint(focalPoint);
  Light light;
  const glm::dvec3 path = toVector(focalPoint) - toVector(position);
  light.direction = glm::length(path) > 0.0 ? glm::normalize(path) : glm::dvec3(0.0, 0.0, -1.0);
  light.diffuse = from->GetIntensity() * toVector(from->GetDiffuseColor());
  light.specular = from->GetIntensity() * toVector(from->GetSpecularColor());
  light.positional = from->GetPositional() != 0;
  light.position = toVector(position) - corner;
  light.attenuation = toVector(from->GetAttenuationValues());
  light.coneAngle = from->GetConeAngle();
  light.exponent = from->GetExponent();
  return light;
}
}

Requests checkLights(vtkRenderer* ren, vtkVolume* vol)
{
  Requests requests;
  const std::size_t lights = findLights(ren).size();
  if (vol->GetProperty()->GetShade(0) && lights > layout::MOST_LIGHTS)
  {
    requests.drawnWithout.push_back("Expected at most " + std::to_string(layout::MOST_LIGHTS) +
      " lights that shine, found " + std::to_string(lights) +
      ": the volume is shaded by the first ones. Switch some off, or remove them.");
  }
  return requests;
}

std::optional<Lighting> makeLighting(vtkRenderer* ren, vtkVolume* vol, const BrickedVolume& bricked)
{
  vtkVolumeProperty* property = vol->GetProperty();
  if (!property->GetShade(0))
  {
    return std::nullopt;
  }
  Lighting lighting;
  lighting.ambient = property->GetAmbient(0);
  lighting.diffuse = property->GetDiffuse(0);
  lighting.specular = property->GetSpecular(0);
  lighting.specularPower = property->GetSpecularPower(0);
  lighting.twoSided = ren->GetTwoSidedLighting() != 0;
  const glm::dmat4 toWorld = toGLM(vol->GetMatrix());
  lighting.dataToWorld = glm::dmat3(toWorld);
  const glm::dvec3 corner(toWorld * glm::dvec4(bricked.world(glm::dvec3(0.0)), 1.0));
  for (vtkLight* light : findLights(ren))
  {
    lighting.lights.push_back(makeLight(light, corner));
  }
  return lighting;
}

std::vector<float> makeGradientOpacity(vtkVolumeProperty* property, const Range& range)
{
  if (!hasGradientOpacity(property))
  {
    return {};
  }
  vtkPiecewiseFunction* function = property->GetGradientOpacity(0);
  const double width = range.max > range.min ? range.max - range.min : 1.0;
  std::vector<float> table(layout::GRADIENT_OPACITIES);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double part = static_cast<double>(i) / static_cast<double>(table.size() - 1);
    table[i] = static_cast<float>(
      std::clamp(function->GetValue(part * layout::GREATEST_GRADIENT * width), 0.0, 1.0));
  }
  return table;
}
}
