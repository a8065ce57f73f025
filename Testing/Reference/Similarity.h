// SPDX-License-Identifier: BSD-3-Clause
// How alike two pictures look.
#ifndef ExaBricksReferenceSimilarity_h
#define ExaBricksReferenceSimilarity_h

#include "Reference/Image.h"

namespace exabricks
{
namespace reference
{
/// Structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004) of the luminance over black: 1
/// for equal pictures, -1 at worst. Mean over all windows of 11 by 11 pixels that lie inside,
/// weighted by a Gaussian of 1.5 pixels, with K1 = 0.01, K2 = 0.03 and a peak of 1. NaN for
/// pictures of different size, or less than 11 pixels along a side.
double structuralSimilarity(const Image& a, const Image& b);
}
}

#endif
