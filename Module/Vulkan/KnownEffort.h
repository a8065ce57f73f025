// SPDX-License-Identifier: BSD-3-Clause
// The effort that was found last for an error tolerance, and the view that it was found for: the
// same view is not searched again. The parts of one picture have the same whole but for rounding.
#ifndef ExaBricksVulkanKnownEffort_h
#define ExaBricksVulkanKnownEffort_h

#include "Core/StepControl.h"
#include "Vulkan/VolumeRenderer.h"

#include <algorithm>
#include <glm/common.hpp>

namespace exabricks
{
struct KnownEffort
{
  KnownEffort() = default;
  KnownEffort(const View& of, const Effort& found)
    : view(of)
    , effort(found)
  {
    if (of.target.depth)
    {
      this->depth.assign(of.target.depth,
        of.target.depth + static_cast<std::size_t>(of.target.width) * of.target.height);
    }
  }

  bool is(const View& other) const
  {
    const double allowed = other.target.whole ? 1e-9 : 0.0; // of the greatest element
    return this->view.quality.errorTolerance == other.quality.errorTolerance &&
      this->view.target.width == other.target.width &&
      this->view.target.height == other.target.height &&
      this->view.quality.reconstruction == other.quality.reconstruction &&
      this->view.quality.levelsLeftOut == other.quality.levelsLeftOut &&
      this->view.opacityUnitDistance == other.opacityUnitDistance &&
      alike(this->view.camera.ndcToHalfCells, other.camera.ndcToHalfCells, allowed) &&
      alike(this->view.camera.ndcToData, other.camera.ndcToData, allowed) &&
      this->depth.empty() == !other.target.depth &&
      (!other.target.depth ||
        std::equal(this->depth.begin(), this->depth.end(), other.target.depth));
  }

  View view; // of no tolerance: nothing is known
  std::vector<float> depth;
  Effort effort;

private:
  static bool alike(const glm::dmat4& a, const glm::dmat4& b, double allowed)
  {
    double most = 0.0;
    double off = 0.0;
    for (int column = 0; column < 4; ++column)
    {
      const glm::dvec4 size = glm::abs(a[column]);
      const glm::dvec4 difference = glm::abs(a[column] - b[column]);
      most = std::max({ most, size.x, size.y, size.z, size.w });
      off = std::max({ off, difference.x, difference.y, difference.z, difference.w });
    }
    return off <= allowed * most;
  }
};
}

#endif
