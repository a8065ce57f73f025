// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/DeviceVolume.h"

#include <algorithm>

namespace exabricks
{
namespace vulkan
{
DeviceVolume::DeviceVolume(std::shared_ptr<Device> device, const Volume& volume)
  : Owner(std::move(device))
  , Size(volume.structure->tree.size)
  , PartLower(volume.structure->shown().lo)
  , PartUpper(volume.structure->shown().hi)
{
  this->UploadLists(volume.structure->tree);
  this->MakeValueBuffers(volume);
  this->setValues(volume);
}

void DeviceVolume::MakeValueBuffers(const Volume& volume)
{
  const std::vector<std::uint64_t>& firstValue = volume.values->firstValue;
  const std::size_t bricks = firstValue.size() - 1;
  const vk::DeviceSize largest = this->Owner->maximumValueBuffer();
  const vk::DeviceSize cell = volume.components() * sizeof(float);
  this->Values.clear();
  this->Layer = volume.values->layer;
  for (std::size_t first = 0; first < bricks;)
  {
    std::size_t last = first + 1;
    while (last < bricks && (firstValue[last + 1] - firstValue[first]) * cell <= largest)
    {
      ++last;
    }
    this->Values.push_back({ first, last,
      Buffer(this->Owner, (firstValue[last] - firstValue[first]) * cell, Residence::Device,
        "the cells' values") });
    first = last;
  }
  this->Bricks = {};
}

void DeviceVolume::setValues(const Volume& volume)
{
  const exabricks::Values& values = *volume.values;
  if (values.layer != this->Layer)
  {
    this->MakeValueBuffers(volume);
  }
  for (ValueBuffer& buffer : this->Values)
  {
    this->UploadValues(volume, buffer);
  }
  if (this->Bricks.bytes() == 0 || values.brickHasAbsentCells != this->BrickHasAbsentCells)
  {
    this->UploadBricks(volume);
  }
}

void DeviceVolume::UploadValues(const Volume& volume, ValueBuffer& buffer)
{
  if (volume.components() == 1)
  {
    buffer.values.upload(volume.values->ofBrick(buffer.firstBrick), buffer.values.bytes());
    return;
  }
  // The components of a cell lie side by side, some million cells at a time.
  constexpr std::uint64_t most = 1 << 20;
  const std::size_t components = volume.components();
  const std::uint64_t begin = volume.values->firstValue[buffer.firstBrick];
  const std::uint64_t end = volume.values->firstValue[buffer.lastBrick];
  std::vector<float> mixed;
  for (std::uint64_t first = begin; first < end; first += most)
  {
    const std::uint64_t count = std::min(most, end - first);
    mixed.resize(count * components);
    for (std::size_t k = 0; k < components; ++k)
    {
      const float* const values = volume.valuesOf(k)->normalized.data() + first;
      for (std::uint64_t i = 0; i < count; ++i)
      {
        mixed[i * components + k] = values[i];
      }
    }
    buffer.values.upload(
      mixed.data(), mixed.size() * sizeof(float), (first - begin) * components * sizeof(float));
  }
}

void DeviceVolume::UploadBricks(const Volume& volume)
{
  const Structure& structure = *volume.structure;
  const std::vector<std::uint64_t>& firstValue = volume.values->firstValue;
  std::vector<layout::Brick> records;
  records.reserve(structure.bricks.size());
  for (const ValueBuffer& buffer : this->Values)
  {
    for (std::size_t i = buffer.firstBrick; i < buffer.lastBrick; ++i)
    {
      const Brick& brick = structure.bricks[i];
      const glm::uvec3 n(brick.cells);
      layout::Brick record{};
      record.lo = glm::ivec3((brick.lo - structure.tree.bounds.lo) * std::int64_t(2));
      record.width = static_cast<int>(structure.width(brick));
      record.dimensions = n.x | n.y << 8 | n.z << 16 |
        (volume.values->brickHasAbsentCells[i] ? layout::BRICK_HAS_ABSENT_CELLS : 0u);
      record.number = static_cast<std::uint32_t>(i);
      record.values = buffer.values.address() +
        (firstValue[i] - firstValue[buffer.firstBrick]) * volume.components() * sizeof(float);
      records.push_back(record);
    }
  }
  this->Bricks = makeBuffer(this->Owner, records, "the bricks");
  this->BrickHasAbsentCells = volume.values->brickHasAbsentCells;
}

std::vector<vk::DeviceAddress> DeviceVolume::makeAlike(
  const Volume& volume, const Purpose& purpose, std::vector<Buffer>& buffers) const
{
  const std::vector<std::uint64_t>& firstValue = volume.values->firstValue;
  std::vector<vk::DeviceAddress> addresses;
  addresses.reserve(volume.structure->bricks.size());
  for (const ValueBuffer& buffer : this->Values)
  {
    buffers.emplace_back(this->Owner, buffer.values.bytes(), Residence::Device, purpose);
    for (std::size_t i = buffer.firstBrick; i < buffer.lastBrick; ++i)
    {
      addresses.push_back(buffers.back().address() +
        (firstValue[i] - firstValue[buffer.firstBrick]) * volume.components() * sizeof(float));
    }
  }
  return addresses;
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
  this->Extremes = {};
  this->Scene = {};
  this->Regions = active.regions;
  this->BoxCount = active.boxCount;
  if (active.boxes.empty())
  {
    this->Nodes = makeBuffer(this->Owner, active.nodes, "the k-d tree");
    this->UploadExtremes(active.nodeExtremes);
    return;
  }
  sortByMedianSplits(active);
  this->UploadExtremes(active.boxExtremes);
  this->Boxes = makeBuffer(this->Owner, active.boxes, "the active regions");
  this->Scene = AccelerationStructure(this->Owner, this->Size, active.boxes);
}

void DeviceVolume::UploadExtremes(const std::vector<float>& extremes)
{
  if (!extremes.empty())
  {
    this->Extremes = makeBuffer(this->Owner, extremes, "the regions' extremes");
  }
}

vk::DeviceSize DeviceVolume::bytes() const
{
  vk::DeviceSize bytes = this->Bricks.bytes() + this->BrickLists.bytes() + this->Nodes.bytes() +
    this->Boxes.bytes() + this->Extremes.bytes() + this->Scene.bytes();
  for (const ValueBuffer& buffer : this->Values)
  {
    bytes += buffer.values.bytes();
  }
  return bytes;
}

void DeviceVolume::fill(layout::Frame& frame) const
{
  frame.size = this->Size;
  frame.partLower = this->PartLower;
  frame.partUpper = this->PartUpper;
  frame.bricks = this->Bricks.address();
  frame.brickLists = this->BrickLists.address();
  frame.nodes = this->Nodes.address();
  frame.activeBoxes = this->Boxes.address();
  frame.extremes = this->Extremes.address();
  frame.scene = this->Scene.address();
}
}
}
