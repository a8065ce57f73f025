// SPDX-License-Identifier: BSD-3-Clause
// The transfer function on the device.
#ifndef ExaBricksVulkanTransferBuffers_h
#define ExaBricksVulkanTransferBuffers_h

#include "Core/TransferTable.h"
#include "Vulkan/Buffer.h"

namespace exabricks
{
namespace vulkan
{
class TransferBuffers
{
public:
  TransferBuffers() = default;
  /// Throws Failure.
  TransferBuffers(const std::shared_ptr<Device>& device, const TransferTable& table)
  {
    this->Bins = makeBuffer(device, table.bins, "the transfer function");
    this->Knots = makeBuffer(device, table.knots, "the transfer function");
    this->IntegralUnit = table.integralUnit;
  }

  vk::DeviceSize bytes() const { return this->Bins.bytes() + this->Knots.bytes(); }
  /// All that concerns the transfer function.
  void fill(layout::Frame& frame) const
  {
    frame.transferBins = this->Bins.address();
    frame.transferKnots = this->Knots.address();
    frame.integralUnit = this->IntegralUnit;
  }

private:
  Buffer Bins;
  Buffer Knots;
  float IntegralUnit = 1.0f;
};
}
}

#endif
