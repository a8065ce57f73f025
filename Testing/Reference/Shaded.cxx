// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Shaded.h"

#include "Reference/BoundedRay.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
// How much of each light comes to places through the medium.
class Shadows
{
public:
  Shadows(const FieldFunction& field, const Box& bounds, const LitSpace& space,
    const TransferFunction& transfer, const ShadedSettings& settings)
    : Field(field)
    , Lower(bounds.lo)
    , Upper(bounds.hi)
    , Space(space)
    , Transfer(transfer)
    , Settings(settings)
  {
  }

  std::vector<double> sharesAt(const glm::dvec3& place) const
  {
    std::vector<double> shares;
    for (const Light& light : this->Settings.lighting->lights)
    {
      shares.push_back(this->ShareAt(place, light));
    }
    return shares;
  }

private:
  double ShareAt(const glm::dvec3& place, const Light& light) const
  {
    const double reach = this->Settings.lighting->scattering->reach;
    const glm::dmat3 toLogical = glm::inverse(this->Space.toWorld);
    const glm::dvec3 size = this->Upper - this->Lower;
    // To the light, or out of the bounds.
    glm::dvec3 path = light.positional
      ? toLogical * light.position + this->Space.corner - place
      : 1e3 * glm::length(size) * glm::normalize(toLogical * -light.direction);
    if (reach < 1.0)
    {
      const double most = std::sqrt(3.0) * (1.0 - std::pow(1.0 - reach, 0.33));
      path *= std::min(1.0, most / glm::length(path / size));
    }
    double part = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double face = path[axis] > 0.0 ? this->Upper[axis] : this->Lower[axis];
      part = path[axis] != 0.0 ? std::min(part, (face - place[axis]) / path[axis]) : part;
    }
    path *= std::max(part, 0.0);
    const auto samples =
      static_cast<std::size_t>(std::ceil(glm::length(path) / this->Settings.shadowStep));
    double depth = 0.0;
    for (std::size_t i = 0; i < samples; ++i)
    {
      const std::optional<double> value =
        this->Field(place + (static_cast<double>(i) + 0.5) / static_cast<double>(samples) * path);
      depth -= value ? std::log1p(-this->Transfer.evaluate(*value).a) : 0.0;
    }
    const double length =
      glm::length(this->Space.logicalToData * path) / this->Settings.opacityUnitDistance;
    return samples > 0 ? std::exp(-depth * length / static_cast<double>(samples)) : 1.0;
  }

  const FieldFunction& Field;
  const glm::dvec3 Lower;
  const glm::dvec3 Upper;
  const LitSpace& Space;
  const TransferFunction& Transfer;
  const ShadedSettings& Settings;
};
}

Image renderShaded(const FieldFunction& field, const Box& bounds, const View& view,
  const glm::dmat4& logicalToWorld, const TransferFunction& transfer,
  const ShadedSettings& settings)
{
  const LitSpace space(
    logicalToWorld, bounds, settings.lighting ? settings.lighting->dataToWorld : glm::dmat3(1.0));
  const Shadows shadows(field, bounds, space, transfer, settings);
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
        glm::dvec3 gradient = findGradient(field, bounds, place);
        double depth = -std::log1p(-color.a) * piece / settings.opacityUnitDistance;
        if (settings.gradientOpacity)
        {
          depth *= settings.gradientOpacity(space.magnitudeOf(gradient));
        }
        const double alpha = -std::expm1(-depth);
        if (settings.lighting && settings.lighting->normalsOfOpacity)
        {
          gradient *=
            glm::sign(transfer.evaluate(*value + 1e-7).a - transfer.evaluate(*value - 1e-7).a);
        }
        glm::dvec3 lit(color);
        if (settings.lighting)
        {
          LitMedium medium;
          if (settings.lighting->scattering)
          {
            medium = { color.a, shadows.sharesAt(place) };
          }
          lit = space.shade(lit, *settings.lighting, settings.lighting->materials[0], place,
            gradient, path, medium);
        }
        sum += (1.0 - sum.a) * alpha * glm::dvec4(lit, 1.0);
      }
      return sum;
    });
}
}
}
