// SPDX-License-Identifier: BSD-3-Clause
// The compute pass that marches the rays of some rows of a picture, or of pixels of a list
// (Shaders/March.comp), as commands.
#ifndef ExaBricksVulkanMarchPass_h
#define ExaBricksVulkanMarchPass_h

#include "Core/View.h"
#include "Layout.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/MarchPipelines.h"

namespace exabricks
{
namespace vulkan
{
/// Pixels are marched in tiles of so many along each axis.
constexpr std::uint32_t TileSize = 8; // local_size of March.comp

/// How a picture is marched.
struct MarchPass
{
  MarchPass() = default;
  /// Adds the pipelines that were made for it to `builds`.
  MarchPass(MarchPipelines& pipelines, const MarchVariant& variant, std::size_t& builds)
    : pipeline(pipelines.find(variant, builds))
    , layout(pipelines.layout())
    , takesPixels(pipelines.takesPixels())
  {
  }

  vk::Pipeline pipeline;
  vk::PipelineLayout layout;
  bool takesPixels = false; // by a counter

  /// `band`: with the device addresses of a layout::Frame and, where pixels are taken by it, of a
  /// counter that is 0 and that no other pass has used since. `width` and `rows` of pixels; of a
  /// list, of as many pixels in any shape.
  void record(const vk::raii::CommandBuffer& commands, const layout::Band& band,
    std::uint32_t width, std::uint32_t rows) const
  {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, this->pipeline);
    commands.pushConstants<layout::Band>(this->layout, vk::ShaderStageFlagBits::eCompute, 0, band);
    commands.dispatch((width + TileSize - 1) / TileSize, (rows + TileSize - 1) / TileSize, 1);
  }
  /// `band`: of a list, whose `count` tells how many of it are marched.
  void recordList(const vk::raii::CommandBuffer& commands, const layout::Band& band) const;
};

/// The counters by which the passes of one submission take pixels.
class PixelCounters
{
public:
  PixelCounters() = default;
  PixelCounters(const std::shared_ptr<Device>& device, std::uint32_t count)
    : Counters(device, count * sizeof(std::uint32_t), Residence::Device, "counters of pixels")
  {
  }

  vk::DeviceAddress address(std::uint32_t counter) const
  {
    return this->Counters.address() + counter * sizeof(std::uint32_t);
  }
  /// Sets all to 0, for the passes recorded after this.
  void record(const vk::raii::CommandBuffer& commands) const { this->Counters.clear(commands); }

private:
  Buffer Counters;
};

/// Puts all that concerns the view into a frame, but the addresses of depths and picture.
/// `fromHalfCells`: of the view's half cells to the volume's.
void fillView(layout::Frame& frame, const View& view, const glm::dmat4& fromHalfCells);
}
}

#endif
