// SPDX-License-Identifier: BSD-3-Clause
// What several components of a volume look like together.
#ifndef ExaBricksCoreMedium_h
#define ExaBricksCoreMedium_h

#include "Core/TransferFunction.h"

#include <algorithm>

namespace exabricks
{
/// As vtkVolumeProperty's independent components, and its dependent ones: two or four of them.
enum class Mixing
{
  Independent,     // each has a function and a weight: extinctions add up
  ColorAndOpacity, // the first component has a colour, the second one an opacity
  RGBA             // the first three are red, green and blue, the fourth one has an opacity
};

struct Medium
{
  Mixing mixing = Mixing::Independent;
  /// Independent: of each component. ColorAndOpacity: the colours, with an opacity of 1, and the
  /// opacities, in white. RGBA: the opacities alone, in white.
  std::vector<TransferFunction> functions;
  glm::dvec4 weights{ 1.0 }; // of independent components: by which extinctions are multiplied
  /// RGBA: from normalised values to red, green and blue in [0, 1].
  glm::dvec4 colorScale{ 1.0 };
  glm::dvec4 colorOffset{ 0.0 };

  /// [component]: the function by which it shows; null: it does not matter to what shows.
  std::vector<const TransferFunction*> visibility() const
  {
    switch (this->mixing)
    {
      case Mixing::ColorAndOpacity:
        return { nullptr, &this->functions[1] };
      case Mixing::RGBA:
        return { nullptr, nullptr, nullptr, &this->functions[0] };
      default:
        break;
    }
    std::vector<const TransferFunction*> all;
    for (std::size_t k = 0; k < this->functions.size(); ++k)
    {
      all.push_back(
        this->weights[static_cast<glm::length_t>(k)] > 0.0 ? &this->functions[k] : nullptr);
    }
    return all;
  }
};

/// Whether the same values of the same components show, so that the active regions can be kept.
inline bool showTheSame(const Medium& a, const Medium& b)
{
  if (a.mixing != b.mixing || a.functions.size() != b.functions.size())
  {
    return false;
  }
  const std::vector<const TransferFunction*> ofA = a.visibility();
  const std::vector<const TransferFunction*> ofB = b.visibility();
  return std::equal(ofA.begin(), ofA.end(), ofB.begin(), ofB.end(),
    [](const TransferFunction* first, const TransferFunction* second)
    { return first && second ? first->showsTheSame(*second) : first == second; });
}
}

#endif
