// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/MarchPass.h"

#include <algorithm>
#include <cstring>

namespace exabricks
{
namespace vulkan
{
namespace
{
constexpr std::uint32_t GroupSize = 8;         // local_size of March.comp
constexpr std::uint32_t LargestBand = 1 << 20; // pixels

void provide(Buffer& buffer, const std::shared_ptr<Device>& device, vk::DeviceSize bytes,
  Residence residence, const Purpose& purpose)
{
  if (buffer.bytes() < bytes)
  {
    buffer = Buffer(); // frees the old one first
    buffer = Buffer(device, bytes, residence, purpose);
  }
}
}

MarchPass::MarchPass(std::shared_ptr<Device> device, std::shared_ptr<MarchPipelines> pipelines)
  : Owner(std::move(device))
  , Pipelines(std::move(pipelines))
  , Constants(this->Owner, sizeof(layout::Frame), Residence::Upload, "the frame's constants")
{
}

void MarchPass::run(const MarchVariant& variant, layout::Frame frame, const View& view,
  std::vector<glm::vec4>& picture)
{
  const vk::Pipeline pipeline = this->Pipelines->find(variant);
  const std::size_t pixels = static_cast<std::size_t>(view.target.width) * view.target.height;
  provide(this->Picture, this->Owner, pixels * sizeof(glm::vec4), Residence::Readback,
    Purpose::ofPicture("the picture", view.target.width, view.target.height));
  const auto upload = [&](Buffer& buffer, const float* depth)
  {
    if (depth)
    {
      provide(buffer, this->Owner, pixels * sizeof(float), Residence::Upload,
        Purpose::ofPicture("the depth buffer", view.target.width, view.target.height));
      buffer.upload(depth, pixels * sizeof(float));
    }
  };
  upload(this->Depth, view.target.depth);
  upload(this->NearDepth, view.target.nearDepth);
  frame.ndcToHalfCells = view.camera.ndcToHalfCells;
  frame.ndcToData = view.camera.ndcToData;
  frame.width = static_cast<std::uint32_t>(view.target.width);
  frame.height = static_cast<std::uint32_t>(view.target.height);
  frame.stepScale = static_cast<float>(view.quality.stepScale);
  frame.inverseUnit = static_cast<float>(1.0 / view.opacityUnitDistance);
  frame.terminationOpacity = static_cast<float>(view.quality.terminationOpacity);
  frame.hasDepth = view.target.depth != nullptr;
  frame.depth = view.target.depth ? this->Depth.address() : 0;
  frame.nearDepth = view.target.nearDepth ? this->NearDepth.address() : 0;
  frame.picture = this->Picture.address();
  this->Constants.upload(&frame, sizeof(frame));

  // A picture of many pixels goes in bands, each a submission of its own: a GPU that also drives a
  // display must not be kept for long.
  const std::uint32_t rows = std::max(GroupSize, LargestBand / frame.width / GroupSize * GroupSize);
  for (std::uint32_t firstRow = 0; firstRow < frame.height; firstRow += rows)
  {
    const layout::Band band{ this->Constants.address(), firstRow };
    const std::uint32_t height = std::min(rows, frame.height - firstRow);
    this->Owner->submit(
      [&](const vk::raii::CommandBuffer& commands)
      {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline);
        commands.pushConstants<layout::Band>(
          this->Pipelines->layout(), vk::ShaderStageFlagBits::eCompute, 0, band);
        commands.dispatch(
          (frame.width + GroupSize - 1) / GroupSize, (height + GroupSize - 1) / GroupSize, 1);
        const vk::MemoryBarrier toHost(
          vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
        commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader,
          vk::PipelineStageFlagBits::eHost, {}, toHost, {}, {});
      });
  }
  picture.resize(pixels);
  std::memcpy(picture.data(), this->Picture.mapped(), pixels * sizeof(glm::vec4));
}
}
}
