// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/MediumInput.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
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

std::string checkPlanar(vtkVolumeProperty* property, int component)
{
  vtkImageData* function = property->GetTransferFunction2D(component);
  vtkDataArray* colors = function ? function->GetPointData()->GetScalars() : nullptr;
  const int* const size = function ? function->GetDimensions() : nullptr;
  if (colors && colors->GetNumberOfComponents() == 4 && size[0] > 0 && size[1] > 0 &&
    colors->GetNumberOfTuples() >= static_cast<vtkIdType>(size[0]) * size[1])
  {
    return {};
  }
  return std::string("expected a 2-D transfer function of four components, red, green, blue and "
                     "opacity, found ") +
    (colors ? std::to_string(colors->GetNumberOfComponents()) + " components" : "none") +
    ". Call SetTransferFunction2D() of the volume property, or SetTransferFunctionMode()";
}

TransferFunction2D makePlanar(vtkImageData* from)
{
  vtkDataArray* colors = from->GetPointData()->GetScalars();
  TransferFunction2D function;
  function.width = from->GetDimensions()[0];
  function.height = from->GetDimensions()[1];
  function.pixels.resize(static_cast<std::size_t>(function.width) * function.height);
  for (std::size_t i = 0; i < function.pixels.size(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const double part = colors->GetComponent(static_cast<vtkIdType>(i), k);
      function.pixels[i][k] = part > 0.0 ? static_cast<float>(std::min(part, 1.0)) : 0.0f;
    }
  }
  return function;
}
}

bool isPlanar(vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  return property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D &&
    (bricked.volume.components() == 1 || bricked.joined);
}

Requests checkMedium(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  Requests requests;
  const int components = static_cast<int>(bricked.volume.components());
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    if (isPlanar(property, bricked))
    {
      requests.refused = checkPlanar(property, bricked.propertyComponent);
      return requests;
    }
    requests.drawnWithout.push_back(
      "2-D transfer functions are of one component, or of two arrays (SetTransfer2DYAxisArray()): "
      "the volume is drawn with the 1-D functions.");
  }
  if (components == 1)
  {
    return requests;
  }
  const bool independent = isIndependent(property, bricked);
  if (mapper->GetBlendMode() == vtkVolumeMapper::ISOSURFACE_BLEND && components == 4)
  {
    requests.refused =
      "expected components that have values for blend mode iso-surface, found red, green, blue and "
      "opacity. Choose one, or the magnitude, by the mapper's VectorMode, or call "
      "IndependentComponentsOn() of the volume property";
    return requests;
  }
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
    if (!countsGradientOpacity(mapper) && hasGradientOpacity(property, k))
    {
      requests.drawnWithout.push_back(describeGradientOpacityElsewhere());
    }
  }
  return requests;
}

std::optional<int> findSurfaceComponent(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  const int components = static_cast<int>(bricked.volume.components());
  if (mapper->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND || components == 1 ||
    isPlanar(property, bricked) || !isIndependent(property, bricked))
  {
    return std::nullopt;
  }
  int heaviest = 0;
  for (int k = 1; k < components; ++k)
  {
    heaviest =
      property->GetComponentWeight(k) > property->GetComponentWeight(heaviest) ? k : heaviest;
  }
  return heaviest;
}

Medium makeMedium(
  vtkVolumeProperty* property, const BrickedVolume& bricked, bool planar, ColorsOf colors)
{
  const Volume& volume = bricked.volume;
  const auto rangeOf = [&](std::size_t k) -> const Range& { return volume.valuesOf(k)->range; };
  Medium medium;
  if (planar)
  {
    medium.mixing = Mixing::Planar;
    medium.planar = makePlanar(property->GetTransferFunction2D(bricked.propertyComponent));
    return medium;
  }
  if (isIndependent(property, bricked))
  {
    const double unit = property->GetScalarOpacityUnitDistance(0); // that of the view
    for (int k = 0; k < static_cast<int>(volume.components()); ++k)
    {
      medium.functions.push_back(
        makeTransferFunction(property, k, property->GetScalarOpacity(k), rangeOf(k), colors));
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
    medium.functions = { makeTransferFunction(property, 0, opaque, rangeOf(0), colors),
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
