// SPDX-License-Identifier: BSD-3-Clause
// What the user asks of a picture by the volume property and the mapper: its translation for the
// renderer, and beside it, in words, what is refused and what the volume is drawn without.
#ifndef ExaBricksAdaptersPropertyInput_h
#define ExaBricksAdaptersPropertyInput_h

#include "Adapters/BrickedVolume.h"
#include "Adapters/ColorWindow.h"
#include "Adapters/TransferFunctionInput.h"
#include "Core/Blending.h"
#include "Core/View.h"

#include <string>
#include <vector>

class vtkPiecewiseFunction;
class vtkVolume;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace exabricks
{
struct Requests
{
  std::string refused;                   // empty, or why nothing can be drawn
  std::vector<std::string> drawnWithout; // what the volume is drawn without
};

/// What the mapper is asked for beside the property.
struct MapperSettings
{
  double stepScale = 1.0;
  double sampleDistance = 0.0;
  double errorTolerance = 0.0;
  ColorWindow colors;
};

/// Whether the volume's components are drawn each by functions of its own; one is independent too.
bool isIndependent(vtkVolumeProperty* property, const BrickedVolume& bricked);

/// Whether the property's opacity of a component depends on gradients.
bool hasGradientOpacity(vtkVolumeProperty* property, int component = 0);

/// Warns of colours of categories where values between those of cells are drawn.
std::vector<std::string> checkCategories(
  vtkVolumeProperty* property, const BrickedVolume& bricked, Reconstruction reconstruction);
/// Whether gradient opacity counts with the mapper's blend mode, and the warning that it does not.
bool countsGradientOpacity(vtkVolumeMapper* mapper);
std::string describeGradientOpacityElsewhere();

/// Whether normals are asked for of opacity (ComputeNormalFromOpacity, VTK 9.3 and later).
bool takesNormalsFromOpacity(vtkVolumeMapper* mapper);

/// Checks what can be told without data.
Requests checkWithoutData(vtkVolumeMapper* mapper, vtkVolume* volume);

/// Checks the numbers: returns what is refused, or nothing.
std::string checkNumbers(vtkVolumeProperty* property, const MapperSettings& settings);

/// Warns of a volume of which, by its unit distance, next to nothing shows, and says what to try.
Requests checkTransparency(
  vtkVolumeProperty* property, const TransferFunction& transfer, const BrickedVolume& bricked);

/// The mapper's blend mode, which checkWithoutData() has let pass, and the values of each component
/// that count for the average.
Blending findBlending(vtkVolumeMapper* mapper);
/// `mode`: of vtkVolumeMapper::BlendModes; others are taken for composite.
Blending toBlending(int mode);
AverageRanges findAverageRanges(vtkVolumeMapper* mapper, const Volume& volume);
/// Whether cells without a value can have the property's NaN colour, and that colour.
bool canUseNanColor(vtkVolumeMapper* mapper, vtkVolumeProperty* property, int components);
glm::dvec4 findNanColor(vtkVolumeProperty* property);
/// Of the property, over `range`, in ascending order, each once.
std::vector<double> findIsoValues(vtkVolumeProperty* property, const Range& range);

/// The property's colours of a component with `opacity`, over `range` of the component's values.
TransferFunction makeTransferFunction(vtkVolumeProperty* property, int component,
  vtkPiecewiseFunction* opacity, const Range& range, ColorsOf colors);
/// Of component 0, with its own opacity.
TransferFunction makeTransferFunction(
  vtkVolumeProperty* property, const Range& range, ColorsOf colors = ColorsOf::Values);
}

#endif
