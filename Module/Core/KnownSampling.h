// SPDX-License-Identifier: BSD-3-Clause
// The sampling that was found last for an error tolerance, and the view that it was found for: the
// same view is not searched twice. The parts of one picture have the same whole but for rounding.
#ifndef ExaBricksCoreKnownSampling_h
#define ExaBricksCoreKnownSampling_h

#include "Core/SamplingSearch.h"
#include "Core/View.h"

#include <algorithm>
#include <glm/common.hpp>

namespace exabricks
{
struct KnownSampling
{
  KnownSampling() = default;
  KnownSampling(const View& of, const Sampling& found)
    : view(of)
    , sampling(found)
  {
    if (of.target.depth)
    {
      this->depth.assign(of.target.depth, of.target.depth + NumberOfPixels(of));
    }
  }

  bool isOf(const View& other) const
  {
    const double allowed = other.target.whole ? 1e-9 : 0.0; // of the greatest element
    const Quality& quality = this->view.quality;
    return quality.errorTolerance == other.quality.errorTolerance &&
      quality.reconstruction == other.quality.reconstruction &&
      quality.levelsLeftOut == other.quality.levelsLeftOut &&
      quality.jittered == other.quality.jittered && this->view.target.width == other.target.width &&
      this->view.target.height == other.target.height &&
      this->view.opacityUnitDistance == other.opacityUnitDistance &&
      this->view.cutaway == other.cutaway && this->view.slicePlane == other.slicePlane &&
      this->view.lighting == other.lighting &&
      Alike(this->view.camera.ndcToHalfCells, other.camera.ndcToHalfCells, allowed) &&
      this->view.camera.halfCellsToData == other.camera.halfCellsToData &&
      this->depth.empty() == !other.target.depth &&
      (!other.target.depth ||
        std::equal(this->depth.begin(), this->depth.end(), other.target.depth));
  }

  /// Whether it errs by as much, seen from elsewhere.
  bool isFor(const Quality& quality) const
  {
    return this->view.quality.errorTolerance == quality.errorTolerance &&
      this->view.quality.reconstruction == quality.reconstruction;
  }

  View view; // with no tolerance, nothing is known
  std::vector<float> depth;
  Sampling sampling;

private:
  static std::size_t NumberOfPixels(const View& view)
  {
    return static_cast<std::size_t>(view.target.width) * view.target.height;
  }

  static bool Alike(const glm::dmat4& a, const glm::dmat4& b, double allowed)
  {
    double greatest = 0.0;
    double off = 0.0;
    for (int column = 0; column < 4; ++column)
    {
      const glm::dvec4 size = glm::abs(a[column]);
      const glm::dvec4 difference = glm::abs(a[column] - b[column]);
      greatest = std::max({ greatest, size.x, size.y, size.z, size.w });
      off = std::max({ off, difference.x, difference.y, difference.z, difference.w });
    }
    return off <= allowed * greatest;
  }
};
}

#endif
