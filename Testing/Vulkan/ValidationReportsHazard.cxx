// SPDX-License-Identifier: BSD-3-Clause
// Writes a buffer twice without a barrier. Under the environment of the tests, the validation layer
// must name it.

#include <vulkan/vulkan_raii.hpp>

#include <cstdlib>
#include <iostream>

int main()
{
  vk::raii::Context context;
  vk::ApplicationInfo application("ValidationReportsHazard", 0, nullptr, 0, VK_API_VERSION_1_2);
  vk::raii::Instance instance(context, vk::InstanceCreateInfo({}, &application));
  vk::raii::PhysicalDevices physicalDevices(instance);
  if (physicalDevices.empty())
  {
    std::cerr << "no Vulkan device\n";
    return EXIT_FAILURE;
  }
  vk::raii::PhysicalDevice& physicalDevice = physicalDevices.front();

  const float priority = 1.0f;
  vk::DeviceQueueCreateInfo queueInfo({}, 0, 1, &priority);
  vk::raii::Device device(physicalDevice, vk::DeviceCreateInfo({}, queueInfo));

  const vk::DeviceSize size = 256;
  vk::raii::Buffer buffer(
    device, vk::BufferCreateInfo({}, size, vk::BufferUsageFlagBits::eTransferDst));
  const vk::MemoryRequirements needs = buffer.getMemoryRequirements();
  uint32_t type = 0;
  while (!(needs.memoryTypeBits & (1u << type)))
  {
    ++type;
  }
  vk::raii::DeviceMemory memory(device, vk::MemoryAllocateInfo(needs.size, type));
  buffer.bindMemory(*memory, 0);

  vk::raii::CommandPool pool(device, vk::CommandPoolCreateInfo({}, 0));
  vk::raii::CommandBuffers commands(
    device, vk::CommandBufferAllocateInfo(*pool, vk::CommandBufferLevel::ePrimary, 1));
  commands.front().begin(vk::CommandBufferBeginInfo());
  commands.front().fillBuffer(*buffer, 0, size, 1);
  commands.front().fillBuffer(*buffer, 0, size, 2);
  commands.front().end();
  return EXIT_SUCCESS;
}
