// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Shaded.h"

#include "Reference/BoundedRay.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
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

// In the outermost half cell, where the field is constant along an axis, its slope goes on.
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

// `place` in the light's coordinates; `normal` of length 1, or 0.
glm::dvec3 shade(const glm::dvec3& color, const Lighting& lighting, const glm::dvec3& place,
  const glm::dvec3& normal, const glm::dvec3& toEye)
{
  glm::dvec3 diffuse(0.0);
  glm::dvec3 specular(0.0);
  for (const Light& light : lighting.lights)
  {
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
    const double cosine = glm::dot(normal, toLight);
    if (cosine > 0.0 || (lighting.twoSided && cosine < 0.0))
    {
      const double shine = glm::dot(glm::reflect(-toLight, normal), toEye);
      diffuse += light.diffuse * reaching * std::abs(cosine);
      specular +=
        light.specular * reaching * std::pow(std::max(shine, 0.0), lighting.specularPower);
    }
  }
  return color * (lighting.ambient + lighting.diffuse * diffuse) + lighting.specular * specular;
}
}

Image renderShaded(const FieldFunction& field, const Box& bounds, const View& view,
  const glm::dmat4& logicalToWorld, const TransferFunction& transfer,
  const ShadedSettings& settings)
{
  const glm::dmat3 toData(logicalToWorld);
  const glm::dmat3 toWorld = settings.lighting ? settings.lighting->dataToWorld * toData : toData;
  const glm::dmat3 gradientToWorld = glm::transpose(glm::inverse(toWorld));
  const glm::dvec3 spacing(toData[0].x, toData[1].y, toData[2].z);
  const double meanSpacing = (spacing.x + spacing.y + spacing.z) / 3.0;
  const glm::dvec3 corner(bounds.lo);
  return drawRays(view, bounds,
    [&](const BoundedRay& ray)
    {
      const glm::dvec3 path = ray.to - ray.from;
      const auto samples = static_cast<std::size_t>(std::ceil(glm::length(path) / settings.step));
      const double piece = ray.worldLength / static_cast<double>(samples);
      glm::dvec4 sum(0.0);
      for (std::size_t i = 0; i < samples; ++i)
      {
        const glm::dvec3 place =
          ray.from + (static_cast<double>(i) + 0.5) / static_cast<double>(samples) * path;
        const std::optional<double> value = field(place);
        if (!value)
        {
          continue;
        }
        const glm::dvec4 color = transfer.evaluate(*value);
        if (!(color.a > 0.0))
        {
          continue;
        }
        const glm::dvec3 gradient = findGradient(field, bounds, place);
        double depth = -std::log1p(-color.a) * piece / settings.opacityUnitDistance;
        if (settings.gradientOpacity)
        {
          depth *= settings.gradientOpacity(glm::length(gradient / spacing) * meanSpacing);
        }
        const double alpha = -std::expm1(-depth);
        glm::dvec3 lit(color);
        if (settings.lighting)
        {
          const glm::dvec3 normal = gradientToWorld * gradient;
          const double length = glm::length(normal);
          lit = shade(lit, *settings.lighting, toWorld * (place - corner),
            length > 1e-9 ? -normal / length : glm::dvec3(0.0), -glm::normalize(toWorld * path));
        }
        sum += (1.0 - sum.a) * alpha * glm::dvec4(lit, 1.0);
      }
      return sum;
    });
}
}
}
