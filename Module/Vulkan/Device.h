// SPDX-License-Identifier: BSD-3-Clause
// Instance, device and queue: one for each device in use, shared by all renderers of the process
// and gone with the last. Members throw vk::Error or vulkan::Failure; VolumeRenderer catches them.
#ifndef ExaBricksVulkanDevice_h
#define ExaBricksVulkanDevice_h

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace exabricks
{
namespace vulkan
{
/// What went wrong, for the user.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// One that concerns this picture alone: the next one may be drawn.
class PictureFailure : public Failure
{
public:
  using Failure::Failure;
};

class Device;

/// Work that the device has been given, see Device::start().
class Submission
{
public:
  Submission() = default;
  Submission(Submission&& other) { *this = std::move(other); }
  Submission& operator=(Submission&& other);
  /// Waits, but throws nothing.
  ~Submission();

  /// Until the device has done it. May be called again.
  void wait();

private:
  friend class Device;
  /// Gives the commands back to their pool.
  void End() noexcept;

  const Device* Owner = nullptr;
  std::unique_ptr<vk::raii::CommandBuffers> Commands;
  vk::raii::Fence Fence = nullptr;
  bool Pending = false;
};

class Device
{
public:
  /// The device of that index or with that text in its name; empty: the best one.
  static std::shared_ptr<Device> acquire(const std::string& wanted);
  /// One line for each device.
  static std::vector<std::string> list();

  Device(std::shared_ptr<vk::raii::Instance> instance, vk::raii::PhysicalDevice physical);

  const vk::raii::Device& handle() const { return this->Logical; }
  /// Of all renderers: what one has compiled, the next one need not.
  const vk::raii::PipelineCache& pipelineCache() const { return this->Cache; }
  const vk::raii::PhysicalDevice& physical() const { return this->Physical; }
  const std::string& name() const { return this->Name; }
  bool isCpu() const { return this->Cpu; }
  /// Whether all memory is the host's too: what both use is never copied between them.
  bool sharesMemory() const { return this->SharesMemory; }
  bool hasRayQuery() const { return this->RayQuery; }
  bool hasInt64() const { return this->Int64; } // in shaders
  vk::DeviceSize maximumAllocation() const { return this->MaximumAllocation; }
  /// Of a buffer of cells' values. Lowered by tests only, so that small data take several.
  vk::DeviceSize maximumValueBuffer() const { return this->MaximumValueBuffer; }
  void limitValueBuffers(vk::DeviceSize bytes) { this->MaximumValueBuffer = bytes; }
  std::uint64_t maximumBoxes() const { return this->MaximumBoxes; }
  vk::DeviceSize scratchAlignment() const { return this->ScratchAlignment; }

  /// The first memory type with `required` flags among `allowed`, with the most of `preferred` and
  /// the least of `avoided`, as drivers list the better ones first; throws Failure if there is
  /// none.
  std::uint32_t findMemoryType(std::uint32_t allowed, vk::MemoryPropertyFlags required,
    vk::MemoryPropertyFlags preferred, vk::MemoryPropertyFlags avoided) const;
  vk::MemoryPropertyFlags memoryFlags(std::uint32_t type) const;
  /// Bytes that can still be allocated of a memory type, as far as the driver tells.
  vk::DeviceSize availableMemory(std::uint32_t type) const;

  using Record = std::function<void(const vk::raii::CommandBuffer&)>;
  /// Records commands and submits them. They run after all that was submitted before, and see what
  /// that wrote.
  Submission start(const Record& record) const;
  /// The same, and waits for them.
  void submit(const Record& record) const;

  /// After a device was lost: it is not handed out again.
  void markLost() { this->Lost = true; }
  bool lost() const { return this->Lost; }

private:
  friend class Submission;

  std::shared_ptr<vk::raii::Instance> Instance;
  vk::raii::PhysicalDevice Physical;
  std::string Name;
  bool Cpu = false;
  bool SharesMemory = false;
  bool RayQuery = false;
  bool Int64 = false;
  bool MemoryBudget = false;
  bool Lost = false;
  vk::DeviceSize MaximumAllocation = 0;
  vk::DeviceSize MaximumValueBuffer = 0;
  std::uint64_t MaximumBoxes = 0;
  vk::DeviceSize ScratchAlignment = 1;
  vk::PhysicalDeviceMemoryProperties Memory;
  vk::raii::Device Logical = nullptr;
  vk::raii::Queue Queue = nullptr;
  vk::raii::CommandPool Pool = nullptr;
  vk::raii::PipelineCache Cache = nullptr;
  mutable std::mutex Mutex; // queue and pool
};
}
}

#endif
