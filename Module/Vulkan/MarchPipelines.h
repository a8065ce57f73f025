// SPDX-License-Identifier: BSD-3-Clause
// The pipelines of Shaders/March.comp on one device, one for each variant in use.
#ifndef ExaBricksVulkanMarchPipelines_h
#define ExaBricksVulkanMarchPipelines_h

#include "Vulkan/Device.h"
#include "Vulkan/MarchVariant.h"

#include <map>

namespace exabricks
{
namespace vulkan
{
class MarchPipelines
{
public:
  /// `program`: its shader takes the place of ours in all variants; may be null, or have none.
  explicit MarchPipelines(
    std::shared_ptr<Device> device, std::shared_ptr<const MarchProgram> program = nullptr);

  /// Made when first asked for, and kept: drivers compile for a long time. Throws vk::Error.
  vk::Pipeline find(const MarchVariant& variant);
  /// Of all of them: one layout::Band as push constants, and nothing else.
  vk::PipelineLayout layout() const { return *this->Layout; }

private:
  vk::raii::Pipeline Make(const MarchVariant& variant) const;

  std::shared_ptr<Device> Owner;
  std::shared_ptr<const MarchProgram> Program;
  vk::raii::PipelineLayout Layout = nullptr;
  std::map<MarchVariant, vk::raii::Pipeline> Pipelines;
};
}
}

#endif
