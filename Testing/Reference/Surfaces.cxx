// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Surfaces.h"

#include "Reference/BoundedRay.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
Image drawSurfaces(const FieldFunction& field, const Box& bounds, const View& view,
  const TransferFunction& transfer, const std::vector<double>& isoValues, double step)
{
  return drawRays(view, bounds,
    [&](const BoundedRay& ray)
    {
      const glm::dvec3 path = ray.to - ray.from;
      const auto samples = static_cast<std::size_t>(std::ceil(glm::length(path) / step));
      glm::dvec4 sum(0.0);
      std::optional<double> before;
      for (std::size_t i = 0; i <= samples; ++i)
      {
        // From end to end, but just inside of the bounds.
        const double at =
          glm::clamp(static_cast<double>(i) / static_cast<double>(samples), 1e-9, 1.0 - 1e-9);
        const std::optional<double> value = field(ray.from + at * path);
        for (std::size_t k = 0; before && value && k < isoValues.size(); ++k)
        {
          const double isoValue = isoValues[*value > *before ? k : isoValues.size() - 1 - k];
          if ((*before < isoValue) != (*value < isoValue))
          {
            const glm::dvec4 color = transfer.evaluate(isoValue);
            sum += (1.0 - sum.a) * color.a * glm::dvec4(glm::dvec3(color), 1.0);
          }
        }
        before = value;
      }
      return sum;
    });
}
}
}
