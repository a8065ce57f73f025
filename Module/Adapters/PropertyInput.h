// SPDX-License-Identifier: BSD-3-Clause
// What the user asks of a picture by the volume property and the mapper: its translation for the
// renderer, and beside it, in words, what is refused and what the volume is drawn without.
#ifndef ExaBricksAdaptersPropertyInput_h
#define ExaBricksAdaptersPropertyInput_h

#include "Adapters/TransferFunctionInput.h"
#include "Core/Blending.h"

#include <string>
#include <vector>

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
  double errorTolerance = 0.0;
  // Whether somebody chose it, or it is the default.
  bool vectorModeChosen = false;
};

/// Whether the property's opacity of component 0 depends on gradients.
bool hasGradientOpacity(vtkVolumeProperty* property);

/// Checks what can be told without data.
Requests checkWithoutData(vtkVolumeMapper* mapper, vtkVolume* volume);

/// Checks the rest, for an array of so many components.
Requests checkWithData(vtkVolumeProperty* property, const MapperSettings& settings, int components);

/// The mapper's blend mode, which checkWithoutData() has let pass, and the range of values that
/// count for the average, over `range` of the array's values.
Blending findBlending(vtkVolumeMapper* mapper);
glm::dvec2 findAverageRange(vtkVolumeMapper* mapper, const Range& range);
/// Of the property, over `range`, in ascending order, each once.
std::vector<double> findIsoValues(vtkVolumeProperty* property, const Range& range);

/// Colour and opacity of component 0, over `range` of the array's values.
TransferFunction makeTransferFunction(vtkVolumeProperty* property, const Range& range);
}

#endif
