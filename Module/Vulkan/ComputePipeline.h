// SPDX-License-Identifier: BSD-3-Clause
// A compute pass of one shader, whose push constants are one structure and nothing else.
#ifndef ExaBricksVulkanComputePipeline_h
#define ExaBricksVulkanComputePipeline_h

#include "Vulkan/Device.h"

namespace exabricks
{
namespace vulkan
{
template <typename Constants>
class ComputePipeline
{
public:
  /// `code`: of a shader without variants. Throws vk::Error.
  ComputePipeline(const Device& device, const vk::ShaderModuleCreateInfo& code)
  {
    const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, sizeof(Constants));
    this->Layout =
      vk::raii::PipelineLayout(device.handle(), vk::PipelineLayoutCreateInfo({}, {}, push));
    const vk::raii::ShaderModule shader(device.handle(), code);
    const vk::PipelineShaderStageCreateInfo stage(
      {}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
    this->Pipeline = vk::raii::Pipeline(device.handle(), device.pipelineCache(),
      vk::ComputePipelineCreateInfo({}, stage, *this->Layout));
  }

  /// Runs so many columns and rows of work groups.
  void record(const vk::raii::CommandBuffer& commands, const Constants& constants,
    std::uint32_t columns, std::uint32_t rows) const
  {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *this->Pipeline);
    commands.pushConstants<Constants>(
      *this->Layout, vk::ShaderStageFlagBits::eCompute, 0, constants);
    commands.dispatch(columns, rows, 1);
  }

private:
  vk::raii::PipelineLayout Layout = nullptr;
  vk::raii::Pipeline Pipeline = nullptr;
};
}
}

#endif
