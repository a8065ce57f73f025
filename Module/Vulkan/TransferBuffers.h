// SPDX-License-Identifier: BSD-3-Clause
// The transfer functions on the device: of a value, or of several components.
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
    : TransferBuffers(device, std::vector{ table })
  {
    if (!gradientOpacity.empty())
    {
      this->GradientOpacity = makeBuffer(device, gradientOpacity, "opacity by gradients");
    }
  }

  /// `tables`: at most layout::MOST_COMPONENTS, one after the other. Throws Failure.
  TransferBuffers(const std::shared_ptr<Device>& device, const std::vector<TransferTable>& tables)
  {
    std::vector<layout::TransferBin> bins;
    std::vector<layout::TransferKnot> knots;
    for (std::size_t i = 0; i < tables.size(); ++i)
    {
      for (layout::TransferBin bin : tables[i].bins)
      {
        if (bin.lower.a < 0.0f)
        {
          bin.integral.x += static_cast<int>(knots.size()); // its first knot
        }
        bins.push_back(bin);
      }
      knots.insert(knots.end(), tables[i].knots.begin(), tables[i].knots.end());
      this->IntegralUnits[static_cast<glm::length_t>(i)] = tables[i].integralUnit;
    }
    this->Bins = makeBuffer(device, bins, "the transfer function");
    this->Knots = makeBuffer(device, knots, "the transfer function");
  }

  vk::DeviceSize bytes() const
  {
    return this->Bins.bytes() + this->Knots.bytes() + this->GradientOpacity.bytes();
  }
  /// All that concerns the transfer functions.
  void fill(layout::Frame& frame) const
  {
    frame.transferBins = this->Bins.address();
    frame.transferKnots = this->Knots.address();
    frame.integralUnit = this->IntegralUnits[0];
    frame.integralUnits = this->IntegralUnits;
    frame.gradientOpacity = this->GradientOpacity.address();
  }

private:
  Buffer Bins;
  Buffer Knots;
  Buffer GradientOpacity;
  glm::vec4 IntegralUnits{ 1.0f };
};
}
}

#endif
