// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/AccelerationStructure.h"

#include <cmath>

namespace exabricks
{
namespace vulkan
{
namespace
{
// The boxes in float32, a little too large: the shader tests the exact box, so the float box, and
// the query's rounded origin, must only never miss.
std::vector<vk::AabbPositionsKHR> makeBoxes(
  const glm::ivec3& bounds, const std::vector<layout::ActiveBox>& active)
{
  const int size = std::max({ bounds.x, bounds.y, bounds.z });
  const float slack = 4.0f * std::numeric_limits<float>::epsilon() * static_cast<float>(size);
  std::vector<vk::AabbPositionsKHR> boxes;
  boxes.reserve(active.size());
  for (const layout::ActiveBox& box : active)
  {
    const glm::vec3 lo = glm::vec3(box.lo) - slack;
    const glm::vec3 hi = glm::vec3(box.hi) + slack;
    boxes.emplace_back(lo.x, lo.y, lo.z, hi.x, hi.y, hi.z);
  }
  return boxes;
}
}

AccelerationStructure::Part AccelerationStructure::Build(const std::shared_ptr<Device>& device,
  vk::AccelerationStructureTypeKHR type, const vk::AccelerationStructureGeometryKHR& geometry,
  std::uint32_t count)
{
  vk::AccelerationStructureBuildGeometryInfoKHR build(type,
    vk::BuildAccelerationStructureFlagBitsKHR::ePreferFastTrace,
    vk::BuildAccelerationStructureModeKHR::eBuild, {}, {}, geometry);
  const auto sizes = device->handle().getAccelerationStructureBuildSizesKHR(
    vk::AccelerationStructureBuildTypeKHR::eDevice, build, count);
  Part part;
  part.Storage = Buffer(device, sizes.accelerationStructureSize, Residence::Device,
    "the acceleration structure", vk::BufferUsageFlagBits::eAccelerationStructureStorageKHR);
  part.Handle = vk::raii::AccelerationStructureKHR(device->handle(),
    vk::AccelerationStructureCreateInfoKHR(
      {}, *part.Storage.handle(), 0, sizes.accelerationStructureSize, type));
  const vk::DeviceSize alignment = device->scratchAlignment();
  const Buffer scratch(device, sizes.buildScratchSize + alignment, Residence::Device,
    "building the acceleration structure");
  build.dstAccelerationStructure = *part.Handle;
  build.scratchData.deviceAddress = (scratch.address() + alignment - 1) / alignment * alignment;
  const vk::AccelerationStructureBuildRangeInfoKHR range(count, 0, 0, 0);
  device->submit([&](const vk::raii::CommandBuffer& commands)
    { commands.buildAccelerationStructuresKHR(build, &range); });
  return part;
}

AccelerationStructure::AccelerationStructure(const std::shared_ptr<Device>& device,
  const glm::ivec3& bounds, const std::vector<layout::ActiveBox>& active)
{
  if (active.size() > device->maximumBoxes())
  {
    throw Failure("expected at most " + std::to_string(device->maximumBoxes()) +
      " active regions for traversal by ray query on " + device->name() + ", found " +
      std::to_string(active.size()) + ". Use the k-d tree traversal");
  }
  const auto input = vk::BufferUsageFlagBits::eAccelerationStructureBuildInputReadOnlyKHR;
  const Buffer boxes =
    makeBuffer(device, makeBoxes(bounds, active), "the active regions' boxes", input);
  vk::AccelerationStructureGeometryKHR geometry(vk::GeometryTypeKHR::eAabbs,
    vk::AccelerationStructureGeometryAabbsDataKHR(boxes.address(), sizeof(vk::AabbPositionsKHR)));
  this->Boxes = Build(device, vk::AccelerationStructureTypeKHR::eBottomLevel, geometry,
    static_cast<std::uint32_t>(active.size()));

  const vk::DeviceAddress bottom =
    device->handle().getAccelerationStructureAddressKHR({ *this->Boxes.Handle });
  const vk::TransformMatrixKHR identity(std::array<std::array<float, 4>, 3>{
    { { 1.f, 0.f, 0.f, 0.f }, { 0.f, 1.f, 0.f, 0.f }, { 0.f, 0.f, 1.f, 0.f } } });
  const std::vector<vk::AccelerationStructureInstanceKHR> one{ vk::AccelerationStructureInstanceKHR(
    identity, 0, 0xff, 0, {}, bottom) };
  const Buffer instances = makeBuffer(device, one, "the acceleration structure's instance", input);
  geometry = vk::AccelerationStructureGeometryKHR(vk::GeometryTypeKHR::eInstances,
    vk::AccelerationStructureGeometryInstancesDataKHR(false, instances.address()));
  this->Scene = Build(device, vk::AccelerationStructureTypeKHR::eTopLevel, geometry, 1);
  this->Address = device->handle().getAccelerationStructureAddressKHR({ *this->Scene.Handle });
}
}
}
