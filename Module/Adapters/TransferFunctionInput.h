// SPDX-License-Identifier: BSD-3-Clause
// From VTK's transfer functions to the core's: exact at every node, with VTK's rules for values
// outside (clamped to the end nodes, or nothing).
#ifndef ExaBricksAdaptersTransferFunctionInput_h
#define ExaBricksAdaptersTransferFunctionInput_h

#include "Core/Range.h"
#include "Core/TransferFunction.h"

class vtkPiecewiseFunction;
class vtkVolumeProperty;

namespace exabricks
{
/// Colour and opacity of component 0, over `range` of the array's values.
TransferFunction makeTransferFunction(vtkVolumeProperty* property, const Range& range);

/// White, of this opacity; opaque everywhere if null.
TransferFunction makeTransferFunction(vtkPiecewiseFunction* opacity, const Range& range);
}

#endif
