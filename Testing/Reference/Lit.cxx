// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Lit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
// Along one axis, by logical coordinates. One-sided beside places where nothing is.
double findSlope(const FieldFunction& field, const glm::dvec3& place, int axis)
{
  constexpr double Step = 1e-4;
  glm::dvec3 offset(0.0);
  offset[axis] = Step;
  const std::optional<double> value = field(place);
  const std::optional<double> above = field(place + offset);
  const std::optional<double> below = field(place - offset);
  const double width = (above ? Step : 0.0) + (below ? Step : 0.0);
  return value && width > 0.0 ? (above.value_or(*value) - below.value_or(*value)) / width : 0.0;
}

// Henyey and Greenstein's, times 4 pi.
double phaseOf(double g, double cosine)
{
  return (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
}

// By what is seen of the surfaces (0) or of the medium (1).
double shareOfScattering(double blending, bool changes, double opacity)
{
  const double thin = changes ? std::exp(-blending * opacity) : 1.0;
  return blending < 1.0 ? blending * thin : (2.0 - blending) * thin + blending - 1.0;
}

// `place` in the light's coordinates; `normal` of length 1, or 0.
glm::dvec3 shadeNormal(const glm::dvec3& color, const Lighting& lighting, const Material& material,
  const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3& toEye,
  const LitMedium& medium)
{
  glm::dvec3 diffuse(0.0);
  glm::dvec3 specular(0.0);
  glm::dvec3 scattered(0.0);
  for (std::size_t i = 0; i < lighting.lights.size(); ++i)
  {
    const Light& light = lighting.lights[i];
    glm::dvec3 toLight = -light.direction;
    double reaching = 1.0;
    if (light.positional)
    {
      const glm::dvec3 path = place - light.position;
      const double distance = glm::length(path);
      toLight = -path / distance;
      reaching = 1.0 / glm::dot(light.attenuation, glm::dvec3(1.0, distance, distance * distance));
      const double cosine = -glm::dot(toLight, light.direction);
      if (light.coneAngle <= 90.0)
      {
        reaching *= cosine >= std::cos(glm::radians(light.coneAngle))
          ? std::pow(cosine, light.exponent)
          : 0.0;
      }
    }
    if (lighting.scattering)
    {
      const double phase = phaseOf(lighting.scattering->anisotropy, -glm::dot(toLight, toEye));
      scattered += light.diffuse * reaching * phase * medium.shares[i];
    }
    const double cosine = glm::dot(normal, toLight);
    if (cosine > 0.0 || (lighting.twoSided && cosine < 0.0))
    {
      const double shine = glm::dot(glm::reflect(-toLight, normal), toEye);
      diffuse += light.diffuse * reaching * std::abs(cosine);
      specular +=
        light.specular * reaching * std::pow(std::max(shine, 0.0), material.specularPower);
    }
  }
  const glm::dvec3 surface =
    color * (material.ambient + material.diffuse * diffuse) + material.specular * specular;
  if (!lighting.scattering)
  {
    return surface;
  }
  return glm::mix(surface, color * (material.ambient + material.diffuse * scattered),
    shareOfScattering(
      lighting.scattering->blending, normal != glm::dvec3(0.0), medium.opacityOfUnit));
}
}

glm::dvec3 findGradient(const FieldFunction& field, const Box& bounds, const glm::dvec3& place)
{
  glm::dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    gradient[axis] = findSlope(field, place, axis);
    for (const double half : { 0.5, 1.0, 2.0, 4.0 })
    {
      glm::dvec3 inside = place;
      inside[axis] = glm::clamp(place[axis], static_cast<double>(bounds.lo[axis]) + half + 2e-4,
        static_cast<double>(bounds.hi[axis]) - half - 2e-4);
      if (std::abs(gradient[axis]) < 1e-9)
      {
        gradient[axis] = findSlope(field, inside, axis);
      }
    }
  }
  return gradient;
}

LitSpace::LitSpace(
  const glm::dmat4& logicalToWorld, const Box& bounds, const glm::dmat3& dataToWorld)
  : logicalToData(logicalToWorld)
  , toWorld(dataToWorld * glm::dmat3(logicalToWorld))
  , gradientToWorld(glm::transpose(glm::inverse(this->toWorld)))
  , spacing(logicalToWorld[0].x, logicalToWorld[1].y, logicalToWorld[2].z)
  , corner(bounds.lo)
{
}

double LitSpace::magnitudeOf(const glm::dvec3& gradient) const
{
  return glm::length(gradient / this->spacing) *
    (this->spacing.x + this->spacing.y + this->spacing.z) / 3.0;
}

glm::dvec3 LitSpace::shade(const glm::dvec3& color, const Lighting& lighting,
  const Material& material, const glm::dvec3& place, const glm::dvec3& gradient,
  const glm::dvec3& path, const LitMedium& medium) const
{
  const glm::dvec3 normal = this->gradientToWorld * gradient;
  const double length = glm::length(normal);
  return shadeNormal(color, lighting, material, this->toWorld * (place - this->corner),
    length > 1e-9 ? -normal / length : glm::dvec3(0.0), -glm::normalize(this->toWorld * path),
    medium);
}
}
}
