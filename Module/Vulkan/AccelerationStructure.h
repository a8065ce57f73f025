// SPDX-License-Identifier: BSD-3-Clause
// An acceleration structure over boxes, with the one instance that ray queries ask for.
#ifndef ExaBricksVulkanAccelerationStructure_h
#define ExaBricksVulkanAccelerationStructure_h

#include "Layout.h"
#include "Vulkan/Buffer.h"

namespace exabricks
{
namespace vulkan
{
class AccelerationStructure
{
public:
  AccelerationStructure() = default;
  /// Of `active` in that order (on Mesa's CPU driver the order is the tree). `bounds`: size of the
  /// data's, half cells.
  AccelerationStructure(const std::shared_ptr<Device>& device, const glm::ivec3& bounds,
    const std::vector<layout::ActiveBox>& active);

  /// What a shader makes its accelerationStructureEXT of.
  vk::DeviceAddress address() const { return this->Address; }
  vk::DeviceSize bytes() const { return this->Boxes.Storage.bytes() + this->Scene.Storage.bytes(); }

private:
  struct Part
  {
    Buffer Storage;
    vk::raii::AccelerationStructureKHR Handle = nullptr;
  };
  static Part Build(const std::shared_ptr<Device>& device, vk::AccelerationStructureTypeKHR type,
    const vk::AccelerationStructureGeometryKHR& geometry, std::uint32_t count);

  Part Boxes;
  Part Scene;
  vk::DeviceAddress Address = 0;
};
}
}

#endif
