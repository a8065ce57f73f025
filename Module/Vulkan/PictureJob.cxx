// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/PictureJob.h"

#include "Core/Stopwatch.h"

#include <algorithm>
#include <cstring>

namespace exabricks
{
namespace vulkan
{
namespace
{
// Rows may cost more than those before: from one piece to the next they grow by no more.
constexpr double GreatestGrowth = 4.0;
}

PictureJob::PictureJob(std::shared_ptr<Device> device)
  : Owner(std::move(device))
  , Counters(this->Owner, 1)
{
  this->Constants.reserve(this->Owner, sizeof(layout::Frame), "the frame's constants");
}

void PictureJob::begin(const layout::Frame& frame, const Target& target, const MarchPass& pass)
{
  this->Pass = pass;
  this->Width = static_cast<std::uint32_t>(target.width);
  this->Height = static_cast<std::uint32_t>(target.height);
  this->NextRow = 0;
  const vk::DeviceSize pixels = vk::DeviceSize(this->Width) * this->Height;
  this->Picture.reserve(this->Owner, pixels * sizeof(glm::vec4),
    Purpose::ofPicture("the picture", target.width, target.height));
  const auto put = [&](Input& input, const float* depth)
  {
    if (depth)
    {
      input.reserve(this->Owner, pixels * sizeof(float),
        Purpose::ofPicture("the depth buffer", target.width, target.height));
      std::memcpy(input.data(), depth, pixels * sizeof(float));
    }
    return depth != nullptr;
  };
  this->HasDepth = put(this->Depth, target.depth);
  this->HasNearDepth = put(this->NearDepth, target.nearDepth);
  layout::Frame constants = frame;
  constants.depth = this->HasDepth ? this->Depth.address() : 0;
  constants.nearDepth = this->HasNearDepth ? this->NearDepth.address() : 0;
  constants.picture = this->Picture.address();
  std::memcpy(this->Constants.data(), &constants, sizeof(constants));
}

bool PictureJob::march()
{
  if (this->NextRow >= this->Height)
  {
    return false;
  }
  const double wanted = PieceSeconds * this->PixelsPerSecond / (this->Width * TileSize);
  const std::uint32_t tileRows = (this->Height - this->NextRow + TileSize - 1) / TileSize;
  const std::uint32_t rows = std::min(this->Height - this->NextRow,
    TileSize * static_cast<std::uint32_t>(std::clamp<double>(wanted, 1.0, tileRows)));
  const bool first = this->NextRow == 0;
  const bool last = this->NextRow + rows == this->Height;
  layout::Band band{};
  band.frame = this->Constants.address();
  band.counter = this->Counters.address(0);
  band.firstRow = this->NextRow;

  const Stopwatch watch;
  this->Owner->submit(
    [&](const vk::raii::CommandBuffer& commands)
    {
      const vk::DeviceSize pixels = vk::DeviceSize(this->Width) * this->Height;
      if (first)
      {
        this->Constants.record(commands, sizeof(layout::Frame));
        if (this->HasDepth)
        {
          this->Depth.record(commands, pixels * sizeof(float));
        }
        if (this->HasNearDepth)
        {
          this->NearDepth.record(commands, pixels * sizeof(float));
        }
      }
      if (this->Pass.takesPixels)
      {
        this->Counters.record(commands);
      }
      this->Pass.record(commands, band, this->Width, rows);
      if (last)
      {
        this->Picture.record(commands, pixels * sizeof(glm::vec4));
      }
    });
  const double rate = static_cast<double>(this->Width) * rows / std::max(watch.seconds(), 1e-6);
  this->PixelsPerSecond = std::min(rate, GreatestGrowth * this->PixelsPerSecond);
  this->NextRow += rows;
  return true;
}

double PictureJob::progress() const
{
  return this->Height > 0 ? static_cast<double>(this->NextRow) / this->Height : 1.0;
}

const glm::vec4* PictureJob::pixels() const
{
  return static_cast<const glm::vec4*>(this->Picture.data());
}
}
}
