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
  /// `gradientOpacity`: of layout::GRADIENT_OPACITIES gradients, or empty. Throws Failure.
  TransferBuffers(const std::shared_ptr<Device>& device, const TransferTable& table,
    const std::vector<float>& gradientOpacity = {})
  {
    if (!gradientOpacity.empty())
    {
      this->GradientOpacity = makeBuffer(device, gradientOpacity, "opacity by gradients");
    }
    this->Bins = makeBuffer(device, table.bins, "the transfer function");
    this->Knots = makeBuffer(device, table.knots, "the transfer function");
    this->IntegralUnit = table.integralUnit;
  }

  vk::DeviceSize bytes() const
  {
    return this->Bins.bytes() + this->Knots.bytes() + this->GradientOpacity.bytes();
  }
  /// All that concerns the transfer function.
  void fill(layout::Frame& frame) const
  {
    frame.transferBins = this->Bins.address();
    frame.transferKnots = this->Knots.address();
    frame.integralUnit = this->IntegralUnit;
    frame.gradientOpacity = this->GradientOpacity.address();
  }

private:
  Buffer Bins;
  Buffer Knots;
  Buffer GradientOpacity;
  float IntegralUnit = 1.0f;
};
}
}

#endif
