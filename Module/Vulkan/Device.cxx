// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/Device.h"

#include "Core/LowerCase.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

namespace exabricks
{
namespace vulkan
{
namespace
{
constexpr std::uint32_t ApiVersion = VK_API_VERSION_1_2;
constexpr vk::DeviceSize LargestValueBuffer = vk::DeviceSize(1) << 30;

// The context loads libvulkan, and has to outlive the instance.
struct LoadedInstance
{
  vk::raii::Context context;
  vk::raii::Instance instance = nullptr;
};

std::shared_ptr<vk::raii::Instance> makeInstance()
{
  try
  {
    const auto loaded = std::make_shared<LoadedInstance>();
    const vk::ApplicationInfo application("ExaBricks", 1, "ExaBricks", 1, ApiVersion);
    loaded->instance =
      vk::raii::Instance(loaded->context, vk::InstanceCreateInfo({}, &application));
    return std::shared_ptr<vk::raii::Instance>(loaded, &loaded->instance);
  }
  catch (const std::exception& error)
  {
    throw Failure(std::string("expected a Vulkan loader and driver, found none (") + error.what() +
      "). Install them (Debian: libvulkan1 and mesa-vulkan-drivers 24.1 or newer)");
  }
}

bool hasExtension(const vk::raii::PhysicalDevice& device, const char* name)
{
  const auto extensions = device.enumerateDeviceExtensionProperties();
  return std::any_of(extensions.begin(), extensions.end(),
    [&](const vk::ExtensionProperties& e) { return std::string(e.extensionName.data()) == name; });
}

// A family that computes; where there is one that does not draw, that, which runs beside what draws
// the display.
std::optional<std::uint32_t> findComputeQueue(const vk::raii::PhysicalDevice& device)
{
  const auto families = device.getQueueFamilyProperties();
  std::optional<std::uint32_t> found;
  for (std::uint32_t family = 0; family < families.size(); ++family)
  {
    const vk::QueueFlags flags = families[family].queueFlags;
    if (families[family].queueCount == 0 || !(flags & vk::QueueFlagBits::eCompute))
    {
      continue;
    }
    if (!(flags & vk::QueueFlagBits::eGraphics))
    {
      return family;
    }
    found = found ? found : family;
  }
  return found;
}

// Whether there is no memory but the host's, in a type that both can use as it is.
bool hasSharedMemory(vk::PhysicalDeviceType type, const vk::PhysicalDeviceMemoryProperties& memory)
{
  constexpr vk::MemoryPropertyFlags shared = vk::MemoryPropertyFlagBits::eDeviceLocal |
    vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  const auto* const end = memory.memoryTypes.data() + memory.memoryTypeCount;
  return (type == vk::PhysicalDeviceType::eCpu || type == vk::PhysicalDeviceType::eIntegratedGpu) &&
    std::any_of(memory.memoryTypes.data(), end,
      [&](const vk::MemoryType& t) { return (t.propertyFlags & shared) == shared; });
}

// Empty, or what the marching pass needs and the device lacks.
std::string lacks(const vk::raii::PhysicalDevice& device)
{
  const vk::PhysicalDeviceProperties properties = device.getProperties();
  if (properties.apiVersion < ApiVersion)
  {
    return "Vulkan 1.2";
  }
  const auto features =
    device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features>();
  const auto& v12 = features.get<vk::PhysicalDeviceVulkan12Features>();
  const auto all =
    device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>();
  const auto& subgroups = all.get<vk::PhysicalDeviceSubgroupProperties>();
  const bool votes = (subgroups.supportedOperations & vk::SubgroupFeatureFlagBits::eVote) &&
    (subgroups.supportedStages & vk::ShaderStageFlagBits::eCompute);
  return !v12.bufferDeviceAddress ? "bufferDeviceAddress"
    : !v12.scalarBlockLayout      ? "scalarBlockLayout"
    : !votes                      ? "votes of subgroups"
    : !findComputeQueue(device)   ? "a queue for compute"
                                  : "";
}

bool canQueryRays(const vk::raii::PhysicalDevice& device)
{
  if (!hasExtension(device, VK_KHR_RAY_QUERY_EXTENSION_NAME) ||
    !hasExtension(device, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME) ||
    !hasExtension(device, VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME))
  {
    return false;
  }
  const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2,
    vk::PhysicalDeviceRayQueryFeaturesKHR, vk::PhysicalDeviceAccelerationStructureFeaturesKHR>();
  return features.get<vk::PhysicalDeviceRayQueryFeaturesKHR>().rayQuery &&
    features.get<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>().accelerationStructure;
}

int preference(vk::PhysicalDeviceType type)
{
  switch (type)
  {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return 4;
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return 3;
    case vk::PhysicalDeviceType::eVirtualGpu:
      return 2;
    case vk::PhysicalDeviceType::eCpu:
      return 1;
    default:
      return 0;
  }
}

// Device name, and the driver's, since users know "lavapipe" and "llvmpipe" as names too.
std::string fullName(const vk::raii::PhysicalDevice& device)
{
  const auto properties =
    device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
  const std::string driver = properties.get<vk::PhysicalDeviceDriverProperties>().driverName.data();
  const std::string name =
    properties.get<vk::PhysicalDeviceProperties2>().properties.deviceName.data();
  return name + (driver.empty() ? "" : ", " + (driver == "llvmpipe" ? "lavapipe" : driver));
}

std::string describe(const std::vector<vk::raii::PhysicalDevice>& devices)
{
  std::string text;
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    const std::string lack = lacks(devices[i]);
    text += (i ? "; [" : "[") + std::to_string(i) + "] " + fullName(devices[i]) +
      (lack.empty() ? "" : " (lacks " + lack + ")");
  }
  return text.empty() ? "none" : text;
}

std::size_t choose(const std::vector<vk::raii::PhysicalDevice>& devices, const std::string& wanted)
{
  // A larger number is part of a name, such as 4090.
  const bool isIndex = !wanted.empty() && wanted.size() < 6 &&
    std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); }) &&
    std::stoul(wanted) < devices.size();
  std::size_t best = devices.size();
  int bestPreference = -1;
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    const bool asked = wanted.empty() ||
      (isIndex ? i == std::stoul(wanted)
               : lowerCase(fullName(devices[i])).find(lowerCase(wanted)) != std::string::npos);
    const int rank = preference(devices[i].getProperties().deviceType);
    if (asked && lacks(devices[i]).empty() && rank > bestPreference)
    {
      best = i;
      bestPreference = rank;
    }
  }
  if (best == devices.size())
  {
    const std::string expected = wanted.empty()
      ? "expected a Vulkan 1.2 device with bufferDeviceAddress, scalarBlockLayout and votes of "
        "subgroups"
      : "expected a usable Vulkan device with '" + wanted + "' as its index or in its name";
    throw Failure(expected + ", found " + describe(devices) +
      ". Choose another one by the property Device or EXABRICKS_DEVICE, or install a driver "
      "(without a GPU: Mesa's lavapipe)");
  }
  return best;
}
}

std::shared_ptr<Device> Device::acquire(const std::string& wanted)
{
  static std::mutex mutex;
  static std::weak_ptr<vk::raii::Instance> sharedInstance;
  static std::map<std::size_t, std::weak_ptr<Device>> sharedDevices;

  const std::lock_guard<std::mutex> lock(mutex);
  std::string request = wanted;
  const char* environment = std::getenv("EXABRICKS_DEVICE");
  if (request.empty() && environment)
  {
    request = environment;
  }
  std::shared_ptr<vk::raii::Instance> instance = sharedInstance.lock();
  if (!instance)
  {
    instance = makeInstance();
    sharedInstance = instance;
  }
  vk::raii::PhysicalDevices devices(*instance);
  const std::size_t index = choose(devices, request);
  std::shared_ptr<Device> device = sharedDevices[index].lock();
  if (!device || device->lost())
  {
    device = std::make_shared<Device>(instance, std::move(devices[index]));
    sharedDevices[index] = device;
  }
  return device;
}

std::vector<std::string> Device::list()
{
  const auto instance = makeInstance();
  const vk::raii::PhysicalDevices devices(*instance);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    const std::string lack = lacks(devices[i]);
    lines.push_back(std::to_string(i) + ": " + fullName(devices[i]) +
      (!lack.empty()                 ? " (cannot be used: lacks " + lack + ")"
          : canQueryRays(devices[i]) ? " (with ray query)"
                                     : " (without ray query)"));
  }
  return lines;
}

Device::Device(std::shared_ptr<vk::raii::Instance> instance, vk::raii::PhysicalDevice physical)
  : Instance(std::move(instance))
  , Physical(std::move(physical))
{
  const vk::PhysicalDeviceProperties properties = this->Physical.getProperties();
  this->Name = properties.deviceName.data();
  this->Cpu = properties.deviceType == vk::PhysicalDeviceType::eCpu;
  this->RayQuery = canQueryRays(this->Physical);
  this->Int64 = this->Physical.getFeatures().shaderInt64;
  this->MemoryBudget = hasExtension(this->Physical, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
  this->Memory = this->Physical.getMemoryProperties();
  this->SharesMemory = hasSharedMemory(properties.deviceType, this->Memory);
  this->MaximumAllocation =
    this->Physical
      .getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceMaintenance3Properties>()
      .get<vk::PhysicalDeviceMaintenance3Properties>()
      .maxMemoryAllocationSize;
  this->MaximumValueBuffer = std::min(this->MaximumAllocation, LargestValueBuffer);

  std::vector<const char*> extensions;
  if (this->MemoryBudget)
  {
    extensions.push_back(VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
  }
  vk::StructureChain<vk::DeviceCreateInfo, vk::PhysicalDeviceFeatures2,
    vk::PhysicalDeviceVulkan12Features, vk::PhysicalDeviceRayQueryFeaturesKHR,
    vk::PhysicalDeviceAccelerationStructureFeaturesKHR>
    chain;
  chain.get<vk::PhysicalDeviceVulkan12Features>().setBufferDeviceAddress(true).setScalarBlockLayout(
    true);
  if (this->RayQuery)
  {
    extensions.insert(extensions.end(),
      { VK_KHR_RAY_QUERY_EXTENSION_NAME, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
        VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME });
    chain.get<vk::PhysicalDeviceRayQueryFeaturesKHR>().setRayQuery(true);
    chain.get<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>().setAccelerationStructure(true);
    const auto limits = this->Physical
                          .getProperties2<vk::PhysicalDeviceProperties2,
                            vk::PhysicalDeviceAccelerationStructurePropertiesKHR>()
                          .get<vk::PhysicalDeviceAccelerationStructurePropertiesKHR>();
    this->MaximumBoxes = limits.maxPrimitiveCount;
    this->ScratchAlignment = limits.minAccelerationStructureScratchOffsetAlignment;
  }
  else
  {
    chain.unlink<vk::PhysicalDeviceRayQueryFeaturesKHR>();
    chain.unlink<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>();
  }
  chain.get<vk::PhysicalDeviceFeatures2>().features.setShaderInt64(this->Int64);
  const std::uint32_t family = findComputeQueue(this->Physical).value();
  const float priority = 1.0f;
  const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
  chain.get<vk::DeviceCreateInfo>().setQueueCreateInfos(queue).setPEnabledExtensionNames(
    extensions);
  this->Logical = vk::raii::Device(this->Physical, chain.get<vk::DeviceCreateInfo>());
  this->Queue = vk::raii::Queue(this->Logical, family, 0);
  this->Pool =
    vk::raii::CommandPool(this->Logical, { vk::CommandPoolCreateFlagBits::eTransient, family });
  this->Cache = vk::raii::PipelineCache(this->Logical, vk::PipelineCacheCreateInfo());
}

std::uint32_t Device::findMemoryType(std::uint32_t allowed, vk::MemoryPropertyFlags required,
  vk::MemoryPropertyFlags preferred, vk::MemoryPropertyFlags avoided) const
{
  std::uint32_t best = this->Memory.memoryTypeCount;
  int bestCount = 0;
  for (std::uint32_t type = 0; type < this->Memory.memoryTypeCount; ++type)
  {
    const vk::MemoryPropertyFlags flags = this->memoryFlags(type);
    // Of the others, each takes a feature to be enabled or is not for buffers.
    constexpr vk::MemoryPropertyFlags usable = vk::MemoryPropertyFlagBits::eDeviceLocal |
      vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent |
      vk::MemoryPropertyFlagBits::eHostCached;
    if (!(allowed & (1u << type)) || (flags & ~usable) || (flags & required) != required)
    {
      continue;
    }
    int count = 8;
    for (const auto bit :
      { vk::MemoryPropertyFlagBits::eDeviceLocal, vk::MemoryPropertyFlagBits::eHostVisible,
        vk::MemoryPropertyFlagBits::eHostCached, vk::MemoryPropertyFlagBits::eHostCoherent })
    {
      count += (flags & preferred & bit) ? 1 : 0;
      count -= (flags & avoided & bit) ? 1 : 0;
    }
    if (count > bestCount)
    {
      best = type;
      bestCount = count;
    }
  }
  if (best == this->Memory.memoryTypeCount)
  {
    throw Failure(
      "expected a memory type with " + vk::to_string(required) + ", " + this->Name + " has none");
  }
  return best;
}

vk::MemoryPropertyFlags Device::memoryFlags(std::uint32_t type) const
{
  return this->Memory.memoryTypes[type].propertyFlags;
}

vk::DeviceSize Device::availableMemory(std::uint32_t type) const
{
  const std::uint32_t heap = this->Memory.memoryTypes[type].heapIndex;
  vk::DeviceSize available = this->Memory.memoryHeaps[heap].size;
  if (this->MemoryBudget)
  {
    const auto budget = this->Physical
                          .getMemoryProperties2<vk::PhysicalDeviceMemoryProperties2,
                            vk::PhysicalDeviceMemoryBudgetPropertiesEXT>()
                          .get<vk::PhysicalDeviceMemoryBudgetPropertiesEXT>();
    const vk::DeviceSize all = budget.heapBudget[heap];
    const vk::DeviceSize used = budget.heapUsage[heap];
    available = all > used ? all - used : 0;
  }
  return available;
}

Submission& Submission::operator=(Submission&& other)
{
  this->End();
  this->Owner = other.Owner;
  this->Commands = std::move(other.Commands);
  this->Fence = std::move(other.Fence);
  this->Pending = std::exchange(other.Pending, false);
  return *this;
}

Submission::~Submission() { this->End(); }

void Submission::wait()
{
  while (this->Pending &&
    this->Owner->Logical.waitForFences(*this->Fence, true, 1000000000ull) == vk::Result::eTimeout)
  {
  }
  this->Pending = false;
}

void Submission::End() noexcept
{
  try
  {
    this->wait();
  }
  catch (const std::exception&)
  {
    this->Pending = false; // A lost device does nothing any more.
  }
  if (this->Commands)
  {
    const std::lock_guard<std::mutex> lock(this->Owner->Mutex);
    this->Commands.reset();
  }
}

void Device::submit(const Record& record) const { this->start(record).wait(); }

Submission Device::start(const Record& record) const
{
  Submission submission;
  submission.Owner = this;
  const std::lock_guard<std::mutex> lock(this->Mutex);
  vk::raii::CommandBuffers buffers(
    this->Logical, { *this->Pool, vk::CommandBufferLevel::ePrimary, 1 });
  const vk::raii::CommandBuffer& commands = buffers.front();
  commands.begin({ vk::CommandBufferUsageFlagBits::eOneTimeSubmit });
  // After whatever earlier submissions wrote.
  const vk::MemoryBarrier everything(vk::AccessFlagBits::eMemoryWrite,
    vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite);
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands,
    vk::PipelineStageFlagBits::eAllCommands, {}, everything, {}, {});
  record(commands);
  commands.end();
  submission.Fence = vk::raii::Fence(this->Logical, vk::FenceCreateInfo());
  const vk::CommandBuffer handle = *commands;
  this->Queue.submit(vk::SubmitInfo(nullptr, nullptr, handle), *submission.Fence);
  submission.Pending = true;
  submission.Commands = std::make_unique<vk::raii::CommandBuffers>(std::move(buffers));
  return submission;
}
}
}
