// SPDX-License-Identifier: BSD-3-Clause
// The device that a renderer uses, and what becomes of work on it that fails: words for the user,
// and whether it is tried again.
#ifndef ExaBricksVulkanDeviceSession_h
#define ExaBricksVulkanDeviceSession_h

#include "Vulkan/Device.h"

namespace exabricks
{
namespace vulkan
{
class DeviceSession
{
public:
  /// As for VolumeRenderer::selectDevice(). False: it was chosen before.
  bool select(const std::string& requested);
  /// Acquired when first asked for. Throws Failure.
  const std::shared_ptr<Device>& device();
  /// Of the device used last; empty, if there was none.
  const std::string& name() const { return this->Name; }
  void release() { this->Used.reset(); }

  /// What has to be given up after a failure.
  struct Release
  {
    std::function<void()> all;     // all that is on the device, and the device
    std::function<void()> picture; // what is on the device for a picture of this size
  };
  /// Runs `work`, and returns an empty string, or what went wrong. After the loss of a device all
  /// is built anew, once. What would fail again is not tried again before forget().
  std::string run(const std::function<void()>& work, const Release& release);

  /// Whether the device was lost with the last work, and lost again.
  bool lostTwice() const { return this->LostTwice; }
  /// Something has changed: whatever failed may be tried again.
  void forget();

private:
  std::string Keep(const std::string& fault);

  std::string Requested;
  std::string Name;
  std::shared_ptr<Device> Used;
  std::string Fault; // which stays before forget()
  bool LostTwice = false;
};
}
}

#endif
