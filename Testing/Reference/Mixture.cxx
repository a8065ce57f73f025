// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Mixture.h"

#include "Reference/BoundedRay.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
double extinctionOf(double opacity) { return -std::log1p(-std::min(opacity, 1.0 - 1e-12)); }

// One ray through the components.
class Mixture
{
public:
  Mixture(const std::vector<FieldFunction>& components, const Box& bounds, const Medium& medium,
    const MixtureSettings& settings)
    : Components(components)
    , Bounds(bounds)
    , Looks(medium)
    , Settings(settings)
    , Space(settings.logicalToWorld, bounds,
        settings.lighting ? settings.lighting->dataToWorld : glm::dmat3(1.0))
    , Independent(medium.mixing == Mixing::Independent)
    , Functions(this->Independent ? components.size() : 1)
  {
  }

  glm::dvec4 look(const BoundedRay& ray) const
  {
    const double length = glm::length(ray.to - ray.from);
    const auto samples = static_cast<std::size_t>(std::ceil(length / this->Settings.step));
    const double units =
      ray.worldLength / static_cast<double>(samples) / this->Settings.opacityUnitDistance;
    std::vector<double> values;
    std::vector<double> extreme;
    std::vector<double> sums(this->Functions, 0.0);
    std::vector<double> counts(this->Functions, 0.0);
    glm::dvec4 color(0.0);
    for (std::size_t i = 0; i < samples; ++i)
    {
      const glm::dvec3 place =
        glm::mix(ray.from, ray.to, (static_cast<double>(i) + 0.5) / static_cast<double>(samples));
      if (!this->Sample(place, values))
      {
        continue;
      }
      switch (this->Settings.blending)
      {
        case Blending::Composite:
          this->Composite(values, place, ray.to - ray.from, units, color);
          break;
        case Blending::Maximum:
        case Blending::Minimum:
          this->Widen(values, extreme);
          break;
        default:
          this->Sum(values, units, sums, counts);
          break;
      }
    }
    if (this->Settings.blending == Blending::Composite)
    {
      return color;
    }
    return this->Settings.blending == Blending::Maximum ||
        this->Settings.blending == Blending::Minimum
      ? this->ColorOfExtreme(extreme)
      : this->ColorOfSums(sums, counts);
  }

private:
  // The component of which a function of opacity is.
  std::size_t ComponentOf(std::size_t function) const
  {
    return this->Independent                 ? function
      : this->Looks.mixing == Mixing::Planar ? 0
                                             : this->Components.size() - 1;
  }

  // Of a function of one component and its gradient the second value is the gradient's share.
  bool Sample(const glm::dvec3& place, std::vector<double>& values) const
  {
    values.clear();
    for (const FieldFunction& component : this->Components)
    {
      const std::optional<double> value = component(place);
      if (!value)
      {
        return false;
      }
      values.push_back(*value);
    }
    if (this->Looks.mixing == Mixing::Planar && values.size() == 1)
    {
      const glm::dvec3 gradient = findGradient(this->Components[0], this->Bounds, place);
      values.push_back(
        std::min(this->Space.magnitudeOf(gradient) / layout::GREATEST_GRADIENT, 1.0));
    }
    return true;
  }

  // Red, green and blue, and opacity, by a function of opacity.
  glm::dvec4 LookUp(const std::vector<double>& values, std::size_t function) const
  {
    if (this->Looks.mixing == Mixing::Planar)
    {
      return this->Looks.planar.evaluate(values[0], values[1]);
    }
    if (this->Looks.mixing == Mixing::ColorAndOpacity)
    {
      return glm::dvec4(glm::dvec3(this->Looks.functions[0].evaluate(values[0])),
        this->Looks.functions[1].evaluate(values[1]).a);
    }
    glm::dvec4 color =
      this->Looks.functions[function].evaluate(values[this->ComponentOf(function)]);
    for (int k = 0; k < 3 && this->Looks.mixing == Mixing::RGBA; ++k)
    {
      color[k] = this->Looks.colorOffset[k] +
        this->Looks.colorScale[k] * values[static_cast<std::size_t>(k)];
    }
    return color;
  }

  double WeightOf(std::size_t function) const
  {
    return this->Independent ? this->Looks.weights[static_cast<int>(function)] : 1.0;
  }

  void Composite(const std::vector<double>& values, const glm::dvec3& place, const glm::dvec3& path,
    double units, glm::dvec4& gathered) const
  {
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0; i < this->Functions; ++i)
    {
      const glm::dvec4 color = this->LookUp(values, i);
      double extinction = this->WeightOf(i) * extinctionOf(color.a);
      if (!(extinction > 0.0))
      {
        continue;
      }
      glm::dvec3 gradient(0.0);
      if (this->Settings.lighting || !this->Settings.gradientOpacity.empty())
      {
        gradient = findGradient(this->Components[this->ComponentOf(i)], this->Bounds, place);
      }
      if (!this->Settings.gradientOpacity.empty())
      {
        extinction *= this->Settings.gradientOpacity[i](this->Space.magnitudeOf(gradient));
      }
      glm::dvec3 lit(color);
      if (this->Settings.lighting)
      {
        lit = this->Space.shade(lit, *this->Settings.lighting,
          this->Settings.lighting->materials[i], place, gradient, path);
      }
      sum += extinction * glm::dvec4(lit, 1.0);
    }
    if (sum.a > 0.0)
    {
      gathered += (1.0 - gathered.a) * (-std::expm1(-sum.a * units) / sum.a) * sum;
    }
  }

  void Widen(const std::vector<double>& values, std::vector<double>& extreme) const
  {
    if (extreme.empty())
    {
      extreme = values;
    }
    const auto wider = [&](std::size_t k)
    {
      return this->Settings.blending == Blending::Maximum ? values[k] > extreme[k]
                                                          : values[k] < extreme[k];
    };
    if (!this->Independent)
    {
      extreme = wider(this->ComponentOf(0)) ? values : extreme;
      return;
    }
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      extreme[k] = wider(k) ? values[k] : extreme[k];
    }
  }

  glm::dvec4 ColorOfExtreme(const std::vector<double>& extreme) const
  {
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0; i < this->Functions && !extreme.empty(); ++i)
    {
      const glm::dvec4 color = this->LookUp(extreme, i);
      sum += this->WeightOf(i) * color.a * glm::dvec4(glm::dvec3(color), 1.0);
    }
    return glm::clamp(sum, glm::dvec4(0.0), glm::dvec4(1.0));
  }

  void Sum(const std::vector<double>& values, double units, std::vector<double>& sums,
    std::vector<double>& counts) const
  {
    for (std::size_t i = 0; i < this->Functions; ++i)
    {
      const glm::dvec2& range = this->Settings.averageRanges[i];
      if (this->Settings.blending != Blending::Average ||
        (values[i] >= range.x && values[i] <= range.y))
      {
        sums[i] += this->LookUp(values, i).a * values[i] * units;
        counts[i] += units;
      }
    }
  }

  glm::dvec4 ColorOfSums(const std::vector<double>& sums, const std::vector<double>& counts) const
  {
    double sum = 0.0;
    bool any = false;
    for (std::size_t i = 0; i < this->Functions; ++i)
    {
      if (counts[i] > 0.0)
      {
        any = true;
        sum += this->WeightOf(i) *
          (this->Settings.blending == Blending::Average ? sums[i] / counts[i] : sums[i]);
      }
    }
    const double grey = std::clamp(sum, 0.0, 1.0);
    return any ? glm::dvec4(grey, grey, grey, 1.0) : glm::dvec4(0.0);
  }

  const std::vector<FieldFunction>& Components;
  const Box& Bounds;
  const Medium& Looks;
  const MixtureSettings& Settings;
  const LitSpace Space;
  const bool Independent;
  const std::size_t Functions; // of opacity
};
}

Image drawMixture(const std::vector<FieldFunction>& components, const Box& bounds, const View& view,
  const Medium& medium, const MixtureSettings& settings)
{
  const Mixture mixture(components, bounds, medium, settings);
  return drawRays(view, bounds, [&](const BoundedRay& ray) { return mixture.look(ray); });
}
}
}
