// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/CellShadows.h"

#include "Core/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

namespace exabricks
{
namespace vulkan
{
namespace
{
// Of the steps of pictures, up to one of a cell: in fog of noise they take a quarter off the time
// and 0.3 dB at most off pictures of 51 to 64 dB.
constexpr double StepsOfPicture = 2.0;

Purpose contents()
{
  Purpose purpose("the shadows of the lights");
  purpose.advice = "Set GlobalIlluminationReach to 0, use fewer lights or levels, or a device with "
                   "more memory";
  purpose.concernsPicture = true; // all the rest can be drawn without
  return purpose;
}

// But for rounding, as each view has found them anew.
bool isAlmost(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::distance(a, b) <= 1e-9 * std::max(glm::length(a), glm::length(b));
}

bool isAlmost(const glm::dmat3& a, const glm::dmat3& b)
{
  return isAlmost(a[0], b[0]) && isAlmost(a[1], b[1]) && isAlmost(a[2], b[2]);
}
}

ShadowCause::ShadowCause(const View& view)
  : Cutaway(view.cutaway)
  , Reconstruction(view.quality.reconstruction)
  , HalfCellsToData(view.camera.halfCellsToData)
  , OpacityUnitDistance(view.opacityUnitDistance)
  , StepScale(StepsOfPicture * std::min(view.quality.stepScale, 1.0))
  , SampleDistance(view.quality.sampleDistance)
  , Reach(view.lighting->scattering->reach)
  , UndefinedColor(view.undefinedColor)
  , Lights(view.lighting->lights)
  , DataToWorld(view.lighting->dataToWorld)
{
}

bool ShadowCause::isOfSameMedium(const ShadowCause& other) const
{
  return this->Cutaway == other.Cutaway && this->Reconstruction == other.Reconstruction &&
    isAlmost(this->HalfCellsToData, other.HalfCellsToData) &&
    this->OpacityUnitDistance == other.OpacityUnitDistance && this->StepScale == other.StepScale &&
    this->SampleDistance == other.SampleDistance && this->Reach == other.Reach &&
    this->UndefinedColor == other.UndefinedColor && this->Lights.size() == other.Lights.size();
}

bool ShadowCause::operator==(const ShadowCause& other) const
{
  const auto isSame = [](const Light& a, const Light& b)
  {
    return a.positional == b.positional &&
      (a.positional ? isAlmost(a.position, b.position) : isAlmost(a.direction, b.direction));
  };
  return this->isOfSameMedium(other) && isAlmost(this->DataToWorld, other.DataToWorld) &&
    std::equal(this->Lights.begin(), this->Lights.end(), other.Lights.begin(), isSame);
}

View ShadowCause::steady(View view) const
{
  view.lighting->lights = this->Lights;
  view.lighting->dataToWorld = this->DataToWorld;
  view.quality.stepScale = this->StepScale;
  view.quality.sampleDistance = this->SampleDistance;
  view.quality.jittered = false;
  view.quality.terminationOpacity = 0.999;
  return view;
}

CellShadows::CellShadows(std::shared_ptr<Device> device, const DeviceVolume& onDevice,
  const Volume& volume, const ActiveRegions& active, std::size_t lights)
  : Owner(std::move(device))
  , Counters(this->Owner, 1)
  , Lights(static_cast<std::uint32_t>(std::min<std::size_t>(lights, layout::MOST_LIGHTS)))
  , Bricks(static_cast<std::uint32_t>(volume.structure->bricks.size()))
{
  std::vector<vk::DeviceAddress> addresses;
  for (std::size_t light = 0; light < this->Lights; light += volume.components())
  {
    const std::vector<vk::DeviceAddress> more =
      onDevice.makeAlike(volume, contents(), this->Shares);
    addresses.insert(addresses.end(), more.begin(), more.end());
  }
  this->Addresses = makeBuffer(this->Owner, addresses, contents());
  this->Constants.reserve(this->Owner, sizeof(layout::Frame), "the frame's constants");
  this->MakeList(volume, active);
}

// The bricks of regions in which nothing shows are never asked for theirs.
void CellShadows::MakeList(const Volume& volume, const ActiveRegions& active)
{
  const RegionTree& tree = volume.structure->tree;
  std::vector<bool> isLast(tree.brickLists.size());
  for (const layout::Region& region : tree.regions)
  {
    if (region.brickCount > 0)
    {
      isLast[region.firstBrick + region.brickCount - 1] = true;
    }
  }
  std::vector<bool> isListed(this->Bricks);
  for (const layout::KdNode& node : active.nodes)
  {
    const std::uint32_t first = node.link >> 2;
    if ((node.link & 3u) != layout::KD_LEAF || first == layout::KD_NO_REGION)
    {
      continue;
    }
    std::size_t i = first;
    isListed[tree.brickLists[i]] = true;
    while (!isLast[i])
    {
      isListed[tree.brickLists[++i]] = true;
    }
  }
  const std::vector<std::uint64_t>& firstValue = volume.values->firstValue;
  std::vector<layout::ShadowedBrick> list;
  std::uint64_t cells = 0;
  for (std::uint32_t brick = 0; brick < this->Bricks; ++brick)
  {
    if (isListed[brick])
    {
      list.push_back({ brick, static_cast<std::uint32_t>(cells) });
      cells += firstValue[brick + 1] - firstValue[brick];
    }
  }
  if (cells > std::numeric_limits<std::uint32_t>::max())
  {
    throw PictureFailure(
      "expected at most 4 294 967 295 cells that show anything to find shadows in, "
      "found " +
      std::to_string(cells) + ". Use fewer levels, or set GlobalIlluminationReach to 0");
  }
  this->List = makeBuffer(this->Owner, list, contents());
  this->ListedBricks = static_cast<std::uint32_t>(list.size());
  this->Cells = static_cast<std::uint32_t>(cells);
}

bool CellShadows::find(const ShadowCause& cause, const layout::Frame& frame, const MarchPass& pass,
  const std::function<bool()>& goOn)
{
  this->Found.reset();
  if (this->Filled && !this->Filled->isOfSameMedium(cause))
  {
    this->Filled.reset();
  }
  std::memcpy(this->Constants.data(), &frame, sizeof(frame));
  for (std::uint32_t light = 0; light < this->Lights; ++light)
  {
    for (std::uint32_t next = 0; next < this->Cells;)
    {
      const bool first = light == 0 && next == 0;
      layout::Band band{};
      band.frame = this->Constants.address();
      band.counter = this->Counters.address(0);
      band.firstRow = next;
      band.count = std::min(this->Cells - next,
        static_cast<std::uint32_t>(std::clamp<double>(this->CellPace.wanted(), 64.0, 1e9)));
      band.light = light;
      const Stopwatch watch;
      this->Owner->submit(
        [&](const vk::raii::CommandBuffer& commands)
        {
          if (first)
          {
            this->Constants.record(commands, sizeof(layout::Frame));
          }
          if (pass.takesPixels)
          {
            this->Counters.record(commands);
          }
          pass.recordList(commands, band);
        });
      this->CellPace.took(watch.seconds(), band.count);
      next += band.count;
      if (!goOn())
      {
        return false;
      }
    }
  }
  this->Found = this->Filled = cause;
  return true;
}

vk::DeviceSize CellShadows::bytes() const
{
  vk::DeviceSize bytes = this->Addresses.bytes() + this->List.bytes();
  for (const Buffer& shares : this->Shares)
  {
    bytes += shares.bytes();
  }
  return bytes;
}

void CellShadows::fill(layout::Frame& frame) const
{
  frame.shares = this->Addresses.address();
  frame.brickCount = this->Bricks;
  frame.shadowedBricks = this->List.address();
  frame.shadowedBrickCount = this->ListedBricks;
}
}
}
