// SPDX-License-Identifier: BSD-3-Clause
// Errors of the renderer's pictures against the length of its steps: the field is the same in both,
// so that all of the error is that of the integration.
#ifndef ExaBricksAccuracyStepOrder_h
#define ExaBricksAccuracyStepOrder_h

#include "Core/TransferFunction.h"
#include "Reference/Scenes.h"
#include "Reference/View.h"

namespace exabricks
{
namespace accuracy
{
struct StepScene
{
  std::string name;
  reference::Scene scene;
  TransferFunction transfer;
  reference::View view;
  std::vector<double> stepScales; // descending
  double opacityUnitDistance = 1.0;
};

/// Rays within the eight cells around a point: the field along them is a cubic, the transfer
/// function linear on its values. Nothing has a kink.
StepScene smoothScene();
/// Two levels, with kinks of the field at every cell's centre: a linear transfer function, one of
/// several layers, one with a jump, and one with a spike that most steps pass over.
std::vector<StepScene> kinkedScenes();

struct StepError
{
  double stepScale;
  double opacity; // root of the mean square over all pixels
  double color;   // the same of red, green and blue
};

/// Basis, k-d tree; rays are not ended early.
std::vector<StepError> measureStepErrors(const StepScene& scene);
/// Of what `error` takes from the rows: slope of the line through logarithms.
double observedOrder(const std::vector<StepError>& rows, double StepError::*error);
}
}

#endif
