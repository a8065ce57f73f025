// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/MediumInput.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace exabricks
{
namespace
{
std::string checkUnits(vtkVolumeProperty* property, int components)
{
  for (int k = 0; k < components; ++k)
  {
    const double unit = property->GetScalarOpacityUnitDistance(k);
    const double weight = property->GetComponentWeight(k);
    if (!(unit > 0.0) || !std::isfinite(unit) || !(weight >= 0.0))
    {
      return "expected a finite, positive ScalarOpacityUnitDistance and a ComponentWeight of at "
             "least 0 of each component, found " +
        std::to_string(unit) + " and " + std::to_string(weight) + " of component " +
        std::to_string(k);
    }
  }
  return {};
}
}

Requests checkMedium(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  Requests requests;
  const int components = static_cast<int>(bricked.volume.components());
  if (mapper->GetBlendMode() == vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    requests.refused = "expected one value of each cell for blend mode iso-surface, found " +
      std::to_string(components) +
      " components. Choose one, or the magnitude, by the mapper's VectorMode";
    return requests;
  }
  const bool independent = property->GetIndependentComponents();
  if (!independent && components == 3)
  {
    requests.refused = "expected 2 or 4 dependent components, found 3. Call "
                       "IndependentComponentsOn() of the volume property, or choose the magnitude "
                       "or one component";
    return requests;
  }
  requests.refused = checkUnits(property, independent ? components : 1);
  for (int k = 1; k < (independent ? components : 1); ++k)
  {
    if (hasCategories(property, k))
    {
      requests.drawnWithout.push_back(describeCategories());
    }
    if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND &&
      hasGradientOpacity(property, k))
    {
      requests.drawnWithout.push_back(describeGradientOpacityElsewhere());
    }
  }
  return requests;
}

Medium makeMedium(vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  const Volume& volume = bricked.volume;
  const auto rangeOf = [&](std::size_t k) -> const Range& { return volume.valuesOf(k)->range; };
  Medium medium;
  if (property->GetIndependentComponents())
  {
    const double unit = property->GetScalarOpacityUnitDistance(0); // that of the view
    for (int k = 0; k < static_cast<int>(volume.components()); ++k)
    {
      medium.functions.push_back(
        makeTransferFunction(property, k, property->GetScalarOpacity(k), rangeOf(k)));
      medium.weights[k] =
        property->GetComponentWeight(k) * unit / property->GetScalarOpacityUnitDistance(k);
    }
    return medium;
  }
  if (volume.components() == 2)
  {
    medium.mixing = Mixing::ColorAndOpacity;
    vtkNew<vtkPiecewiseFunction> opaque;
    opaque->AddPoint(0.0, 1.0);
    medium.functions = { makeTransferFunction(property, 0, opaque, rangeOf(0)),
      makeTransferFunction(property->GetScalarOpacity(0), rangeOf(1)) };
    return medium;
  }
  medium.mixing = Mixing::RGBA;
  medium.functions = { makeTransferFunction(property->GetScalarOpacity(0), rangeOf(3)) };
  for (int k = 0; k < 3; ++k)
  {
    medium.colorScale[k] = (rangeOf(k).max - rangeOf(k).min) / bricked.brightest;
    medium.colorOffset[k] = rangeOf(k).min / bricked.brightest;
  }
  return medium;
}
}
