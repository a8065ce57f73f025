// SPDX-License-Identifier: BSD-3-Clause
// A driver that fails on request: while one of these lives, some of its functions go through tests'
// own. Devices that were acquired before it are not handed out again.
#ifndef ExaBricksTestingFaultyDriver_h
#define ExaBricksTestingFaultyDriver_h

#include "Vulkan/Device.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

namespace exabricks
{
class FaultyDriver
{
public:
  int lostSubmits = 0;           // so many next submits fail with "device lost"
  int submitsWithoutMemory = 0;  // and so many with "out of device memory"
  int submits = 0;               // that came through
  std::optional<void*> mappedAt; // what mapping memory answers, with success
  /// Of devices acquired from now on: bytes that they say they have available, at most.
  std::uint64_t availableMemory = std::numeric_limits<std::uint64_t>::max();
  /// Of devices acquired from now on: what kind they say they are.
  std::optional<VkPhysicalDeviceType> deviceType;

  FaultyDriver()
    : First(vulkan::Device::acquire(""))
    , Functions(const_cast<Dispatcher*>(this->First->physical().getDispatcher()))
    , True(*this->Functions)
  {
    Active() = this;
    this->Functions->vkGetDeviceProcAddr = GetDeviceProcAddr;
    this->Functions->vkGetPhysicalDeviceMemoryProperties2 = GetMemoryProperties2;
    this->Functions->vkGetPhysicalDeviceProperties = GetProperties;
    this->First->markLost();
  }

  ~FaultyDriver()
  {
    this->Functions->vkGetDeviceProcAddr = this->True.vkGetDeviceProcAddr;
    this->Functions->vkGetPhysicalDeviceMemoryProperties2 =
      this->True.vkGetPhysicalDeviceMemoryProperties2;
    this->Functions->vkGetPhysicalDeviceProperties = this->True.vkGetPhysicalDeviceProperties;
    // What was acquired meanwhile still has the functions of this one, which then pass on.
    Active() = nullptr;
    vulkan::Device::acquire("")->markLost();
  }

  /// Whether devices say how much memory they have available.
  bool tellsMemory() const
  {
    const auto extensions = this->First->physical().enumerateDeviceExtensionProperties();
    return std::any_of(extensions.begin(), extensions.end(),
      [](const vk::ExtensionProperties& extension) {
        return std::string(extension.extensionName.data()) == VK_EXT_MEMORY_BUDGET_EXTENSION_NAME;
      });
  }

  /// Nothing fails any more.
  void heal()
  {
    this->lostSubmits = 0;
    this->submitsWithoutMemory = 0;
    this->mappedAt.reset();
    this->availableMemory = std::numeric_limits<std::uint64_t>::max();
  }

  FaultyDriver(const FaultyDriver&) = delete;
  FaultyDriver& operator=(const FaultyDriver&) = delete;

private:
  using Dispatcher = std::remove_const_t<
    std::remove_pointer_t<decltype(std::declval<vk::raii::PhysicalDevice>().getDispatcher())>>;

  static FaultyDriver*& Active()
  {
    static FaultyDriver* active = nullptr;
    return active;
  }

  // The driver's own functions, of the device made last.
  struct Own
  {
    PFN_vkQueueSubmit queueSubmit = nullptr;
    PFN_vkMapMemory mapMemory = nullptr;
  };
  static Own& OwnFunctions()
  {
    static Own functions;
    return functions;
  }

  static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetDeviceProcAddr(
    VkDevice device, const char* name)
  {
    const PFN_vkVoidFunction own = Active()->True.vkGetDeviceProcAddr(device, name);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
    {
      return reinterpret_cast<PFN_vkVoidFunction>(&GetDeviceProcAddr);
    }
    if (std::strcmp(name, "vkQueueSubmit") == 0)
    {
      OwnFunctions().queueSubmit = reinterpret_cast<PFN_vkQueueSubmit>(own);
      return reinterpret_cast<PFN_vkVoidFunction>(&QueueSubmit);
    }
    if (std::strcmp(name, "vkMapMemory") == 0)
    {
      OwnFunctions().mapMemory = reinterpret_cast<PFN_vkMapMemory>(own);
      return reinterpret_cast<PFN_vkVoidFunction>(&MapMemory);
    }
    return own;
  }

  static VKAPI_ATTR VkResult VKAPI_CALL QueueSubmit(
    VkQueue queue, std::uint32_t count, const VkSubmitInfo* submits, VkFence fence)
  {
    FaultyDriver* const active = Active();
    if (active && active->lostSubmits > 0)
    {
      --active->lostSubmits;
      return VK_ERROR_DEVICE_LOST;
    }
    if (active && active->submitsWithoutMemory > 0)
    {
      --active->submitsWithoutMemory;
      return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    }
    if (active)
    {
      ++active->submits;
    }
    return OwnFunctions().queueSubmit(queue, count, submits, fence);
  }

  static VKAPI_ATTR VkResult VKAPI_CALL MapMemory(VkDevice device, VkDeviceMemory memory,
    VkDeviceSize offset, VkDeviceSize size, VkMemoryMapFlags flags, void** data)
  {
    const VkResult result = OwnFunctions().mapMemory(device, memory, offset, size, flags, data);
    if (Active() && Active()->mappedAt)
    {
      *data = *Active()->mappedAt;
    }
    return result;
  }

  static VKAPI_ATTR void VKAPI_CALL GetMemoryProperties2(
    VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties2* properties)
  {
    Active()->True.vkGetPhysicalDeviceMemoryProperties2(device, properties);
    for (auto* next = static_cast<VkBaseOutStructure*>(properties->pNext); next; next = next->pNext)
    {
      if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT)
      {
        auto* const budget = reinterpret_cast<VkPhysicalDeviceMemoryBudgetPropertiesEXT*>(next);
        for (std::uint32_t heap = 0; heap < VK_MAX_MEMORY_HEAPS; ++heap)
        {
          const std::uint64_t most = Active()->availableMemory;
          const VkDeviceSize used = budget->heapUsage[heap];
          budget->heapBudget[heap] =
            std::min<VkDeviceSize>(budget->heapBudget[heap], most > ~used ? ~0ull : used + most);
        }
      }
    }
  }

  static VKAPI_ATTR void VKAPI_CALL GetProperties(
    VkPhysicalDevice device, VkPhysicalDeviceProperties* properties)
  {
    Active()->True.vkGetPhysicalDeviceProperties(device, properties);
    if (Active()->deviceType)
    {
      properties->deviceType = *Active()->deviceType;
    }
  }

  const std::shared_ptr<vulkan::Device> First; // keeps the instance, and its functions
  Dispatcher* const Functions;
  const Dispatcher True;
};
}

#endif
