// SPDX-License-Identifier: BSD-3-Clause
// Opaque geometry inside a volume.
#ifndef ExaBricksBenchmarksSurface_h
#define ExaBricksBenchmarksSurface_h

#include "Reference/View.h"
#include "Scenes/StandIn.h" // TriangleMesh

namespace exabricks
{
namespace benchmarks
{
struct Surface : TriangleMesh
{
  /// As a graphics card takes it: float positions, 32-bit indices.
  std::uint64_t bytes() const { return 12 * (this->points.size() + this->triangles.size()); }
};

/// Where rays end, as views have it: window depth in [0, 1] of each pixel's middle, 1 where nothing
/// is. Triangles that reach behind the camera are left out.
std::vector<float> drawDepth(const Surface& surface, const reference::View& view);
}
}

#endif
