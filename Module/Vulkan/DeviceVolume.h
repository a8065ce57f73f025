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
  /// Uploads brick lists, values and bricks. Throws Failure.
  DeviceVolume(std::shared_ptr<Device> device, const Volume& volume);

  /// Uploads the values of the same structure and number of components: in place, where they have
  /// the same layer, and the bricks with them only where other bricks have absent cells. Throws
  /// Failure.
  void setValues(const Volume& volume);

  /// Uploads what a traversal walks: the boxes, or without any the k-d tree. Throws Failure.
  void setActive(ActiveRegions active);

  /// Room for as many more values, which lie as those of the volume do, in `buffers`; returns where
  /// those of each brick begin. Throws Failure.
  std::vector<vk::DeviceAddress> makeAlike(
    const Volume& volume, const Purpose& purpose, std::vector<Buffer>& buffers) const;

  std::size_t activeRegions() const { return this->Regions; }
  std::size_t activeBoxes() const { return this->BoxCount; }
  vk::DeviceSize bytes() const;
  /// All that concerns the volume.
  void fill(layout::Frame& frame) const;

private:
  // Values fill several buffers, none longer than a device allows, each of whole bricks.
  struct ValueBuffer
  {
    std::size_t firstBrick;
    std::size_t lastBrick; // behind them
    Buffer values;
  };

  void MakeValueBuffers(const Volume& volume);
  void UploadValues(const Volume& volume, ValueBuffer& buffer);
  void UploadBricks(const Volume& volume);
  void UploadLists(const RegionTree& tree);
  void UploadExtremes(const std::vector<float>& extremes);

  std::shared_ptr<Device> Owner;
  glm::ivec3 Size;      // half cells
  glm::ivec3 PartLower; // what is drawn of it
  glm::ivec3 PartUpper;
  int Layer = 0; // of the values
  std::vector<unsigned char> BrickHasAbsentCells;
  std::vector<ValueBuffer> Values;
  Buffer Bricks;
  Buffer BrickLists;
  Buffer Nodes;
  Buffer Boxes;
  Buffer Extremes; // of nodes or boxes
  AccelerationStructure Scene;
  std::size_t Regions = 0;
  std::size_t BoxCount = 0;
};
}
}

#endif
