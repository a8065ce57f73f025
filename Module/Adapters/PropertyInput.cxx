// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/PropertyInput.h"

#include "Adapters/CutawayInput.h"

#include "Layout.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

namespace exabricks
{
namespace
{
// Copying a property makes a function of gradients that is 1 everywhere, for which nobody asked.
bool changesOpacity(vtkPiecewiseFunction* gradientOpacity)
{
  double node[4]; // value, opacity, midpoint, sharpness
  for (int i = 0; i < gradientOpacity->GetSize(); ++i)
  {
    gradientOpacity->GetNodeValue(i, node);
    if (node[1] != 1.0)
    {
      return true;
    }
  }
  return gradientOpacity->GetSize() == 0 || !gradientOpacity->GetClamping();
}

bool changesShaders(vtkShaderProperty* shaders)
{
  return shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
    shaders->HasFragmentShaderCode() || shaders->HasGeometryShaderCode();
}

// Volume mappers of earlier versions of VTK have no such setting.
template <typename Mapper>
auto takesNormalsFromOpacity(Mapper* mapper, int) -> decltype(mapper->GetComputeNormalFromOpacity())
{
  return mapper->GetComputeNormalFromOpacity();
}
template <typename Mapper>
bool takesNormalsFromOpacity(Mapper*, ...)
{
  return false;
}
}

bool takesNormalsFromOpacity(vtkVolumeMapper* mapper) { return takesNormalsFromOpacity(mapper, 0); }

bool isIndependent(vtkVolumeProperty* property, const BrickedVolume& bricked)
{
  return bricked.volume.components() == 1 ||
    (property->GetIndependentComponents() != 0 && !bricked.joined);
}

bool hasGradientOpacity(vtkVolumeProperty* property, int component)
{
  return !property->GetDisableGradientOpacity(component) &&
    property->HasGradientOpacity(component) &&
    changesOpacity(property->GetGradientOpacity(component));
}

bool hasCategories(vtkVolumeProperty* property, int component)
{
  return property->GetColorChannels(component) == 3 &&
    property->GetRGBTransferFunction(component)->GetIndexedLookup();
}

bool countsGradientOpacity(vtkVolumeMapper* mapper) { return isOfPlaces(findBlending(mapper)); }

std::string describeGradientOpacityElsewhere()
{
  return "Gradient opacity counts with blend modes composite, iso-surface and slice: the volume is "
         "drawn without it.";
}

std::vector<std::string> checkCategories(
  vtkVolumeProperty* property, const BrickedVolume& bricked, Reconstruction reconstruction)
{
  const int first = bricked.propertyComponent;
  const int end = first + static_cast<int>(bricked.volume.components());
  for (int k = first; k < end && reconstruction != Reconstruction::Nearest; ++k)
  {
    if (hasCategories(property, k))
    {
      return { "Colors of categories (IndexedLookup) have no meaning for values between those of "
               "cells: the volume is drawn with the colors between the nodes of the color "
               "function. Call SetReconstructionToNearest() for the colors of categories." };
    }
  }
  return {};
}

Requests checkWithoutData(vtkVolumeMapper* mapper, vtkVolume* volume)
{
  vtkVolumeProperty* property = volume->GetProperty();
  Requests requests;
  if (volume->IsA("vtkMultiVolume"))
  {
    requests.refused =
      "expected a vtkVolume, found a vtkMultiVolume, which takes VTK's GPU mapper of "
      "images alone. Add a vtkVolume to the renderer for each AMR";
    return requests;
  }
  const int mode = mapper->GetBlendMode();
  if (mode < vtkVolumeMapper::COMPOSITE_BLEND || mode > vtkVolumeMapper::SLICE_BLEND)
  {
    requests.refused = "expected one of vtkVolumeMapper's blend modes, found " +
      std::to_string(mode) + ". Call SetBlendModeToComposite()";
    return requests;
  }
  requests.refused = checkCutaway(mapper);
  if (requests.refused.empty() && mode == vtkVolumeMapper::SLICE_BLEND)
  {
    requests.refused = checkSlice(volume);
  }
  const int isoValues = property->GetIsoSurfaceValues()->GetNumberOfContours();
  if (mode == vtkVolumeMapper::ISOSURFACE_BLEND &&
    isoValues > static_cast<int>(layout::MOST_ISO_VALUES))
  {
    requests.refused = "expected at most " + std::to_string(layout::MOST_ISO_VALUES) +
      " iso-values for blend mode iso-surface, found " + std::to_string(isoValues) +
      ". Call GetIsoSurfaceValues()->SetValue() of the volume property";
    return requests;
  }
  for (int i = 0; mode == vtkVolumeMapper::ISOSURFACE_BLEND && i < isoValues; ++i)
  {
    const double value = property->GetIsoSurfaceValues()->GetValue(i);
    if (!std::isfinite(value))
    {
      requests.refused = "expected finite iso-values, found " + std::to_string(value) +
        ". Call GetIsoSurfaceValues()->SetValue() of the volume property";
      return requests;
    }
  }
  const auto without = [&](const std::string& what) { requests.drawnWithout.push_back(what); };
  if (mode == vtkVolumeMapper::ISOSURFACE_BLEND && isoValues == 0)
  {
    without("Nothing is drawn, as there is no iso-value for blend mode iso-surface: call "
            "GetIsoSurfaceValues()->SetValue() of the volume property.");
  }
  if (!countsGradientOpacity(mapper) && hasGradientOpacity(property))
  {
    without(describeGradientOpacityElsewhere());
  }
  if (changesShaders(volume->GetShaderProperty()))
  {
    without("There are none of VTK's shaders in which vtkShaderProperty could replace anything: "
            "the volume is drawn without its replacements and codes.");
  }
  if (property->GetUseClippedVoxelIntensity())
  {
    without("Normals are those of the whole field, and nothing is shaded by a cut: "
            "ClippedVoxelIntensity of the volume property is not supported, and the volume is "
            "drawn without it.");
  }
  return requests;
}

std::string checkNumbers(vtkVolumeProperty* property, const MapperSettings& settings)
{
  const ColorWindow& colors = settings.colors;
  if (!std::isfinite(colors.window) || colors.window == 0.0 || !std::isfinite(colors.level))
  {
    return "expected a finite FinalColorWindow that is not 0 and a finite FinalColorLevel, found " +
      std::to_string(colors.window) + " and " + std::to_string(colors.level);
  }
  const double unit = property->GetScalarOpacityUnitDistance(0);
  if (unit > 0.0 && std::isfinite(unit) && std::isfinite(settings.stepScale) &&
    std::isfinite(settings.errorTolerance) && std::isfinite(settings.sampleDistance))
  {
    return {};
  }
  return "expected a finite, positive ScalarOpacityUnitDistance, and a finite StepScale, "
         "SampleDistance and ErrorTolerance, found " +
    std::to_string(unit) + ", " + std::to_string(settings.stepScale) + ", " +
    std::to_string(settings.sampleDistance) + " and " + std::to_string(settings.errorTolerance);
}

Requests checkTransparency(
  vtkVolumeProperty* property, const TransferFunction& transfer, const BrickedVolume& bricked)
{
  constexpr double nextToNothing = 0.02; // opacity: five of 255 steps
  double most = 0.0;
  for (const TransferFunction::Point& point : transfer.points())
  {
    most = std::max(most, point.color.a);
  }
  const double unit = property->GetScalarOpacityUnitDistance(0);
  const double length =
    glm::length(0.5 * bricked.spacing * glm::dvec3(bricked.volume.structure->tree.size));
  const double opacity = -std::expm1(std::log1p(-std::min(most, 1.0 - 1e-12)) * length / unit);
  if (most == 0.0 || opacity >= nextToNothing)
  {
    return {};
  }
  std::ostringstream text;
  text.precision(2);
  text << "The volume is nearly transparent: through all of it, a length of " << length
       << ", an opacity of at most " << most << " in a ScalarOpacityUnitDistance of " << unit
       << " comes to no more than " << opacity
       << ". Call SetScalarOpacityUnitDistance() of the volume property, for example with "
       << length / 50.0 << ".";
  return { {}, { text.str() } };
}

Blending findBlending(vtkVolumeMapper* mapper) { return toBlending(mapper->GetBlendMode()); }

Blending toBlending(int mode)
{
  switch (mode)
  {
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return Blending::Maximum;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return Blending::Minimum;
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return Blending::Average;
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return Blending::Additive;
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      return Blending::Isosurface;
    case vtkVolumeMapper::SLICE_BLEND:
      return Blending::Slice;
    default:
      return Blending::Composite;
  }
}

AverageRanges findAverageRanges(vtkVolumeMapper* mapper, const Volume& volume)
{
  const double* values = mapper->GetAverageIPScalarRange();
  AverageRanges ranges = wholeAverageRanges();
  for (std::size_t k = 0; k < std::min(volume.components(), ranges.size()); ++k)
  {
    const Range& range = volume.valuesOf(k)->range;
    ranges[k] = { range.normalize(values[0]), range.normalize(values[1]) };
  }
  return ranges;
}

bool canUseNanColor(vtkVolumeMapper* mapper, vtkVolumeProperty* property, int components)
{
  return mayShowUndefined(findBlending(mapper)) && components == 1 &&
    property->GetColorChannels() == 3 &&
    property->GetTransferFunctionMode() == vtkVolumeProperty::TF_1D;
}

glm::dvec4 findNanColor(vtkVolumeProperty* property)
{
  vtkColorTransferFunction* colors = property->GetRGBTransferFunction();
  const double* const color = colors->GetNanColor();
  return glm::clamp(glm::dvec4(color[0], color[1], color[2], colors->GetNanOpacity()),
    glm::dvec4(0.0), glm::dvec4(1.0));
}

std::vector<double> findIsoValues(vtkVolumeProperty* property, const Range& range)
{
  vtkContourValues* from = property->GetIsoSurfaceValues();
  std::vector<double> values;
  for (int i = 0; i < from->GetNumberOfContours(); ++i)
  {
    values.push_back(range.normalize(from->GetValue(i)));
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

TransferFunction makeTransferFunction(vtkVolumeProperty* property, int component,
  vtkPiecewiseFunction* opacity, const Range& range, ColorsOf colors)
{
  return property->GetColorChannels(component) == 1
    ? makeTransferFunction(property->GetGrayTransferFunction(component), opacity, range)
    : makeTransferFunction(property->GetRGBTransferFunction(component), opacity, range, colors);
}

TransferFunction makeTransferFunction(
  vtkVolumeProperty* property, const Range& range, ColorsOf colors)
{
  return makeTransferFunction(property, 0, property->GetScalarOpacity(0), range, colors);
}
}
