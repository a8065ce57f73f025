// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/Buffer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

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

bool lacksMemory(const vk::SystemError& error)
{
  const auto code = static_cast<vk::Result>(error.code().value());
  return code == vk::Result::eErrorOutOfDeviceMemory || code == vk::Result::eErrorOutOfHostMemory ||
    code == vk::Result::eErrorMemoryMapFailed;
}
}

Purpose Purpose::ofPicture(const char* what, int width, int height)
{
  Purpose purpose(what);
  purpose.advice = "The window of " + std::to_string(width) + " x " + std::to_string(height) +
    " pixels is too large for the device in one piece: make it smaller, or draw it in tiles "
    "(vtkWindowToImageFilter::SetScale(), as ParaView's screenshots do)";
  purpose.concernsPicture = true;
  return purpose;
}

Buffer::Buffer(std::shared_ptr<Device> device, vk::DeviceSize bytes, Residence residence,
  const Purpose& purpose, vk::BufferUsageFlags usage)
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
      // Where all memory is shared, nothing needs staging; elsewhere, what the host can see of the
      // device's memory may be small.
      (this->Owner->sharesMemory() ? preferred : avoided) = hostWrites;
      break;
    case Residence::Staging:
      required = hostWrites;
      avoided = Flag::eDeviceLocal;
      break;
    case Residence::Shared:
      required = hostWrites;
      preferred = Flag::eDeviceLocal | Flag::eHostCached;
      break;
    case Residence::Readback:
      required = hostWrites;
      preferred = Flag::eHostCached;
      avoided = Flag::eDeviceLocal;
      break;
  }
  const auto fail = [&](const std::string& why)
  {
    const std::string text = why + ". " + purpose.advice;
    if (purpose.concernsPicture)
    {
      throw PictureFailure(text);
    }
    throw Failure(text);
  };
  if (bytes > this->Owner->maximumAllocation())
  {
    fail(purpose.contents + " needs " + megabytes(bytes) + " in one piece, " + this->Owner->name() +
      " allows " + megabytes(this->Owner->maximumAllocation()));
  }
  // What is available is not known before there is a buffer, as heaps differ.
  vk::DeviceSize needed = bytes;
  std::optional<vk::DeviceSize> available;
  const auto refuse = [&]
  {
    fail("out of device memory: " + purpose.contents + " needs " + megabytes(needed) + ", " +
      this->Owner->name() +
      (available ? " has " + megabytes(*available) + " available" : " refuses to make it"));
  };
  try
  {
    this->Handle = vk::raii::Buffer(this->Owner->handle(),
      vk::BufferCreateInfo({}, bytes,
        usage | vk::BufferUsageFlagBits::eShaderDeviceAddress |
          vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst |
          vk::BufferUsageFlagBits::eTransferSrc));
    const vk::MemoryRequirements needs = this->Handle.getMemoryRequirements();
    const std::uint32_t type =
      this->Owner->findMemoryType(needs.memoryTypeBits, required, preferred, avoided);
    needed = needs.size;
    available = this->Owner->availableMemory(type);
    if (needed > *available)
    {
      refuse();
    }
    const vk::MemoryAllocateFlagsInfo allocateFlags(vk::MemoryAllocateFlagBits::eDeviceAddress);
    this->Memory = vk::raii::DeviceMemory(
      this->Owner->handle(), vk::MemoryAllocateInfo(needed, type, &allocateFlags));
    this->Handle.bindMemory(*this->Memory, 0);
    this->Address = this->Owner->handle().getBufferAddress({ *this->Handle });
    const vk::MemoryPropertyFlags flags = this->Owner->memoryFlags(type);
    if ((flags & hostWrites) == hostWrites &&
      (residence != Residence::Device || this->Owner->sharesMemory()))
    {
      this->Mapped = this->Map();
      if (!this->Mapped)
      {
        refuse();
      }
    }
  }
  catch (const vk::SystemError& error)
  {
    if (!lacksMemory(error))
    {
      throw;
    }
    refuse();
  }
}

void* Buffer::Map() const
{
  void* const mapped = this->Memory.mapMemory(0, VK_WHOLE_SIZE);
  // Where a mapping fails, Mesa's CPU driver answers with success and what mmap() returns.
  return mapped == reinterpret_cast<void*>(~std::uintptr_t(0)) ? nullptr : mapped;
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
  constexpr vk::DeviceSize chunk = vk::DeviceSize(16) << 20;
  struct Stage
  {
    Buffer memory;
    Submission copying; // which ends before the memory does
  };
  std::array<Stage, 2> stages;
  std::size_t turn = 0;
  for (vk::DeviceSize done = 0; done < bytes; done += chunk, turn = 1 - turn)
  {
    Stage& stage = stages[turn];
    const vk::DeviceSize part = std::min(chunk, bytes - done);
    if (stage.memory.bytes() == 0)
    {
      stage.memory = Buffer(this->Owner, part, Residence::Staging, "staging");
    }
    stage.copying.wait();
    std::memcpy(stage.memory.mapped(), static_cast<const char*>(data) + done, part);
    stage.copying = this->Owner->start(
      [&](const vk::raii::CommandBuffer& commands)
      {
        commands.copyBuffer(
          *stage.memory.handle(), *this->Handle, vk::BufferCopy(0, offset + done, part));
      });
  }
  for (Stage& stage : stages)
  {
    stage.copying.wait();
  }
}

void Buffer::clear(const vk::raii::CommandBuffer& commands) const
{
  using Access = vk::AccessFlagBits;
  using Stage = vk::PipelineStageFlagBits;
  commands.fillBuffer(*this->Handle, 0, VK_WHOLE_SIZE, 0);
  const vk::MemoryBarrier barrier(
    Access::eTransferWrite, Access::eShaderRead | Access::eShaderWrite);
  commands.pipelineBarrier(Stage::eTransfer, Stage::eComputeShader, {}, barrier, {}, {});
}
}
}
