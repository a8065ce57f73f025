// SPDX-License-Identifier: BSD-3-Clause
// A few pixels of a picture, drawn with different samplings and compared on the device: what is
// asked for together is one submission, and a few numbers come back.
#ifndef ExaBricksVulkanDeviceSparsePictures_h
#define ExaBricksVulkanDeviceSparsePictures_h

#include "Core/SamplingSearch.h"
#include "Vulkan/ComputePipeline.h"
#include "Vulkan/Exchange.h"
#include "Vulkan/MarchPass.h"

#include <functional>
#include <map>

namespace exabricks
{
namespace vulkan
{
class DeviceSparsePictures : public SparsePictures
{
public:
  explicit DeviceSparsePictures(std::shared_ptr<Device> device);

  /// A frame with all that concerns volume, transfer function and view; none, if there are not so
  /// many levels to leave out.
  using MakeFrame = std::function<std::optional<layout::Frame>(const Sampling&)>;
  /// Begins anew, with the pixels of `target`, which may have depths at which rays end.
  void begin(const Target& target, const MarchPass& pass, MakeFrame makeFrame);

  std::vector<std::optional<Difference>> compare(const std::vector<Pair>& pairs) override;

private:
  // Where a picture lies; none, if there are not so many levels to leave out.
  using Place = std::optional<vk::DeviceAddress>;

  // Puts the frames of pictures that are not drawn yet into `frames`.
  Place FindPlace(const Sampling& sampling, std::vector<layout::Frame>& frames);

  std::shared_ptr<Device> Owner;
  ComputePipeline<layout::Comparison> Compare; // Shaders/Difference.comp
  MarchPass Pass;
  MakeFrame MakeFrameOf;
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  Input Frames;
  Input Depth;
  bool HasDepth = false;
  PixelCounters Counters;
  Output Differences;
  std::vector<Buffer> Pictures; // of this view, and beyond them some of views before
  std::map<Sampling, Place> Places;
};
}
}

#endif
