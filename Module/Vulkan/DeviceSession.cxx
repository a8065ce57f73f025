// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/DeviceSession.h"

namespace exabricks
{
namespace vulkan
{
bool DeviceSession::select(const std::string& requested)
{
  if (requested == this->Requested)
  {
    return false;
  }
  this->Requested = requested;
  return true;
}

const std::shared_ptr<Device>& DeviceSession::device()
{
  if (!this->Used)
  {
    this->Used = Device::acquire(this->Requested);
    this->Name = this->Used->name();
  }
  return this->Used;
}

void DeviceSession::forget()
{
  this->Fault.clear();
  this->LostTwice = false;
}

std::string DeviceSession::Keep(const std::string& fault)
{
  this->Fault = fault;
  return fault;
}

std::string DeviceSession::run(const std::function<void()>& work, const Release& release)
{
  if (!this->Fault.empty())
  {
    return this->Fault;
  }
  for (int attempt = 0;; ++attempt)
  {
    try
    {
      work();
      return {};
    }
    catch (const vk::DeviceLostError& error)
    {
      if (this->Used)
      {
        this->Used->markLost();
      }
      release.all();
      if (attempt == 1)
      {
        this->LostTwice = true;
        return this->Keep(std::string("the Vulkan device was lost twice (") + error.what() +
          "). It is not tried again before the view, the data or a property changes. The driver's "
          "log may say why; choose another device by the property Device or EXABRICKS_DEVICE");
      }
    }
    catch (const std::bad_alloc&)
    {
      release.all();
      return "out of memory on the host. Read fewer levels, or make the window smaller";
    }
    catch (const vk::OutOfHostMemoryError& error)
    {
      release.all();
      return "out of memory on the host, in the driver of " + this->Name + " (" + error.what() +
        "). Read fewer levels, or make the window smaller";
    }
    catch (const vk::OutOfDeviceMemoryError& error)
    {
      release.all();
      return "out of device memory on " + this->Name + " (" + error.what() +
        "). Use fewer levels, make the window smaller, or use a device with more memory";
    }
    catch (const std::length_error& error)
    {
      release.all();
      return this->Keep(error.what()); // Core has words for too many regions.
    }
    catch (const PictureFailure& failure)
    {
      release.picture(); // All the rest can draw a smaller picture.
      return failure.what();
    }
    catch (const Failure& failure)
    {
      release.all();
      return this->Keep(failure.what());
    }
    catch (const std::exception& error)
    {
      release.all();
      return std::string("Vulkan failed: ") + error.what();
    }
  }
}
}
}
