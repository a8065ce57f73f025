// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Mixture.h"

#include "Reference/BoundedRay.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
double extinctionOf(double opacity) { return -std::log1p(-std::min(opacity, 1.0 - 1e-12)); }

// Of red, green and blue as they are emitted, and of absorption, for a unit distance.
glm::dvec4 findExtinction(const Medium& medium, const std::vector<double>& values)
{
  const auto look = [&](std::size_t function, std::size_t component)
  { return medium.functions[function].evaluate(values[component]); };
  if (medium.mixing == Mixing::ColorAndOpacity)
  {
    return extinctionOf(look(1, 1).a) * glm::dvec4(glm::dvec3(look(0, 0)), 1.0);
  }
  if (medium.mixing == Mixing::RGBA)
  {
    glm::dvec3 color;
    for (int k = 0; k < 3; ++k)
    {
      color[k] = medium.colorOffset[k] + medium.colorScale[k] * values[static_cast<std::size_t>(k)];
    }
    return extinctionOf(look(0, 3).a) * glm::dvec4(color, 1.0);
  }
  glm::dvec4 sum(0.0);
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    const glm::dvec4 color = look(k, k);
    sum += medium.weights[static_cast<int>(k)] * extinctionOf(color.a) *
      glm::dvec4(glm::dvec3(color), 1.0);
  }
  return sum;
}

glm::dvec4 integrateRay(const std::vector<const Oracle*>& components, const BoundedRay& ray,
  const Medium& medium, const MixtureSettings& settings)
{
  const double length = glm::length(ray.to - ray.from);
  const auto samples = static_cast<std::size_t>(std::ceil(length / settings.step));
  const double units =
    ray.worldLength / static_cast<double>(samples) / settings.opacityUnitDistance;
  std::vector<double> values(components.size());
  glm::dvec4 color(0.0);
  for (std::size_t i = 0; i < samples; ++i)
  {
    const glm::dvec3 place =
      glm::mix(ray.from, ray.to, (static_cast<double>(i) + 0.5) / static_cast<double>(samples));
    bool there = true;
    for (std::size_t k = 0; k < components.size(); ++k)
    {
      const std::optional<double> value = components[k]->sample(place, settings.reconstruction);
      there = there && value;
      values[k] = value.value_or(0.0);
    }
    const glm::dvec4 extinction = there ? findExtinction(medium, values) : glm::dvec4(0.0);
    if (extinction.a > 0.0)
    {
      const double opacity = -std::expm1(-extinction.a * units);
      color += (1.0 - color.a) * (opacity / extinction.a) * extinction;
    }
  }
  return color;
}
}

Image drawMixture(const std::vector<const Oracle*>& components, const Box& bounds, const View& view,
  const Medium& medium, const MixtureSettings& settings)
{
  return drawRays(view, bounds,
    [&](const BoundedRay& ray) { return integrateRay(components, ray, medium, settings); });
}
}
}
