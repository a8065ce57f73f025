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
    if (of.depth)
    {
      this->depth.assign(of.depth, of.depth + static_cast<std::size_t>(of.width) * of.height);
    }
  }

  bool is(const View& other) const
  {
    const double allowed = other.whole ? 1e-9 : 0.0; // of the greatest element
    return this->view.errorTolerance == other.errorTolerance && this->view.width == other.width &&
      this->view.height == other.height && this->view.reconstruction == other.reconstruction &&
      this->view.levelsLeftOut == other.levelsLeftOut &&
      this->view.opacityUnitDistance == other.opacityUnitDistance &&
      alike(this->view.ndcToHalfCells, other.ndcToHalfCells, allowed) &&
      alike(this->view.ndcToData, other.ndcToData, allowed) &&
      this->depth.empty() == !other.depth &&
      (!other.depth || std::equal(this->depth.begin(), this->depth.end(), other.depth));
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
