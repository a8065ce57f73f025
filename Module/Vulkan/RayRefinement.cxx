// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/RayRefinement.h"

#include "CheckPredictionsInt64Spirv.h"
#include "CheckPredictionsSpirv.h"
#include "PredictPixelsInt64Spirv.h"
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
// Of the depths that bracket the bounds: where a ray ends as far from where those of its neighbours
// do, geometry has an edge.
constexpr float BendOfEdge = 1.0f / 256.0f;

std::uint32_t groups(std::uint32_t items, std::uint32_t ofGroup)
{
  return (items + ofGroup - 1) / ofGroup;
}
}

RayRefinement::RayRefinement(std::shared_ptr<Device> device)
  : Owner(std::move(device))
{
  const vk::PushConstantRange push(
    vk::ShaderStageFlagBits::eCompute, 0, sizeof(layout::Refinement));
  this->Layout =
    vk::raii::PipelineLayout(this->Owner->handle(), vk::PipelineLayoutCreateInfo({}, {}, push));
  const bool int64 = this->Owner->hasInt64();
  this->Check = this->MakePipeline(int64
      ? vk::ShaderModuleCreateInfo(
          {}, sizeof(CheckPredictionsInt64Spirv), CheckPredictionsInt64Spirv)
      : vk::ShaderModuleCreateInfo({}, sizeof(CheckPredictionsSpirv), CheckPredictionsSpirv));
  this->Predict = this->MakePipeline(int64
      ? vk::ShaderModuleCreateInfo({}, sizeof(PredictPixelsInt64Spirv), PredictPixelsInt64Spirv)
      : vk::ShaderModuleCreateInfo({}, sizeof(PredictPixelsSpirv), PredictPixelsSpirv));
  this->Count.reserve(this->Owner, sizeof(std::uint32_t), "the number of pixels to march");
}

vk::raii::Pipeline RayRefinement::MakePipeline(const vk::ShaderModuleCreateInfo& code) const
{
  const vk::raii::ShaderModule shader(this->Owner->handle(), code);
  const vk::PipelineShaderStageCreateInfo stage(
    {}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
  return { this->Owner->handle(), this->Owner->pipelineCache(),
    vk::ComputePipelineCreateInfo({}, stage, *this->Layout) };
}

void RayRefinement::begin(const layout::Frame& frame, const PredictionLimits& limits)
{
  this->Frame = frame;
  this->Limits = limits;
  this->Marched =
    static_cast<double>(groups(frame.width, FirstSpacing)) * groups(frame.height, FirstSpacing);
  this->Spacing = FirstSpacing / 2;
  const vk::DeviceSize bytes = vk::DeviceSize(frame.width) * frame.height * sizeof(std::uint32_t);
  if (this->ToMarch.bytes() < bytes)
  {
    this->ToMarch = Buffer();
    this->ToMarch = Buffer(this->Owner, bytes, Residence::Device,
      Purpose::ofPicture(
        "the pixels to march", static_cast<int>(frame.width), static_cast<int>(frame.height)));
  }
}

vk::DeviceAddress RayRefinement::list() const
{
  return this->Checking ? this->Checked.address() : this->ToMarch.address();
}

void RayRefinement::listChecks()
{
  this->Side =
    sideOfBlocks(this->Frame.width, this->Frame.height, this->Spacing, this->Limits.rays);
  const std::vector<std::uint32_t> pixels =
    listCheckedPixels(this->Frame.width, this->Frame.height, this->Spacing, this->Side);
  this->Listed = static_cast<std::uint32_t>(pixels.size());
  this->Checked.reserve(
    this->Owner, pixels.size() * sizeof(pixels[0]), "pixels to check predictions by");
  this->Checks.reserve(
    this->Owner, pixels.size() * sizeof(layout::RayCheck), "the errors of predictions");
  std::memcpy(this->Checked.data(), pixels.data(), pixels.size() * sizeof(pixels[0]));
  this->Checking = true;
}

void RayRefinement::recordList(const vk::raii::CommandBuffer& commands) const
{
  this->Checked.record(commands, this->Listed * sizeof(std::uint32_t));
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
  constants.checks = this->Listed;
  this->Record(commands, this->Check, constants, groups(this->Listed, ChecksOfGroup), 1);
  this->Checks.record(commands, this->Listed * sizeof(layout::RayCheck));
}

void RayRefinement::takeChecks()
{
  const auto* const all = static_cast<const layout::RayCheck*>(this->Checks.data());
  const std::vector<layout::RayCheck> checks(all, all + this->Listed);
  this->Marched += this->Listed;
  this->Threshold = this->Limits.tolerance > 0.0
    ? findThreshold(checks, this->Limits.tolerance, this->Spacing == 1)
    : 0.0f;
  if (this->Limits.rays > 0.0)
  {
    this->Threshold = std::max(this->Threshold, findThresholdOfShare(checks, this->FindShare()));
  }
}

double RayRefinement::FindShare() const
{
  const double left = std::max(this->Limits.rays - this->Marched, 0.0);
  const double now = this->Spacing == 1 ? left : 0.5 * left;
  const double places = static_cast<double>(groups(this->Frame.width, this->Spacing)) *
    groups(this->Frame.height, this->Spacing);
  return now / std::max(0.75 * places - this->Listed, 1.0);
}

void RayRefinement::recordPrediction(const vk::raii::CommandBuffer& commands) const
{
  this->Count.clear(commands);
  layout::Refinement constants = this->MakeConstants();
  constants.pixels = this->ToMarch.address();
  constants.results = this->Count.address();
  constants.threshold = this->Threshold;
  // An invocation predicts the three places around a known one.
  const std::uint32_t reach = 2 * this->Spacing * SideOfGroup;
  this->Record(commands, this->Predict, constants, groups(this->Frame.width, reach),
    groups(this->Frame.height, reach));
  this->Count.record(commands, sizeof(std::uint32_t));
}

void RayRefinement::takeList()
{
  std::memcpy(&this->Listed, this->Count.data(), sizeof(this->Listed));
  this->Checking = false;
  this->Marched += this->Listed;
}

bool RayRefinement::goOn()
{
  if (this->Spacing == 1)
  {
    return false;
  }
  this->Spacing /= 2;
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
  // Window depths are half of normalised device coordinates.
  constants.greatestBend = BendOfEdge * 0.5f / this->Frame.inverseDepths.high;
  return constants;
}

void RayRefinement::Record(const vk::raii::CommandBuffer& commands,
  const vk::raii::Pipeline& pipeline, const layout::Refinement& constants, std::uint32_t columns,
  std::uint32_t rows) const
{
  commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
  commands.pushConstants<layout::Refinement>(
    *this->Layout, vk::ShaderStageFlagBits::eCompute, 0, constants);
  commands.dispatch(columns, rows, 1);
}
}
}
