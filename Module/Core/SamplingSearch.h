// SPDX-License-Identifier: BSD-3-Clause
// Work from the error: with how few levels and how long steps a picture errs by as much as asked
// for, found from few of its pixels.
#ifndef ExaBricksCoreSamplingSearch_h
#define ExaBricksCoreSamplingSearch_h

#include <optional>
#include <utility>
#include <vector>

namespace exabricks
{
/// What a picture is drawn with.
struct Sampling
{
  int levelsLeftOut = 0; // of the finest, see Coarsening
  double stepScale = 1.0;
};

inline bool operator<(const Sampling& a, const Sampling& b)
{
  return std::make_pair(a.levelsLeftOut, a.stepScale) <
    std::make_pair(b.levelsLeftOut, b.stepScale);
}

/// The same few pixels of a picture, spread over all of it, drawn with different samplings.
class SparsePictures
{
public:
  virtual ~SparsePictures() = default;

  using Pair = std::pair<Sampling, Sampling>;

  struct Difference
  {
    double squares = 0.0; // summed over the four channels of the pixels that are drawn
    int drawn = 0;        // pixels that are, in either picture: opacity of at least 1/255
  };

  /// The differences between the pictures of each pair, of premultiplied colours. None where there
  /// are not so many levels to leave out. Pairs that are asked for together are drawn together.
  virtual std::vector<std::optional<Difference>> compare(const std::vector<Pair>& pairs) = 0;
};

constexpr double GreatestStepScale = 4.0;

/// The cheapest sampling, with steps up to GreatestStepScale, with which pictures err by
/// `tolerance`, as a root mean square over the channels of the drawn pixels. The difference to half
/// the step tells the error, the order at which it falls tells the step; the difference to all
/// levels tells what those left out are worth. Depends on the pictures alone. None if fewer than
/// 100 pixels are drawn.
std::optional<Sampling> findSampling(double tolerance, SparsePictures& pictures);
}

#endif
