// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/DeviceVolume.h"

#include "Vulkan/Faults.h"

namespace exabricks
{
namespace vulkan
{
namespace
{
// Values fill several buffers, none longer than a device allows, each of whole bricks.
constexpr vk::DeviceSize LargestValueBuffer = vk::DeviceSize(1) << 30;
}

DeviceVolume::DeviceVolume(std::shared_ptr<Device> device, const Volume& volume)
  : Owner(std::move(device))
  , Size(volume.structure->tree.size)
{
  this->UploadValues(volume);
  this->UploadLists(volume.structure->tree);
}

void DeviceVolume::UploadValues(const Volume& volume)
{
  const Structure& structure = *volume.structure;
  const std::vector<Brick>& bricks = structure.bricks;
  const std::vector<std::uint64_t>& firstValue = volume.values->firstValue;
  const vk::DeviceSize largest =
    std::min<vk::DeviceSize>(LargestValueBuffer, faults().largestValueBuffer);
  std::vector<layout::Brick> records;
  records.reserve(bricks.size());
  for (std::size_t first = 0; first < bricks.size();)
  {
    const std::uint64_t begin = firstValue[first];
    std::size_t last = first + 1;
    while (last < bricks.size() && (firstValue[last + 1] - begin) * sizeof(float) <= largest)
    {
      ++last;
    }
    const vk::DeviceSize bytes = (firstValue[last] - begin) * sizeof(float);
    this->Values.emplace_back(this->Owner, bytes, Residence::Device, "the cells' values");
    this->Values.back().upload(volume.values->normalized.data() + begin, bytes);
    for (; first < last; ++first)
    {
      const Brick& brick = bricks[first];
      const glm::uvec3 n(brick.cells);
      layout::Brick record{};
      record.lo = glm::ivec3((brick.lo - structure.tree.bounds.lo) * std::int64_t(2));
      record.width = static_cast<int>(structure.width(brick));
      record.dimensions = n.x | n.y << 8 | n.z << 16 |
        (volume.values->brickHasAbsentCells[first] ? layout::BRICK_HAS_ABSENT_CELLS : 0u);
      record.values = this->Values.back().address() + (firstValue[first] - begin) * sizeof(float);
      records.push_back(record);
    }
  }
  this->Bricks = makeBuffer(this->Owner, records, "the bricks");
}

void DeviceVolume::UploadLists(const RegionTree& tree)
{
  std::vector<std::uint32_t> lists = tree.brickLists;
  for (const layout::Region& region : tree.regions)
  {
    if (region.brickCount > 0)
    {
      lists[region.firstBrick + region.brickCount - 1] |= layout::LAST_BRICK;
    }
  }
  this->BrickLists = makeBuffer(this->Owner, lists, "the brick lists");
}

void DeviceVolume::setActive(ActiveRegions active)
{
  this->Nodes = {};
  this->Boxes = {};
  this->Scene = {};
  this->Regions = active.regions;
  this->BoxCount = active.boxCount;
  if (active.boxes.empty())
  {
    this->Nodes = makeBuffer(this->Owner, active.nodes, "the k-d tree");
    return;
  }
  sortByMedianSplits(active.boxes);
  this->Boxes = makeBuffer(this->Owner, active.boxes, "the active regions");
  this->Scene = AccelerationStructure(this->Owner, this->Size, active.boxes);
}

vk::DeviceSize DeviceVolume::bytes() const
{
  vk::DeviceSize bytes = this->Bricks.bytes() + this->BrickLists.bytes() + this->Nodes.bytes() +
    this->Boxes.bytes() + this->Scene.bytes();
  for (const Buffer& values : this->Values)
  {
    bytes += values.bytes();
  }
  return bytes;
}

void DeviceVolume::fill(layout::Frame& frame) const
{
  frame.size = this->Size;
  frame.bricks = this->Bricks.address();
  frame.brickLists = this->BrickLists.address();
  frame.nodes = this->Nodes.address();
  frame.activeBoxes = this->Boxes.address();
  frame.scene = this->Scene.address();
}
}
}
