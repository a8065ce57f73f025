// SPDX-License-Identifier: BSD-3-Clause
// A volume on the device: its bricks and values, and what the transfer function shows of it.
#ifndef ExaBricksVulkanDeviceVolume_h
#define ExaBricksVulkanDeviceVolume_h

#include "Core/ActiveRegions.h"
#include "Vulkan/AccelerationStructure.h"

namespace exabricks
{
namespace vulkan
{
class DeviceVolume
{
public:
  /// Uploads bricks, their lists and values. Throws Failure.
  DeviceVolume(std::shared_ptr<Device> device, const Volume& volume);

  /// Uploads what a traversal walks: the boxes, or without any the k-d tree. Throws Failure.
  void setActive(ActiveRegions active);

  std::size_t activeRegions() const { return this->Regions; }
  std::size_t activeBoxes() const { return this->BoxCount; }
  vk::DeviceSize bytes() const;
  /// All that concerns the volume.
  void fill(layout::Frame& frame) const;

private:
  void UploadValues(const Volume& volume);
  void UploadLists(const RegionTree& tree);

  std::shared_ptr<Device> Owner;
  glm::ivec3 Size; // half cells
  std::vector<Buffer> Values;
  Buffer Bricks;
  Buffer BrickLists;
  Buffer Nodes;
  Buffer Boxes;
  AccelerationStructure Scene;
  std::size_t Regions = 0;
  std::size_t BoxCount = 0;
};
}
}

#endif
