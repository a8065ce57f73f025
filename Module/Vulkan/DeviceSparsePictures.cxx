// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/DeviceSparsePictures.h"

#include "DifferenceSpirv.h"

#include <algorithm>
#include <cstring>

namespace exabricks
{
namespace vulkan
{
namespace
{
constexpr std::uint32_t MostPairs = 4; // that are compared together
constexpr std::uint32_t MostFrames = 2 * MostPairs;
}

DeviceSparsePictures::DeviceSparsePictures(std::shared_ptr<Device> device)
  : Owner(std::move(device))
  , Compare(*this->Owner, { {}, sizeof(DifferenceSpirv), DifferenceSpirv })
  , Counters(this->Owner, MostFrames)
{
  this->Frames.reserve(
    this->Owner, MostFrames * sizeof(layout::Frame), "the constants of sparse pictures");
  this->Differences.reserve(
    this->Owner, MostPairs * sizeof(layout::PictureDifference), "differences of sparse pictures");
}

void DeviceSparsePictures::begin(const Target& target, const MarchPass& pass, MakeFrame makeFrame)
{
  const auto width = static_cast<std::uint32_t>(target.width);
  const auto height = static_cast<std::uint32_t>(target.height);
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  if (width != this->Width || height != this->Height)
  {
    this->Pictures.clear();
  }
  this->Places.clear();
  this->Pass = pass;
  this->MakeFrameOf = std::move(makeFrame);
  this->Width = width;
  this->Height = height;
  this->HasDepth = target.depth != nullptr;
  if (this->HasDepth)
  {
    this->Depth.reserve(this->Owner, pixels * sizeof(float), "the depth of sparse pictures");
    std::memcpy(this->Depth.data(), target.depth, pixels * sizeof(float));
  }
}

DeviceSparsePictures::Place DeviceSparsePictures::FindPlace(
  const Sampling& sampling, std::vector<layout::Frame>& frames)
{
  const auto [at, isNew] = this->Places.try_emplace(sampling);
  if (!isNew)
  {
    return at->second;
  }
  std::optional<layout::Frame> frame = this->MakeFrameOf(sampling);
  if (!frame)
  {
    return std::nullopt;
  }
  const auto drawn = static_cast<std::size_t>(std::count_if(this->Places.begin(),
    this->Places.end(), [](const auto& place) { return place.second.has_value(); }));
  if (drawn == this->Pictures.size())
  {
    this->Pictures.emplace_back(this->Owner,
      vk::DeviceSize(this->Width) * this->Height * sizeof(glm::vec4), Residence::Device,
      "sparse pictures");
  }
  frame->picture = this->Pictures[drawn].address();
  frame->depth = this->HasDepth ? this->Depth.address() : 0;
  frames.push_back(*frame);
  at->second = frame->picture;
  return at->second;
}

std::vector<std::optional<SparsePictures::Difference>> DeviceSparsePictures::compare(
  const std::vector<Pair>& pairs)
{
  std::vector<layout::Frame> frames;
  std::vector<layout::Comparison> comparisons;
  std::vector<std::optional<Difference>> differences(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const Place first = this->FindPlace(pairs[i].first, frames);
    const Place second = first ? this->FindPlace(pairs[i].second, frames) : std::nullopt;
    if (second)
    {
      differences[i] = Difference();
      layout::Comparison comparison{};
      comparison.first = *first;
      comparison.second = *second;
      comparison.result =
        this->Differences.address() + comparisons.size() * sizeof(layout::PictureDifference);
      comparison.pixels = this->Width * this->Height;
      comparisons.push_back(comparison);
    }
  }
  if (frames.empty() && comparisons.empty())
  {
    return differences;
  }
  if (!frames.empty())
  {
    std::memcpy(this->Frames.data(), frames.data(), frames.size() * sizeof(layout::Frame));
  }
  this->Owner->submit(
    [&](const vk::raii::CommandBuffer& commands)
    {
      using Access = vk::AccessFlagBits;
      using Stage = vk::PipelineStageFlagBits;
      if (!frames.empty())
      {
        this->Frames.record(commands, frames.size() * sizeof(layout::Frame));
        if (this->Pass.takesPixels)
        {
          this->Counters.record(commands);
        }
      }
      if (this->HasDepth)
      {
        this->Depth.record(commands, vk::DeviceSize(this->Width) * this->Height * sizeof(float));
      }
      for (std::uint32_t i = 0; i < frames.size(); ++i)
      {
        layout::Band band{};
        band.frame = this->Frames.address() + i * sizeof(layout::Frame);
        band.counter = this->Counters.address(i);
        band.spacing = 1;
        this->Pass.record(commands, band, this->Width, this->Height);
      }
      const vk::MemoryBarrier drawn(Access::eShaderWrite, Access::eShaderRead);
      commands.pipelineBarrier(Stage::eComputeShader, Stage::eComputeShader, {}, drawn, {}, {});
      for (const layout::Comparison& comparison : comparisons)
      {
        this->Compare.record(commands, comparison, 1, 1);
      }
      if (!comparisons.empty())
      {
        this->Differences.record(commands, comparisons.size() * sizeof(layout::PictureDifference));
      }
    });
  const auto* result = static_cast<const layout::PictureDifference*>(this->Differences.data());
  for (std::optional<Difference>& difference : differences)
  {
    if (difference)
    {
      difference = Difference{ result->squares, static_cast<int>(result->drawn) };
      ++result;
    }
  }
  return differences;
}
}
}
