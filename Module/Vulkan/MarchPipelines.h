// SPDX-License-Identifier: BSD-3-Clause
// The pipelines of Shaders/March.comp on one device, one for each variant in use.
#ifndef ExaBricksVulkanMarchPipelines_h
#define ExaBricksVulkanMarchPipelines_h

#include "Vulkan/Device.h"
#include "Vulkan/MarchVariant.h"

#include <map>
#include <memory>
#include <mutex>

namespace exabricks
{
namespace vulkan
{
/// SPIR-V with the interface of Shaders/March.comp, of the family without a name
/// (Shaders/Variant.glsl).
struct MarchShader
{
  std::vector<std::uint32_t> spirv;
  std::vector<std::uint32_t> int64Spirv; // for devices with integers of 64 bits (Buffers.glsl)
};

class MarchPipelines
{
public:
  /// Those that all renderers of a device share, for as long as one of them keeps them.
  static std::shared_ptr<MarchPipelines> ofDevice(const std::shared_ptr<Device>& device);

  /// `shader`: takes the place of Shaders/March.comp in all variants; empty: none does.
  explicit MarchPipelines(std::shared_ptr<Device> device, MarchShader shader = {});

  /// Made when first asked for, and kept: drivers compile for a long time. Adds those that were
  /// made to `builds`. Any number of threads may ask. Throws vk::Error.
  vk::Pipeline find(const MarchVariant& variant, std::size_t& builds);
  /// Whether their invocations take pixels by a counter (Shaders/Variant.glsl).
  bool takesPixels() const { return this->Owner->isCpu(); }
  /// Of all of them: one layout::Band as push constants, and nothing else.
  vk::PipelineLayout layout() const { return *this->Layout; }

private:
  vk::raii::Pipeline Make(const MarchVariant& variant) const;

  std::shared_ptr<Device> Owner;
  const MarchShader Shader;
  vk::raii::PipelineLayout Layout = nullptr;
  std::mutex Mutex; // of what follows
  std::map<MarchVariant, vk::raii::Pipeline> Pipelines;
};
}
}

#endif
