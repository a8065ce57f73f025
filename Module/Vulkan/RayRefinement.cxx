// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/RayRefinement.h"

#include "CheckPredictionsSpirv.h"
#include "PredictPixelsSpirv.h"

#include <algorithm>
#include <cstring>

namespace exabricks
{
namespace vulkan
{
namespace
{
constexpr std::uint32_t ChecksOfGroup = 64; // local_size of CheckPredictions.comp
constexpr std::uint32_t SideOfGroup = 8;    // and of PredictPixels.comp

std::uint32_t groups(std::uint32_t items, std::uint32_t ofGroup)
{
  return (items + ofGroup - 1) / ofGroup;
}
}

RayRefinement::RayRefinement(std::shared_ptr<Device> device)
  : Owner(std::move(device))
  , Check(*this->Owner, { {}, sizeof(CheckPredictionsSpirv), CheckPredictionsSpirv })
  , Predict(*this->Owner, { {}, sizeof(PredictPixelsSpirv), PredictPixelsSpirv })
{
  this->Count.reserve(this->Owner, sizeof(std::uint32_t), "the number of pixels to march");
}

void RayRefinement::begin(const layout::Frame& frame, double tolerance)
{
  this->Frame = frame;
  this->Tolerance = tolerance;
  this->Spacing = FirstSpacing / 2;
  const vk::DeviceSize bytes = vk::DeviceSize(frame.width) * frame.height * sizeof(std::uint32_t);
  if (this->Remaining.bytes() < bytes)
  {
    this->Remaining = Buffer();
    this->Remaining = Buffer(this->Owner, bytes, Residence::Device,
      Purpose::ofPicture(
        "the pixels to march", static_cast<int>(frame.width), static_cast<int>(frame.height)));
  }
  this->ListChecks();
}

void RayRefinement::ListChecks()
{
  this->Side = sideOfBlocks(this->Frame.width, this->Frame.height, this->Spacing);
  const std::vector<std::uint32_t> pixels =
    listCheckedPixels(this->Frame.width, this->Frame.height, this->Spacing, this->Side);
  this->CheckCount = static_cast<std::uint32_t>(pixels.size());
  if (!pixels.empty())
  {
    this->Checked.reserve(
      this->Owner, pixels.size() * sizeof(pixels[0]), "pixels to check predictions by");
    this->Checks.reserve(
      this->Owner, pixels.size() * sizeof(layout::RayCheck), "the errors of predictions");
    std::memcpy(this->Checked.data(), pixels.data(), pixels.size() * sizeof(pixels[0]));
  }
}

void RayRefinement::recordCheckList(const vk::raii::CommandBuffer& commands) const
{
  this->Checked.record(commands, this->CheckCount * sizeof(std::uint32_t));
}

void RayRefinement::recordChecks(const vk::raii::CommandBuffer& commands) const
{
  using Access = vk::AccessFlagBits;
  using Stage = vk::PipelineStageFlagBits;
  const vk::MemoryBarrier marched(Access::eShaderWrite, Access::eShaderRead);
  commands.pipelineBarrier(Stage::eComputeShader, Stage::eComputeShader, {}, marched, {}, {});
  layout::Refinement constants = this->MakeConstants();
  constants.pixels = this->Checked.address();
  constants.results = this->Checks.address();
  constants.checks = this->CheckCount;
  this->Check.record(commands, constants, groups(this->CheckCount, ChecksOfGroup), 1);
  this->Checks.record(commands, this->CheckCount * sizeof(layout::RayCheck));
}

void RayRefinement::takeChecks()
{
  std::vector<layout::RayCheck> checks(this->CheckCount);
  if (!checks.empty())
  {
    std::memcpy(checks.data(), this->Checks.data(), checks.size() * sizeof(checks[0]));
  }
  this->Threshold = findThreshold(std::move(checks), this->Tolerance, this->Spacing == 1);
}

std::uint32_t RayRefinement::Places() const
{
  const auto places = [&](std::uint32_t spacing)
  { return groups(this->Frame.width, spacing) * groups(this->Frame.height, spacing); };
  return places(this->Spacing) - places(2 * this->Spacing);
}

void RayRefinement::recordPrediction(const vk::raii::CommandBuffer& commands) const
{
  this->Count.clear(commands);
  layout::Refinement constants = this->MakeConstants();
  constants.pixels = this->Remaining.address();
  constants.results = this->Count.address();
  constants.threshold = this->Threshold;
  // An invocation predicts the three places around a known one.
  const std::uint32_t reach = 2 * this->Spacing * SideOfGroup;
  this->Predict.record(
    commands, constants, groups(this->Frame.width, reach), groups(this->Frame.height, reach));
  this->Count.record(commands, sizeof(std::uint32_t));
}

void RayRefinement::takePrediction()
{
  std::memcpy(&this->RemainingCount, this->Count.data(), sizeof(this->RemainingCount));
}

bool RayRefinement::goOn()
{
  if (this->Spacing == 1)
  {
    return false;
  }
  this->Spacing /= 2;
  this->ListChecks();
  return true;
}

layout::Refinement RayRefinement::MakeConstants() const
{
  layout::Refinement constants{};
  constants.picture = this->Frame.picture;
  constants.depth = this->Frame.depth;
  constants.width = this->Frame.width;
  constants.height = this->Frame.height;
  constants.spacing = this->Spacing;
  constants.side = this->Side;
  constants.hasDepth = this->Frame.hasDepth;
  constants.firstDepth = this->Frame.firstDepth.high;
  constants.inverseDepths = this->Frame.inverseDepths.high;
  constants.firstW = this->Frame.first.high.w;
  constants.secondW = this->Frame.second.high.w;
  return constants;
}
}
}
