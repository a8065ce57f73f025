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

// Properties of earlier versions of VTK have none.
template <typename Property>
auto scatteringAnisotropyOf(Property* property, int)
  -> decltype(property->GetScatteringAnisotropy())
{
  return property->GetScatteringAnisotropy();
}
template <typename Property>
double scatteringAnisotropyOf(Property*, ...)
{
  return 0.0;
}

bool isShaded(vtkVolumeProperty* property, std::size_t components)
{
  for (std::size_t k = 0; k < std::min<std::size_t>(components, layout::MOST_COMPONENTS); ++k)
  {
    if (property->GetShade(static_cast<int>(k)))
    {
      return true;
    }
  }
  return false;
}
}

Requests checkLights(vtkRenderer* ren, vtkVolume* vol)
{
  Requests requests;
  const std::size_t lights = findLights(ren).size();
  if (isShaded(vol->GetProperty(), layout::MOST_COMPONENTS) && lights > layout::MOST_LIGHTS)
  {
    requests.drawnWithout.push_back("Expected at most " + std::to_string(layout::MOST_LIGHTS) +
      " lights that shine, found " + std::to_string(lights) +
      ": the volume is shaded by the first ones. Switch some off, or remove them.");
  }
  return requests;
}

bool isShaded(vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  return bricked.volume.components() > 1 && isIndependent(property, bricked)
    ? isShaded(property, bricked.volume.components())
    : property->GetShade(bricked.propertyComponent) != 0;
}

double findScatteringAnisotropy(vtkVolumeProperty* property)
{
  return scatteringAnisotropyOf(property, 0);
}

std::optional<Lighting> makeLighting(vtkRenderer* ren, vtkVolume* vol, const BrickedVolume& bricked)
{
  vtkVolumeProperty* property = vol->GetProperty();
  if (!isShaded(property, bricked))
  {
    return std::nullopt;
  }
  Lighting lighting;
  for (std::size_t k = 0; k < lighting.materials.size(); ++k)
  {
    const int component =
      std::min(bricked.propertyComponent + static_cast<int>(k), VTK_MAX_VRCOMP - 1);
    lighting.materials[k] = { property->GetAmbient(component), property->GetDiffuse(component),
      property->GetSpecular(component), property->GetSpecularPower(component) };
  }
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

std::vector<float> makeGradientOpacity(vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  const Volume& volume = bricked.volume;
  // Of dependent components the last one has opacity, by the first function.
  const std::size_t components = volume.components();
  const bool independent = isIndependent(property, bricked);
  const std::size_t functions = independent ? components : 1;
  std::vector<bool> has(functions);
  for (std::size_t k = 0; k < functions; ++k)
  {
    has[k] = hasGradientOpacity(property, bricked.propertyComponent + static_cast<int>(k));
  }
  if (std::find(has.begin(), has.end(), true) == has.end())
  {
    return {};
  }
  std::vector<float> tables;
  for (std::size_t k = 0; k < functions; ++k)
  {
    vtkPiecewiseFunction* function = has[k]
      ? property->GetGradientOpacity(bricked.propertyComponent + static_cast<int>(k))
      : nullptr;
    const Range& range = volume.valuesOf(independent ? k : components - 1)->range;
    const double width = range.max > range.min ? range.max - range.min : 1.0;
    for (std::uint32_t i = 0; i < layout::GRADIENT_OPACITIES; ++i)
    {
      const double part = static_cast<double>(i) / (layout::GRADIENT_OPACITIES - 1);
      const double gradient = part * layout::GREATEST_GRADIENT * width;
      const double opacity = function ? function->GetValue(gradient) : 1.0;
      tables.push_back(static_cast<float>(std::clamp(opacity, 0.0, 1.0)));
    }
  }
  return tables;
}
}
