// SPDX-License-Identifier: BSD-3-Clause
// How a volume may be shown about which nothing is known but itself.
#ifndef ExaBricksCoreFirstPicture_h
#define ExaBricksCoreFirstPicture_h

#include "Core/Blending.h"
#include "Core/Volume.h"

namespace exabricks
{
struct OpacityPoint
{
  double value;   // of the array
  double opacity; // of the unit distance, in [0, 1]
};

struct FirstPicture
{
  Range colors;                      // values over which a color map is spread
  std::vector<OpacityPoint> opacity; // ascending, linear between them
  double unitDistance = 1.0;         // a length in the data's own coordinates
  /// The part of the bounds that holds what shows: half cells from their lower corner.
  glm::dvec3 lo{ 0.0 };
  glm::dvec3 hi{ 1.0 };
};

/// Whether logarithms of the values show more than they do: all are above zero, and nine of ten
/// leaf cells have less than a hundredth of the greatest.
bool wantsLogarithm(const Values& values);

/// Of the first component. `logarithmic`: its values are logarithms to the base of 10; of those no
/// more than eight decades show. `spacing`: size of a finest cell in the data's own coordinates.
///
/// Opacities of Blending::Composite are those of chooseInterest(). The unit distance is a hundredth
/// of the diagonal of the part that holds all but a fiftieth of what shows, along each axis;
/// opacities are as high as dims a ray of average length through that part to about a third.
///
/// Of the greatest value opacity rises along the range of colours. All other ways of blending show
/// all values as they are, in all of the bounds but for iso-surfaces; for sums along the ray the
/// unit distance is a length that makes a ray of average length as bright as a quarter.
FirstPicture chooseFirstPicture(const Volume& volume, const glm::dvec3& spacing, bool logarithmic,
  Blending blending = Blending::Composite);
}

#endif
