// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/Exchange.h"

namespace exabricks
{
namespace vulkan
{
namespace
{
using Access = vk::AccessFlagBits;
using Stage = vk::PipelineStageFlagBits;

// `onHost`: of the host alone; none, where it shares all memory with the device.
void provide(const std::shared_ptr<Device>& device, vk::DeviceSize bytes, const Purpose& purpose,
  Residence residence, Buffer& onDevice, Buffer& onHost)
{
  if (onDevice.bytes() >= bytes)
  {
    return;
  }
  onDevice = Buffer(); // frees the old ones first
  onHost = Buffer();
  if (device->sharesMemory())
  {
    onDevice = Buffer(device, bytes, Residence::Shared, purpose);
    return;
  }
  onHost = Buffer(device, bytes, residence, purpose);
  onDevice = Buffer(device, bytes, Residence::Device, purpose);
}

void copy(const vk::raii::CommandBuffer& commands, const Buffer& from, const Buffer& to,
  vk::DeviceSize bytes)
{
  commands.copyBuffer(*from.handle(), *to.handle(), vk::BufferCopy(0, 0, bytes));
}
}

void Input::reserve(
  const std::shared_ptr<Device>& device, vk::DeviceSize bytes, const Purpose& purpose)
{
  provide(device, bytes, purpose, Residence::Staging, this->OnDevice, this->Staged);
}

void* Input::data() const
{
  return this->Staged.bytes() > 0 ? this->Staged.mapped() : this->OnDevice.mapped();
}

void Input::record(const vk::raii::CommandBuffer& commands, vk::DeviceSize bytes) const
{
  if (this->Staged.bytes() > 0)
  {
    copy(commands, this->Staged, this->OnDevice, bytes);
    const vk::MemoryBarrier barrier(Access::eTransferWrite, Access::eShaderRead);
    commands.pipelineBarrier(Stage::eTransfer, Stage::eComputeShader, {}, barrier, {}, {});
  }
}

void Output::reserve(
  const std::shared_ptr<Device>& device, vk::DeviceSize bytes, const Purpose& purpose)
{
  provide(device, bytes, purpose, Residence::Readback, this->OnDevice, this->ReadBack);
}

void Output::record(const vk::raii::CommandBuffer& commands, vk::DeviceSize bytes) const
{
  const bool copied = this->ReadBack.bytes() > 0;
  if (copied)
  {
    const vk::MemoryBarrier toCopy(Access::eShaderWrite, Access::eTransferRead);
    commands.pipelineBarrier(Stage::eComputeShader, Stage::eTransfer, {}, toCopy, {}, {});
    copy(commands, this->OnDevice, this->ReadBack, bytes);
  }
  const vk::MemoryBarrier toHost(
    copied ? Access::eTransferWrite : Access::eShaderWrite, Access::eHostRead);
  commands.pipelineBarrier(
    copied ? Stage::eTransfer : Stage::eComputeShader, Stage::eHost, {}, toHost, {}, {});
}

const void* Output::data() const
{
  return this->ReadBack.bytes() > 0 ? this->ReadBack.mapped() : this->OnDevice.mapped();
}
}
}
