// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/Buffer.h"

#include <algorithm>
#include <cstring>

namespace exabricks
{
namespace vulkan
{
namespace
{
std::string megabytes(vk::DeviceSize bytes)
{
  return std::to_string(bytes) + " bytes (" + std::to_string(bytes >> 20) + " MiB)";
}
}

Buffer::Buffer(std::shared_ptr<Device> device, vk::DeviceSize bytes, Residence residence,
  const std::string& what, vk::BufferUsageFlags usage)
  : Owner(std::move(device))
  , Bytes(bytes)
{
  using Flag = vk::MemoryPropertyFlagBits;
  const vk::MemoryPropertyFlags hostWrites = Flag::eHostVisible | Flag::eHostCoherent;
  vk::MemoryPropertyFlags required;
  vk::MemoryPropertyFlags preferred;
  vk::MemoryPropertyFlags avoided;
  switch (residence)
  {
    case Residence::Device:
      required = Flag::eDeviceLocal;
      // where all memory is one, as on CPUs, nothing needs staging
      preferred = this->Owner->isCpu() ? hostWrites : vk::MemoryPropertyFlags();
      break;
    case Residence::Upload:
      // Not on the device: what of that the host can write may be small.
      required = hostWrites;
      avoided = Flag::eDeviceLocal;
      break;
    case Residence::Readback:
      required = hostWrites;
      preferred = Flag::eHostCached;
      avoided = Flag::eDeviceLocal;
      break;
  }
  this->Handle = vk::raii::Buffer(this->Owner->handle(),
    vk::BufferCreateInfo({}, bytes,
      usage | vk::BufferUsageFlagBits::eShaderDeviceAddress |
        vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst |
        vk::BufferUsageFlagBits::eTransferSrc));
  const vk::MemoryRequirements needs = this->Handle.getMemoryRequirements();
  const std::uint32_t type =
    this->Owner->findMemoryType(needs.memoryTypeBits, required, preferred, avoided);
  const vk::DeviceSize available = this->Owner->availableMemory(type);
  const auto refuse = [&]() -> Failure
  {
    return Failure("out of device memory: " + what + " needs " + megabytes(needs.size) + ", " +
      this->Owner->name() + " has " + megabytes(available) +
      " available. Use fewer levels, or a device with more memory");
  };
  if (needs.size > available)
  {
    throw refuse();
  }
  if (needs.size > this->Owner->maximumAllocation())
  {
    throw Failure(what + " needs " + megabytes(needs.size) + " in one piece, " +
      this->Owner->name() + " allows " + megabytes(this->Owner->maximumAllocation()) +
      ". Use fewer levels");
  }
  try
  {
    const vk::MemoryAllocateFlagsInfo flags(vk::MemoryAllocateFlagBits::eDeviceAddress);
    this->Memory = vk::raii::DeviceMemory(
      this->Owner->handle(), vk::MemoryAllocateInfo(needs.size, type, &flags));
  }
  catch (const vk::OutOfDeviceMemoryError&)
  {
    throw refuse();
  }
  catch (const vk::OutOfHostMemoryError&)
  {
    throw refuse();
  }
  this->Handle.bindMemory(*this->Memory, 0);
  this->Address = this->Owner->handle().getBufferAddress({ *this->Handle });
  const vk::MemoryPropertyFlags flags = this->Owner->memoryFlags(type);
  if ((flags & hostWrites) == hostWrites &&
    (residence != Residence::Device || this->Owner->isCpu()))
  {
    this->Mapped = this->Memory.mapMemory(0, VK_WHOLE_SIZE);
  }
}

void Buffer::upload(const void* data, vk::DeviceSize bytes, vk::DeviceSize offset)
{
  if (bytes == 0)
  {
    return;
  }
  if (this->Mapped)
  {
    std::memcpy(static_cast<char*>(this->Mapped) + offset, data, bytes);
    return;
  }
  constexpr vk::DeviceSize chunk = vk::DeviceSize(64) << 20;
  Buffer staging(this->Owner, std::min(bytes, chunk), Residence::Upload, "staging");
  for (vk::DeviceSize done = 0; done < bytes; done += chunk)
  {
    const vk::DeviceSize part = std::min(chunk, bytes - done);
    std::memcpy(staging.mapped(), static_cast<const char*>(data) + done, part);
    this->Owner->submit(
      [&](const vk::raii::CommandBuffer& commands) {
        commands.copyBuffer(
          *staging.handle(), *this->Handle, vk::BufferCopy(0, offset + done, part));
      });
  }
}
}
}
