// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Projection.h"

#include "Reference/BoundedRay.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
// What the samples of one ray come to.
struct Statistics
{
  double greatest = -1.0;
  double least = 2.0;
  double sum = 0.0;     // of opacity times value times length
  double counted = 0.0; // length on which values count
  double met = 0.0;     // length on which there are values
};

Statistics sampleRay(const Oracle& oracle, const BoundedRay& ray, const TransferFunction& transfer,
  const ProjectionSettings& settings)
{
  Statistics found;
  const double length = glm::length(ray.to - ray.from);
  const auto samples = static_cast<std::size_t>(std::ceil(length / settings.step));
  for (std::size_t i = 0; i < samples; ++i)
  {
    const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(samples);
    const std::optional<double> value =
      oracle.sample(glm::mix(ray.from, ray.to, at), settings.reconstruction);
    if (!value)
    {
      continue;
    }
    const double piece =
      ray.worldLength / static_cast<double>(samples) / settings.opacityUnitDistance;
    found.greatest = std::max(found.greatest, *value);
    found.least = std::min(found.least, *value);
    found.met += piece;
    if (settings.blending != Blending::Average ||
      (*value >= settings.averageRange.x && *value <= settings.averageRange.y))
    {
      found.sum += transfer.evaluate(*value).a * *value * piece;
      found.counted += piece;
    }
  }
  return found;
}

glm::dvec4 toPixel(const Statistics& found, const TransferFunction& transfer, Blending blending)
{
  if (found.met == 0.0)
  {
    return glm::dvec4(0.0);
  }
  if (blending == Blending::Maximum || blending == Blending::Minimum)
  {
    const glm::dvec4 color =
      transfer.evaluate(blending == Blending::Maximum ? found.greatest : found.least);
    return color.a * glm::dvec4(color.r, color.g, color.b, 1.0);
  }
  if (blending == Blending::Average && found.counted == 0.0)
  {
    return glm::dvec4(0.0);
  }
  const double grey =
    std::clamp(found.sum / (blending == Blending::Average ? found.counted : 1.0), 0.0, 1.0);
  return { grey, grey, grey, 1.0 };
}
}

Image project(const Oracle& oracle, const Box& bounds, const View& view,
  const TransferFunction& transfer, const ProjectionSettings& settings)
{
  return drawRays(view, bounds,
    [&](const BoundedRay& ray)
    { return toPixel(sampleRay(oracle, ray, transfer, settings), transfer, settings.blending); });
}
}
}
