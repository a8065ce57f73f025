// SPDX-License-Identifier: BSD-3-Clause
// The transfer functions on the device: of a value, or of several components.
#ifndef ExaBricksVulkanTransferBuffers_h
#define ExaBricksVulkanTransferBuffers_h

#include "Core/TransferFunction2D.h"
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
  /// `tables`: from 1 to layout::MOST_COMPONENTS of them. `gradientOpacity`: of
  /// layout::GRADIENT_OPACITIES gradients, or empty. `planar`: of two variables, or empty. Throws
  /// Failure.
  TransferBuffers(const std::shared_ptr<Device>& device, std::vector<TransferTable> tables,
    const std::vector<float>& gradientOpacity = {}, const TransferFunction2D& planar = {})
    : PlanarSize(planar.width, planar.height)
  {
    TransferTable& all = tables.front(); // one after the other
    this->IntegralUnits[0] = all.integralUnit;
    for (std::size_t i = 1; i < tables.size(); ++i)
    {
      for (layout::TransferBin bin : tables[i].bins)
      {
        if (bin.lower.a < 0.0f)
        {
          bin.integral.x += static_cast<int>(all.knots.size()); // its first knot
        }
        all.bins.push_back(bin);
      }
      all.knots.insert(all.knots.end(), tables[i].knots.begin(), tables[i].knots.end());
      this->IntegralUnits[static_cast<glm::length_t>(i)] = tables[i].integralUnit;
    }
    this->Bins = makeBuffer(device, all.bins, "the transfer function");
    this->Knots = makeBuffer(device, all.knots, "the transfer function");
    if (!gradientOpacity.empty())
    {
      this->GradientOpacity = makeBuffer(device, gradientOpacity, "opacity by gradients");
    }
    if (!planar.empty())
    {
      this->Planar = makeBuffer(device, planar.pixels, "the function of two variables");
    }
  }

  vk::DeviceSize bytes() const
  {
    return this->Bins.bytes() + this->Knots.bytes() + this->GradientOpacity.bytes() +
      this->Planar.bytes();
  }
  /// All that concerns the transfer functions.
  void fill(layout::Frame& frame) const
  {
    frame.transferBins = this->Bins.address();
    frame.transferKnots = this->Knots.address();
    frame.integralUnit = this->IntegralUnits[0];
    frame.integralUnits = this->IntegralUnits;
    frame.gradientOpacity = this->GradientOpacity.address();
    frame.planar = this->Planar.address();
    frame.planarSize = this->PlanarSize;
  }

private:
  Buffer Bins;
  Buffer Knots;
  Buffer GradientOpacity;
  Buffer Planar;
  glm::ivec2 PlanarSize{ 0 };
  glm::vec4 IntegralUnits{ 1.0f };
};
}
}

#endif
