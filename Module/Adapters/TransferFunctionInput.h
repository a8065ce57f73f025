// SPDX-License-Identifier: BSD-3-Clause
// From VTK's transfer functions to the core's: exact at every node, with VTK's rules for values
// outside (clamped to the end nodes, or nothing). `range` is that of the array's values.
#ifndef ExaBricksAdaptersTransferFunctionInput_h
#define ExaBricksAdaptersTransferFunctionInput_h

#include "Core/Range.h"
#include "Core/TransferFunction.h"

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace exabricks
{
/// What colours of categories (IndexedLookup) are taken for.
enum class ColorsOf
{
  Values,    // between those of the nodes
  Categories // of the annotated values alone; all others have the function's NaN colour
};

/// Of colours.
TransferFunction makeTransferFunction(vtkColorTransferFunction* colors,
  vtkPiecewiseFunction* opacity, const Range& range, ColorsOf meaning = ColorsOf::Values);

/// Of shades of grey.
TransferFunction makeTransferFunction(
  vtkPiecewiseFunction* gray, vtkPiecewiseFunction* opacity, const Range& range);

/// White, of this opacity; opaque everywhere if null.
TransferFunction makeTransferFunction(vtkPiecewiseFunction* opacity, const Range& range);
}

#endif
