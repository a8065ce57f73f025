// SPDX-License-Identifier: BSD-3-Clause
// How a ray finds the active regions along it.
#ifndef ExaBricksVulkanTraversal_h
#define ExaBricksVulkanTraversal_h

namespace exabricks
{
enum class Traversal
{
  Automatic, // ray query on a GPU that has it, else the k-d tree
  RayQuery,
  KdTree
};
}

#endif
