// SPDX-License-Identifier: BSD-3-Clause
// How coarsely a picture is drawn while something moves, to be done in the time allowed for it.
//
// Rays are thinned first: measured on scenes of 10^6 and 10^7 cells, 1 of 16 or 36 pixels, filled
// in from their neighbours, is nearer to the full picture than all of them with steps that take as
// long. Where they are as thin as may be, steps grow.
#ifndef ExaBricksCoreInteractiveSampling_h
#define ExaBricksCoreInteractiveSampling_h

#include <optional>

namespace exabricks
{
/// How much less is drawn than of a full picture.
struct Coarseness
{
  double imageSampleDistance = 1.0; // of two rays, along each axis of the picture, pixels
  double stepGrowth = 1.0;          // by which steps between samples are multiplied
};

/// A number of pixels along an axis, with rays so far from each other; one at least.
int thinnedSize(int pixels, double imageSampleDistance);

class InteractiveSampling
{
public:
  struct Limits
  {
    double least = 1.0; // image sample distances
    double most = 10.0;
  };

  /// Of the last picture that was drawn: how, with how many rays, and how many seconds it took to
  /// march them and to do all else.
  void measured(const Coarseness& drawn, double rays, double marching, double other);
  /// What was measured holds no longer: another volume, or another look of it.
  void forget() { this->SecondsPerRay.reset(); }
  bool knows() const { return this->SecondsPerRay.has_value(); }

  /// With which a picture of so many pixels takes about `seconds`, by what the last ones took. As
  /// coarse as `limits` allow, if nothing was measured.
  Coarseness choose(double seconds, double pixels, const Limits& limits) const;

private:
  std::optional<double> SecondsPerRay; // with steps that have not grown
  double Other = 0.0;
};
}

#endif
