// SPDX-License-Identifier: BSD-3-Clause
// How coarsely a picture is drawn while something moves, to be done in the time allowed for it.
//
// Rays are thinned first: measured on scenes of 10^6 and 10^7 cells, 1 of 16 or 36 pixels, filled
// in from their neighbours, is nearer to the full picture than all of them with steps that take as
// long. Where they are as thin as may be, steps grow. Levels whose cells lie closer together than
// rays are left out: that costs 0.1 to 0.4 dB, and the time that it saves (a quarter for one level
// of 10^7 cells, nearly half for two) is worth 2 to 4 dB of more rays.
#ifndef ExaBricksCoreInteractiveSampling_h
#define ExaBricksCoreInteractiveSampling_h

#include <optional>
#include <vector>

namespace exabricks
{
/// How much less is drawn than of a full picture.
struct Coarseness
{
  double imageSampleDistance = 1.0; // of two rays, along each axis of the picture, pixels
  double stepGrowth = 1.0;          // by which steps between samples are multiplied
  int levelsLeftOut = 0;            // of the finest ones
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
    /// [levels left out] pixels along a side of the largest of the finest cells in the picture, as
    /// far as levels may be left out; empty: none may.
    std::vector<double> cells{};
  };

  /// Of the last picture that was drawn: how, with how many rays, and how many seconds it took to
  /// march them and to do all else.
  void measured(const Coarseness& drawn, double rays, double marching, double other);
  /// What was measured holds no longer: another volume, or another look of it.
  void forget() { this->SecondsPerRay.clear(); }
  bool knows() const { return !this->SecondsPerRay.empty(); }

  /// With which a picture of so many pixels takes about `seconds`, by what the last ones took. As
  /// coarse as `limits` allow, if nothing was measured.
  Coarseness choose(double seconds, double pixels, const Limits& limits) const;

private:
  double FindSecondsPerRay(int levelsLeftOut) const;
  Coarseness ChooseRays(
    double seconds, double pixels, const Limits& limits, int levelsLeftOut) const;

  // [levels left out] with steps that have not grown; empty: nothing is known.
  std::vector<std::optional<double>> SecondsPerRay;
  double Other = 0.0;
};
}

#endif
