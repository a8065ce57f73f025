// SPDX-License-Identifier: BSD-3-Clause
// Which levels and steps a picture takes to err by a tolerance, measured on few of its pixels.
#ifndef ExaBricksVulkanSamplingChoice_h
#define ExaBricksVulkanSamplingChoice_h

#include "Core/KnownSampling.h"
#include "Vulkan/DeviceSparsePictures.h"

#include <array>

namespace exabricks
{
namespace vulkan
{
class SamplingChoice
{
public:
  explicit SamplingChoice(std::shared_ptr<Device> device);

  /// As DeviceSparsePictures::MakeFrame, for a view with few pixels.
  using MakeFrame = std::function<std::optional<layout::Frame>(const View&, const Sampling&)>;
  /// For the view's error tolerance, or that of the whole that it is a part of. More pixels are
  /// drawn where few of them show anything; where still few do, they get steps that suit all.
  Sampling find(const View& view, const MarchPass& pass, const MakeFrame& makeFrame);
  /// Volume or transfer function have changed.
  void forget() { this->Known = {}; }
  /// Of the last find(); 0, where the choice was known.
  double seconds() const { return this->Seconds; }

private:
  std::optional<Sampling> FindFrom(
    const View& view, double pixels, const MarchPass& pass, const MakeFrame& makeFrame);

  DeviceSparsePictures Pictures;
  // Of the last whole picture, and of the last one of which parts were drawn: what is picked in a
  // picture does not make it be searched anew.
  std::array<KnownSampling, 2> Known;
  double Seconds = 0.0;
};
}
}

#endif
