// SPDX-License-Identifier: BSD-3-Clause
// How far a picture is from the truth, as it is seen over black: windows have no opacity.
#ifndef ExaBricksBenchmarksPictureErrors_h
#define ExaBricksBenchmarksPictureErrors_h

#include "Reference/Image.h"

namespace exabricks
{
namespace benchmarks
{
/// Root of the mean square over red, green and blue of all pixels.
double rootMeanSquare(const reference::Image& a, const reference::Image& b);
/// The same over the pixels that show at least 1/255 of any colour in either picture.
double rootMeanSquareOfDrawn(const reference::Image& a, const reference::Image& b);
/// dB, with a peak of 1; infinite for 0.
double toDecibels(double rootMeanSquare);
/// 0: nothing is drawn.
double brightest(const reference::Image& image);
}
}

#endif
