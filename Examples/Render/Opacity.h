// SPDX-License-Identifier: BSD-3-Clause
// Opacity from the data: what is rare is shown, what is common is clear.

#ifndef ExaBricksRenderOpacity_h
#define ExaBricksRenderOpacity_h

#include "Options.h"

#include "vtkType.h"

#include <vector>

namespace render
{

// Number of bins that the histogram should have.
constexpr int HistogramBins = 512;

// Distance for which opacities hold, if none is given: a hundredth of the diagonal, so that a ray
// through the data is some 50 to 100 units long.
double defaultOpacityUnit(const double bounds[6]);

// Opacity points, per unit distance, from the histogram of the leaf cells over the range of values.
//
// belowToo: show values below the most common one as well as those above. Of a logarithm they are
// better left out: there they are the near-nothing of far and empty space.
//
// The most common values, which together hold 80 % of the cells, are the background and are clear:
// the near-zero part of a field that decays, both phases of a fluid, the one value of a nearly
// constant field. The others show the more, the rarer they are and the farther from the most common
// value. The height is set so that an average ray is dimmed to about a third. Without rare values,
// as in a uniform histogram, opacity rises along the range.
std::vector<OpacityPoint> opacityFromHistogram(
  const std::vector<vtkIdType>& counts, const double range[2], bool belowToo);

}

#endif
