// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Shaded.h"

#include "Reference/BoundedRay.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
Image renderShaded(const FieldFunction& field, const Box& bounds, const View& view,
  const glm::dmat4& logicalToWorld, const TransferFunction& transfer,
  const ShadedSettings& settings)
{
  const LitSpace space(
    logicalToWorld, bounds, settings.lighting ? settings.lighting->dataToWorld : glm::dmat3(1.0));
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
          depth *= settings.gradientOpacity(space.magnitudeOf(gradient));
        }
        const double alpha = -std::expm1(-depth);
        glm::dvec3 lit(color);
        if (settings.lighting)
        {
          lit = space.shade(
            lit, *settings.lighting, settings.lighting->materials[0], place, gradient, path);
        }
        sum += (1.0 - sum.a) * alpha * glm::dvec4(lit, 1.0);
      }
      return sum;
    });
}
}
}
