// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/MarchPipelines.h"

#include "Layout.h"
#include "Vulkan/MarchModules.h"

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
  std::uint32_t blending;
  vk::Bool32 beginsAtDepth;
  vk::Bool32 takesPixels;
  vk::Bool32 isShaded;
  vk::Bool32 hasGradientOpacity;
  vk::Bool32 clipped;
  vk::Bool32 cropped;
  std::uint32_t components;
  std::uint32_t mixing;
  vk::Bool32 jittered;
  vk::Bool32 showsUndefined;
  vk::Bool32 isPart;
  vk::Bool32 isScattering;
  vk::Bool32 hasNormalsOfOpacity;
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

std::uint32_t numberOf(Mixing mixing)
{
  switch (mixing)
  {
    case Mixing::ColorAndOpacity:
      return layout::MIXING_COLOR_AND_OPACITY;
    case Mixing::RGBA:
      return layout::MIXING_RGBA;
    case Mixing::Planar:
      return layout::MIXING_PLANAR;
    default:
      return layout::MIXING_INDEPENDENT;
  }
}

std::uint32_t numberOf(Blending blending)
{
  switch (blending)
  {
    case Blending::Maximum:
      return layout::BLENDING_MAXIMUM;
    case Blending::Minimum:
      return layout::BLENDING_MINIMUM;
    case Blending::Average:
      return layout::BLENDING_AVERAGE;
    case Blending::Additive:
      return layout::BLENDING_ADDITIVE;
    case Blending::Isosurface:
      return layout::BLENDING_ISOSURFACE;
    case Blending::Slice:
      return layout::BLENDING_SLICE;
    default:
      return layout::BLENDING_COMPOSITE;
  }
}
}

std::shared_ptr<MarchPipelines> MarchPipelines::ofDevice(const std::shared_ptr<Device>& device)
{
  static std::mutex mutex;
  static std::map<const Device*, std::weak_ptr<MarchPipelines>> all;

  const std::lock_guard<std::mutex> lock(mutex);
  // A device that is gone may have had the address of another one, but its pipelines went first.
  std::weak_ptr<MarchPipelines>& kept = all[device.get()];
  std::shared_ptr<MarchPipelines> pipelines = kept.lock();
  if (!pipelines)
  {
    pipelines = std::make_shared<MarchPipelines>(device);
    kept = pipelines;
  }
  return pipelines;
}

MarchPipelines::MarchPipelines(std::shared_ptr<Device> device, MarchShader shader)
  : Owner(std::move(device))
  , Shader(std::move(shader))
{
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, sizeof(layout::Band));
  this->Layout =
    vk::raii::PipelineLayout(this->Owner->handle(), vk::PipelineLayoutCreateInfo({}, {}, push));
}

vk::Pipeline MarchPipelines::find(const MarchVariant& variant, std::size_t& builds)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  auto found = this->Pipelines.find(variant);
  if (found == this->Pipelines.end())
  {
    found = this->Pipelines.emplace(variant, this->Make(variant)).first;
    ++builds;
  }
  return *found->second;
}

vk::raii::Pipeline MarchPipelines::Make(const MarchVariant& variant) const
{
  const bool int64 = this->Owner->hasInt64();
  const vk::raii::ShaderModule shader(this->Owner->handle(),
    this->Shader.spirv.empty()
      ? findMarchModule(variant, int64)
      : vk::ShaderModuleCreateInfo({}, int64 ? this->Shader.int64Spirv : this->Shader.spirv));
  const Constants values{ numberOf(variant.reconstruction), numberOf(variant.blending),
    variant.beginsAtDepth, this->takesPixels(), variant.shaded, variant.hasGradientOpacity,
    variant.clipped, variant.cropped, variant.components, numberOf(variant.mixing),
    variant.jittered, variant.showsUndefined, variant.isPart, variant.scattering,
    variant.normalsOfOpacity };
  const auto entry = [](std::uint32_t number, std::size_t offset)
  { return vk::SpecializationMapEntry(number, static_cast<std::uint32_t>(offset), 4); };
  const std::array<vk::SpecializationMapEntry, 15> entries{
    entry(0, offsetof(Constants, reconstruction)), entry(1, offsetof(Constants, beginsAtDepth)),
    entry(2, offsetof(Constants, takesPixels)), entry(3, offsetof(Constants, clipped)),
    entry(4, offsetof(Constants, cropped)), entry(5, offsetof(Constants, blending)),
    entry(6, offsetof(Constants, components)), entry(7, offsetof(Constants, mixing)),
    entry(8, offsetof(Constants, isShaded)), entry(9, offsetof(Constants, hasGradientOpacity)),
    entry(10, offsetof(Constants, jittered)), entry(11, offsetof(Constants, showsUndefined)),
    entry(12, offsetof(Constants, isPart)), entry(13, offsetof(Constants, isScattering)),
    entry(14, offsetof(Constants, hasNormalsOfOpacity))
  };
  const vk::SpecializationInfo constants(entries.size(), entries.data(), sizeof(values), &values);
  const vk::PipelineShaderStageCreateInfo stage(
    {}, vk::ShaderStageFlagBits::eCompute, *shader, "main", &constants);
  return { this->Owner->handle(), this->Owner->pipelineCache(),
    vk::ComputePipelineCreateInfo({}, stage, *this->Layout) };
}
}
}
