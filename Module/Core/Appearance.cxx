// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Appearance.h"

namespace exabricks
{
bool showTheSame(const Visibility& a, const Visibility& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const std::optional<TransferFunction>& first, const std::optional<TransferFunction>& second)
    { return first && second ? first->showsTheSame(*second) : !first && !second; });
}

std::string Appearance::checkMedium() const
{
  if (!this->isMixed())
  {
    return {};
  }
  const Mixing mixing = this->Mixed.mixing;
  if (mixing == Mixing::Planar)
  {
    return this->Components <= 2 && !this->Mixed.planar.empty()
      ? ""
      : "expected one component or two for a function of two variables, found " +
        std::to_string(this->Components);
  }
  const std::size_t wanted = mixing == Mixing::ColorAndOpacity ? 2
    : mixing == Mixing::RGBA                                   ? 4
                                                               : this->Components;
  const std::size_t functions = mixing == Mixing::RGBA ? 1 : wanted;
  return this->Components == wanted && this->Components <= layout::MOST_COMPONENTS &&
      this->Mixed.functions.size() == functions
    ? ""
    : "the functions do not fit the volume's " + std::to_string(this->Components) + " components";
}

bool Appearance::setView(const View& view)
{
  const AverageRanges& ranges =
    view.blending == Blending::Average ? view.averageRanges : this->Averaged;
  const std::vector<double>& isoValues =
    view.blending == Blending::Isosurface ? view.isoValues : this->IsoValues;
  const bool ofCells = view.blending == Blending::Isosurface
    ? view.quality.reconstruction == Reconstruction::Nearest
    : this->SurfacesOfCells;
  const bool undefined = mayShowUndefined(view.blending) && view.undefinedColor;
  if (undefined == this->Undefined && view.blending == this->Blended && ranges == this->Averaged &&
    isoValues == this->IsoValues && ofCells == this->SurfacesOfCells)
  {
    return false;
  }
  this->Blended = view.blending;
  this->Averaged = ranges;
  this->IsoValues = isoValues;
  this->SurfacesOfCells = ofCells;
  this->Undefined = undefined;
  return true;
}

std::vector<TransferTable> Appearance::makeTables() const
{
  const TransferTable::Amount amount = this->Blended == Blending::Composite
    ? TransferTable::Amount::Extinction
    : TransferTable::Amount::Opacity;
  std::vector<TransferTable> tables;
  if (this->Mixed.mixing == Mixing::Planar)
  {
    // Its march looks up the function itself.
    tables.emplace_back(this->Mixed.planar.envelope(), amount);
    return tables;
  }
  if (!this->isMixed())
  {
    tables.emplace_back(findLookup(this->Transfer, this->Blended, this->Averaged[0]), amount);
    return tables;
  }
  for (const TransferFunction& function : this->Mixed.functions)
  {
    if (this->Mixed.mixing == Mixing::Independent)
    {
      tables.emplace_back(
        findLookup(function, this->Blended, this->Averaged[tables.size()]), amount);
      continue;
    }
    const bool isColor = this->Mixed.mixing == Mixing::ColorAndOpacity && tables.empty();
    tables.emplace_back(function, isColor ? TransferTable::Amount::Opacity : amount);
  }
  return tables;
}

Visibility Appearance::findVisibility() const
{
  // Where values are those of cells, a surface lies at a face between two of them, of which
  // either may be in a region that does not reach the surface's value: all regions count.
  const Blending blending = this->Blended == Blending::Isosurface && this->SurfacesOfCells
    ? Blending::Maximum
    : this->Blended;
  const auto find = [&](const TransferFunction& function, std::size_t component)
  {
    return exabricks::findVisibility(
      function, blending, this->Averaged[component], this->IsoValues);
  };
  if (!this->isMixed())
  {
    return { find(this->Transfer, 0) };
  }
  Visibility shown(this->Components);
  if (!this->checkMedium().empty())
  {
    return shown;
  }
  if (this->Mixed.mixing == Mixing::Planar)
  {
    shown[0] = find(this->Mixed.planar.envelope(), 0);
    return shown;
  }
  if (this->Mixed.mixing == Mixing::Independent)
  {
    for (std::size_t k = 0; k < this->Mixed.functions.size(); ++k)
    {
      if (this->Mixed.weights[static_cast<glm::length_t>(k)] > 0.0)
      {
        shown[k] = find(this->Mixed.functions[k], k);
      }
    }
    return shown;
  }
  // The last component has opacity; of an average, and of surfaces, the values of the first one
  // count.
  const bool byFirst = this->Blended == Blending::Average || this->Blended == Blending::Isosurface;
  const std::size_t component = byFirst ? 0 : this->Components - 1;
  shown[component] = find(this->Mixed.functions.back(), component);
  return shown;
}

Extreme Appearance::extreme() const
{
  return this->isMixed()                 ? Extreme::None
    : this->Blended == Blending::Maximum ? Extreme::Greatest
    : this->Blended == Blending::Minimum ? Extreme::Least
                                         : Extreme::None;
}
}
