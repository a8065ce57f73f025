// SPDX-License-Identifier: BSD-3-Clause
// Buffers that shaders reach by their device address, and how data get into them.
#ifndef ExaBricksVulkanBuffer_h
#define ExaBricksVulkanBuffer_h

#include "Vulkan/Device.h"

namespace exabricks
{
namespace vulkan
{
enum class Residence
{
  Device,   // on the device; filled by upload()
  Staging,  // of the host, written by it, to be copied to the device
  Readback, // of the host, read by it after a copy from the device
  Shared    // written and read by both in place, where they share all memory
};

/// What a buffer is for, in the message that says that there is no memory for it.
struct Purpose
{
  Purpose(const char* what)
    : contents(what)
  {
  }
  /// For something that has as many elements as the picture has pixels.
  static Purpose ofPicture(const char* what, int width, int height);

  std::string contents;
  std::string advice = "Use fewer levels, or a device with more memory";
  bool concernsPicture = false; // and not the volume
};

class Buffer
{
public:
  Buffer() = default;
  /// Throws Failure, or PictureFailure, with the bytes needed and available, if it cannot be had.
  Buffer(std::shared_ptr<Device> device, vk::DeviceSize bytes, Residence residence,
    const Purpose& purpose, vk::BufferUsageFlags usage = {});

  const vk::raii::Buffer& handle() const { return this->Handle; }
  vk::DeviceAddress address() const { return this->Address; }
  vk::DeviceSize bytes() const { return this->Bytes; }
  /// Host address, or null where the host cannot see the memory.
  void* mapped() const { return this->Mapped; }

  /// Copies to the device, and waits until it is there. Where the host cannot see the memory, a
  /// part is written to one staging buffer while the part before is copied out of another.
  void upload(const void* data, vk::DeviceSize bytes, vk::DeviceSize offset = 0);
  /// Sets all to 0, for the shaders recorded after this.
  void clear(const vk::raii::CommandBuffer& commands) const;

private:
  /// Null, if there is no memory for it.
  void* Map() const;

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
  const Purpose& purpose, vk::BufferUsageFlags usage = {})
{
  Buffer buffer(
    device, std::max<std::size_t>(items.size(), 1) * sizeof(T), Residence::Device, purpose, usage);
  buffer.upload(items.data(), items.size() * sizeof(T));
  return buffer;
}
}
}

#endif
