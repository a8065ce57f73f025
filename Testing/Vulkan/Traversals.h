// SPDX-License-Identifier: BSD-3-Clause
// The traversals that the tests' device has: ray query is an extension that some lack.
#ifndef ExaBricksTestingTraversals_h
#define ExaBricksTestingTraversals_h

#include "Vulkan/Device.h"
#include "Vulkan/VolumeRenderer.h"

#include <iostream>
#include <vector>

namespace exabricks
{
inline bool deviceHasRayQuery() { return vulkan::Device::acquire("")->hasRayQuery(); }

/// Says so where that is the k-d tree alone.
inline std::vector<Traversal> traversalsOfDevice()
{
  if (deviceHasRayQuery())
  {
    return { Traversal::KdTree, Traversal::RayQuery };
  }
  std::cout << "The device has no ray query: the k-d tree alone is tested.\n";
  return { Traversal::KdTree };
}
}

#endif
