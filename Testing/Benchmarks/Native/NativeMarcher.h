// SPDX-License-Identifier: BSD-3-Clause
// Shaders/March.comp by the processor itself, one ray at a time: what this machine can do, to
// measure a Vulkan driver that runs on it by. The k-d tree, the basis, no absent cells.
#ifndef ExaBricksBenchmarksNativeMarcher_h
#define ExaBricksBenchmarksNativeMarcher_h

#include "Core/ActiveRegions.h"
#include "Core/View.h"

#include <memory>

namespace exabricks
{
namespace benchmarks
{
class NativeMarcher
{
public:
  /// Keeps what it needs. Throws std::invalid_argument if the volume has absent cells, or a layer
  /// around its bricks.
  NativeMarcher(const Volume& volume, const TransferFunction& transfer);
  ~NativeMarcher();
  NativeMarcher(const NativeMarcher&) = delete;
  NativeMarcher& operator=(const NativeMarcher&) = delete;

  /// `picture`: as of VolumeRenderer. Throws std::invalid_argument unless the view asks for the
  /// basis.
  void render(const View& view, int threads, std::vector<glm::vec4>& picture) const;

  /// What a picture takes.
  struct Counts
  {
    std::uint64_t rays = 0; // that hit the bounds
    std::uint64_t treeSteps = 0;
    std::uint64_t regions = 0;
    std::uint64_t intervals = 0; // parts of a ray with one value of the extinction
    std::uint64_t samples = 0;
    std::uint64_t bricks = 0; // that samples are taken from
  };
  Counts count(const View& view) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}
}

#endif
