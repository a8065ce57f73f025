// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/MarchPipelines.h"

#include "Layout.h"
#include "MarchKdTreeSpirv.h"
#include "MarchRayQuerySpirv.h"

#include <array>
#include <cstddef>

namespace exabricks
{
namespace vulkan
{
namespace
{
// Shaders/Variant.glsl, in the order of its constants' numbers.
struct Constants
{
  std::uint32_t reconstruction;
  vk::Bool32 beginsAtDepth;
};

std::uint32_t numberOf(Reconstruction reconstruction)
{
  switch (reconstruction)
  {
    case Reconstruction::Nearest:
      return layout::RECONSTRUCTION_NEAREST;
    case Reconstruction::Completed:
      return layout::RECONSTRUCTION_COMPLETED;
    default:
      return layout::RECONSTRUCTION_BASIS;
  }
}

vk::ShaderModuleCreateInfo shaderFor(Traversal traversal, const MarchProgram* program)
{
  if (program && !program->spirv.empty())
  {
    return { {}, program->spirv };
  }
  return traversal == Traversal::RayQuery
    ? vk::ShaderModuleCreateInfo({}, sizeof(MarchRayQuerySpirv), MarchRayQuerySpirv)
    : vk::ShaderModuleCreateInfo({}, sizeof(MarchKdTreeSpirv), MarchKdTreeSpirv);
}
}

MarchPipelines::MarchPipelines(
  std::shared_ptr<Device> device, std::shared_ptr<const MarchProgram> program)
  : Owner(std::move(device))
  , Program(std::move(program))
{
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, sizeof(layout::Band));
  this->Layout =
    vk::raii::PipelineLayout(this->Owner->handle(), vk::PipelineLayoutCreateInfo({}, {}, push));
}

vk::Pipeline MarchPipelines::find(const MarchVariant& variant)
{
  auto found = this->Pipelines.find(variant);
  if (found == this->Pipelines.end())
  {
    found = this->Pipelines.emplace(variant, this->Make(variant)).first;
  }
  return *found->second;
}

vk::raii::Pipeline MarchPipelines::Make(const MarchVariant& variant) const
{
  const vk::raii::ShaderModule shader(
    this->Owner->handle(), shaderFor(variant.traversal, this->Program.get()));
  const Constants values{ numberOf(variant.reconstruction), variant.beginsAtDepth };
  const std::array<vk::SpecializationMapEntry, 2> entries{
    vk::SpecializationMapEntry(
      0, offsetof(Constants, reconstruction), sizeof(values.reconstruction)),
    vk::SpecializationMapEntry(1, offsetof(Constants, beginsAtDepth), sizeof(values.beginsAtDepth))
  };
  const vk::SpecializationInfo constants(entries.size(), entries.data(), sizeof(values), &values);
  const vk::PipelineShaderStageCreateInfo stage(
    {}, vk::ShaderStageFlagBits::eCompute, *shader, "main", &constants);
  return { this->Owner->handle(), nullptr,
    vk::ComputePipelineCreateInfo({}, stage, *this->Layout) };
}
}
}
