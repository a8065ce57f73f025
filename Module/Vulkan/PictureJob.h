// SPDX-License-Identifier: BSD-3-Clause
// One picture as a job: begin, march some rows after others, finish. A job can be used for one
// picture after another, and keeps its buffers.
#ifndef ExaBricksVulkanPictureJob_h
#define ExaBricksVulkanPictureJob_h

#include "Vulkan/Exchange.h"
#include "Vulkan/MarchPass.h"

namespace exabricks
{
namespace vulkan
{
class PictureJob
{
public:
  explicit PictureJob(std::shared_ptr<Device> device);

  /// `frame` comes with all that concerns volume, transfer function and view (fillView()). The
  /// target's depths are read before it returns. Throws PictureFailure, where there is no memory
  /// for a picture of that size.
  void begin(const layout::Frame& frame, const Target& target, const MarchPass& pass);

  /// Marches the next rows, so many that it takes about PieceSeconds by what the last rows took: a
  /// GPU that also drives a display must not be kept for long, and whoever waits may want to
  /// interrupt. False: all rows are done.
  bool march();
  /// Rows done, of all.
  double progress() const;
  static constexpr double PieceSeconds = 0.03;

  /// The picture, [height][width], when all rows are done.
  const glm::vec4* pixels() const;

private:
  std::shared_ptr<Device> Owner;
  Input Constants;
  Input Depth;
  Input NearDepth;
  Output Picture;
  PixelCounters Counters;
  MarchPass Pass;
  bool HasDepth = false;
  bool HasNearDepth = false;
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  std::uint32_t NextRow = 0;
  double PixelsPerSecond = 2e6; // of the last rows, of this picture or the one before
};
}
}

#endif
