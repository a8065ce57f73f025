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

void checkComponents(
  vtkVolumeProperty* property, int components, bool vectorModeChosen, Requests& requests)
{
  if (components == 1)
  {
    return;
  }
  if (!property->GetIndependentComponents())
  {
    requests.refused = "expected independent components, found " + std::to_string(components) +
      " dependent ones (such as RGBA), which are not supported yet. Call IndependentComponentsOn() "
      "of the volume property, and choose a component or the magnitude";
    return;
  }
  if (!vectorModeChosen)
  {
    requests.drawnWithout.push_back(
      "Several independent components are not supported yet: of the " + std::to_string(components) +
      " of the array the magnitude is drawn, with the functions of component 0. Call "
      "SetVectorModeToMagnitude() if that is meant, or SetVectorModeToComponent() and "
      "SetVectorComponent().");
  }
  for (int component = 0; component < std::min(components, VTK_MAX_VRCOMP); ++component)
  {
    if (property->GetComponentWeight(component) != 1.0)
    {
      requests.drawnWithout.push_back("Weights of components are not supported yet: the volume is "
                                      "drawn without them.");
      break;
    }
  }
}

void checkValues(vtkVolumeProperty* property, const MapperSettings& settings, Requests& requests)
{
  const double unit = property->GetScalarOpacityUnitDistance(0);
  if (!(unit > 0.0) || !std::isfinite(unit) || !std::isfinite(settings.stepScale) ||
    !std::isfinite(settings.errorTolerance))
  {
    requests.refused =
      "expected a finite, positive ScalarOpacityUnitDistance, a finite StepScale and a finite "
      "ErrorTolerance, found " +
      std::to_string(unit) + ", " + std::to_string(settings.stepScale) + " and " +
      std::to_string(settings.errorTolerance);
  }
}
}

bool hasGradientOpacity(vtkVolumeProperty* property)
{
  return !property->GetDisableGradientOpacity(0) && property->HasGradientOpacity(0) &&
    changesOpacity(property->GetGradientOpacity(0));
}

Requests checkWithoutData(vtkVolumeMapper* mapper, vtkVolume* volume)
{
  vtkVolumeProperty* property = volume->GetProperty();
  static const char* const blendModes[] = { "composite", "maximum intensity", "minimum intensity",
    "average intensity", "additive", "iso-surface", "slice" };
  Requests requests;
  const int mode = mapper->GetBlendMode();
  if (mode < vtkVolumeMapper::COMPOSITE_BLEND || mode > vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    const bool known = mode >= 0 && mode < static_cast<int>(std::size(blendModes));
    requests.refused = std::string("expected blend mode composite, maximum, minimum or average "
                                   "intensity, additive or iso-surface, found ") +
      (known ? blendModes[mode] : std::to_string(mode).c_str()) +
      ", which is not supported yet. Call SetBlendModeToComposite()";
    return requests;
  }
  requests.refused = checkCutaway(mapper);
  const int isoValues = property->GetIsoSurfaceValues()->GetNumberOfContours();
  if (mode == vtkVolumeMapper::ISOSURFACE_BLEND &&
    (isoValues < 1 || isoValues > static_cast<int>(layout::MOST_ISO_VALUES)))
  {
    requests.refused = "expected 1 to " + std::to_string(layout::MOST_ISO_VALUES) +
      " iso-values for blend mode iso-surface, found " + std::to_string(isoValues) +
      ". Call GetIsoSurfaceValues()->SetValue() of the volume property";
    return requests;
  }
  const auto without = [&](const std::string& what) { requests.drawnWithout.push_back(what); };
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    without(
      "2-D transfer functions are not supported yet: the volume is drawn with the 1-D functions.");
  }
  if (volume->GetShaderProperty()->GetNumberOfShaderReplacements() > 0)
  {
    without(
      "Replacements in VTK's shaders (vtkShaderProperty) are not supported yet: the volume is "
      "drawn without them.");
  }
  if (property->GetColorChannels(0) == 3 && property->GetRGBTransferFunction(0)->GetIndexedLookup())
  {
    without("Colors of categories (IndexedLookup) are not supported yet: the volume is drawn with "
            "the colors between the nodes of the color function.");
  }
  return requests;
}

Requests checkWithData(vtkVolumeProperty* property, const MapperSettings& settings, int components)
{
  Requests requests;
  checkComponents(property, components, settings.vectorModeChosen, requests);
  if (requests.refused.empty())
  {
    checkValues(property, settings, requests);
  }
  return requests;
}

Blending findBlending(vtkVolumeMapper* mapper)
{
  switch (mapper->GetBlendMode())
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
    default:
      return Blending::Composite;
  }
}

glm::dvec2 findAverageRange(vtkVolumeMapper* mapper, const Range& range)
{
  const double* values = mapper->GetAverageIPScalarRange();
  return { range.normalize(values[0]), range.normalize(values[1]) };
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

TransferFunction makeTransferFunction(vtkVolumeProperty* property, const Range& range)
{
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity(0);
  return property->GetColorChannels(0) == 1
    ? makeTransferFunction(property->GetGrayTransferFunction(0), opacity, range)
    : makeTransferFunction(property->GetRGBTransferFunction(0), opacity, range);
}
}
