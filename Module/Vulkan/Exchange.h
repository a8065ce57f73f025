// SPDX-License-Identifier: BSD-3-Clause
// What host and device exchange with each picture. Where they share memory, both use one buffer as
// it is; elsewhere it lies on the device and is copied once, by commands recorded beside those that
// use it.
#ifndef ExaBricksVulkanExchange_h
#define ExaBricksVulkanExchange_h

#include "Vulkan/Buffer.h"

namespace exabricks
{
namespace vulkan
{
/// From the host to the device.
class Input
{
public:
  /// Makes room for so many bytes, unless there is. Throws Failure or PictureFailure.
  void reserve(const std::shared_ptr<Device>& device, vk::DeviceSize bytes, const Purpose& purpose);
  /// Host memory to write to, when the device is done with what was recorded last.
  void* data() const;
  vk::DeviceAddress address() const { return this->OnDevice.address(); }
  /// Gives shaders the first `bytes` of what was written.
  void record(const vk::raii::CommandBuffer& commands, vk::DeviceSize bytes) const;

private:
  Buffer OnDevice;
  Buffer Staged; // none where memory is shared
};

/// From the device to the host.
class Output
{
public:
  /// As for Input.
  void reserve(const std::shared_ptr<Device>& device, vk::DeviceSize bytes, const Purpose& purpose);
  vk::DeviceAddress address() const { return this->OnDevice.address(); }
  /// Sets all to 0, for the commands recorded after this.
  void clear(const vk::raii::CommandBuffer& commands) const { this->OnDevice.clear(commands); }
  /// Gives the host the first `bytes` of what shaders wrote.
  void record(const vk::raii::CommandBuffer& commands, vk::DeviceSize bytes) const;
  /// Host memory to read from, when the device has done what was recorded.
  const void* data() const;

private:
  Buffer OnDevice;
  Buffer ReadBack; // none where memory is shared
};
}
}

#endif
