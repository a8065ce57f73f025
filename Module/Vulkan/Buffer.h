// SPDX-License-Identifier: BSD-3-Clause
// Buffers that shaders reach by their device address, and how data get into and out of them.
#ifndef ExaBricksVulkanBuffer_h
#define ExaBricksVulkanBuffer_h

#include "Vulkan/Device.h"

namespace exabricks
{
namespace vulkan
{
enum class Residence
{
  Device,  // on the device; filled by upload()
  Upload,  // written by the host for each picture, read by the device
  Readback // written by the device, read by the host
};

class Buffer
{
public:
  Buffer() = default;
  /// Throws Failure, with the bytes needed and available, if it cannot be had. `what` names the
  /// contents in the message.
  Buffer(std::shared_ptr<Device> device, vk::DeviceSize bytes, Residence residence,
    const std::string& what, vk::BufferUsageFlags usage = {});

  const vk::raii::Buffer& handle() const { return this->Handle; }
  vk::DeviceAddress address() const { return this->Address; }
  vk::DeviceSize bytes() const { return this->Bytes; }
  /// Host address, or null where the host cannot see the memory.
  void* mapped() const { return this->Mapped; }

  /// Copies to the device, through a staging buffer where the host cannot see the memory.
  void upload(const void* data, vk::DeviceSize bytes, vk::DeviceSize offset = 0);

private:
  std::shared_ptr<Device> Owner;
  vk::raii::DeviceMemory Memory = nullptr;
  vk::raii::Buffer Handle = nullptr;
  vk::DeviceSize Bytes = 0;
  vk::DeviceAddress Address = 0;
  void* Mapped = nullptr;
};

/// A buffer with a copy of `items` (at least one element long, so that its address is valid).
template <typename T>
Buffer makeBuffer(const std::shared_ptr<Device>& device, const std::vector<T>& items,
  const std::string& what, vk::BufferUsageFlags usage = {})
{
  Buffer buffer(
    device, std::max<std::size_t>(items.size(), 1) * sizeof(T), Residence::Device, what, usage);
  buffer.upload(items.data(), items.size() * sizeof(T));
  return buffer;
}
}
}

#endif
