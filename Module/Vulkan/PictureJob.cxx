// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/PictureJob.h"

#include "Core/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace exabricks
{
namespace vulkan
{
PictureJob::PictureJob(std::shared_ptr<Device> device)
  : Owner(std::move(device))
  , Counters(this->Owner, 1)
{
  this->Constants.reserve(this->Owner, sizeof(layout::Frame), "the frame's constants");
}

void PictureJob::begin(const layout::Frame& frame, const Target& target, const MarchPass& pass,
  double predictionTolerance)
{
  this->Pass = pass;
  this->Width = static_cast<std::uint32_t>(target.width);
  this->Height = static_cast<std::uint32_t>(target.height);
  this->Predicts = predictionTolerance > 0.0;
  this->Next = Stage::Grid;
  this->Spacing = this->Predicts ? FirstSpacing : 1;
  this->NextRow = 0;
  this->NextOfList = 0;
  this->Rays = 0;
  this->Predicted = 0;
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
  if (this->Predicts)
  {
    if (!this->Refinement)
    {
      this->Refinement = std::make_unique<RayRefinement>(this->Owner);
    }
    this->Refinement->begin(constants, predictionTolerance);
  }
}

bool PictureJob::march()
{
  switch (this->Next)
  {
    case Stage::Grid:
      this->MarchRows();
      break;
    case Stage::Check:
      this->MarchChecks();
      break;
    case Stage::Predict:
      this->PredictPixels();
      break;
    case Stage::List:
      this->MarchList();
      break;
    case Stage::Fetch:
      this->Fetch();
      break;
    case Stage::Done:
      return false;
  }
  return true;
}

void PictureJob::MarchRows()
{
  const std::uint32_t columns = (this->Width + this->Spacing - 1) / this->Spacing;
  const std::uint32_t allRows = (this->Height + this->Spacing - 1) / this->Spacing;
  const double wanted = this->Pixels.wanted() / (columns * TileSize);
  const std::uint32_t tileRows = (allRows - this->NextRow + TileSize - 1) / TileSize;
  const std::uint32_t rows = std::min(allRows - this->NextRow,
    TileSize * static_cast<std::uint32_t>(std::clamp<double>(wanted, 1.0, tileRows)));
  const bool first = this->NextRow == 0;
  const bool last = this->NextRow + rows == allRows;
  layout::Band band{};
  band.frame = this->Constants.address();
  band.counter = this->Counters.address(0);
  band.firstRow = this->NextRow;
  band.spacing = this->Spacing;

  const Stopwatch watch;
  this->Owner->submit(
    [&](const vk::raii::CommandBuffer& commands)
    {
      if (first)
      {
        this->RecordInputs(commands);
      }
      if (this->Pass.takesPixels)
      {
        this->Counters.record(commands);
      }
      this->Pass.record(commands, band, columns, rows);
      if (last && !this->Predicts)
      {
        this->RecordPicture(commands);
      }
    });
  this->Took(watch.seconds(), static_cast<double>(columns) * rows);
  this->NextRow += rows;
  if (last)
  {
    this->Next = this->Predicts ? Stage::Check : Stage::Done;
  }
}

bool PictureJob::MarchPiece(vk::DeviceAddress list, std::uint32_t all, const Device::Record& before,
  const Device::Record& after)
{
  const std::uint32_t count = std::min(all - this->NextOfList,
    static_cast<std::uint32_t>(std::clamp<double>(this->Pixels.wanted(), 64.0, 1e9)));
  const bool last = this->NextOfList + count == all;
  if (count > 0)
  {
    const Stopwatch watch;
    this->Owner->submit(
      [&](const vk::raii::CommandBuffer& commands)
      {
        if (before && this->NextOfList == 0)
        {
          before(commands);
        }
        this->RecordList(commands, list, this->NextOfList, count);
        if (after && last)
        {
          after(commands);
        }
      });
    this->Took(watch.seconds(), count);
  }
  this->NextOfList = last ? 0 : this->NextOfList + count;
  return last;
}

void PictureJob::MarchChecks()
{
  const bool done = this->MarchPiece(
    this->Refinement->checkList(), this->Refinement->checks(),
    [this](const vk::raii::CommandBuffer& commands)
    { this->Refinement->recordCheckList(commands); },
    [this](const vk::raii::CommandBuffer& commands) { this->Refinement->recordChecks(commands); });
  if (done)
  {
    this->Refinement->takeChecks();
    this->Next = Stage::Predict;
  }
}

void PictureJob::PredictPixels()
{
  this->Owner->submit(
    [&](const vk::raii::CommandBuffer& commands) { this->Refinement->recordPrediction(commands); });
  this->Refinement->takePrediction();
  this->Predicted += this->Refinement->predicted();
  this->Next = Stage::List;
}

void PictureJob::MarchList()
{
  if (this->MarchPiece(this->Refinement->remainingList(), this->Refinement->remaining()))
  {
    this->Next = this->Refinement->goOn() ? Stage::Check : Stage::Fetch;
  }
}

void PictureJob::Fetch()
{
  this->Owner->submit(
    [&](const vk::raii::CommandBuffer& commands) { this->RecordPicture(commands); });
  this->Next = Stage::Done;
}

void PictureJob::RecordInputs(const vk::raii::CommandBuffer& commands) const
{
  const vk::DeviceSize pixels = vk::DeviceSize(this->Width) * this->Height;
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

void PictureJob::RecordPicture(const vk::raii::CommandBuffer& commands) const
{
  this->Picture.record(commands, vk::DeviceSize(this->Width) * this->Height * sizeof(glm::vec4));
}

void PictureJob::RecordList(const vk::raii::CommandBuffer& commands, vk::DeviceAddress list,
  std::uint32_t first, std::uint32_t count) const
{
  layout::Band band{};
  band.frame = this->Constants.address();
  band.counter = this->Counters.address(0);
  band.pixels = list;
  band.firstRow = first;
  band.count = count;
  if (this->Pass.takesPixels)
  {
    this->Counters.record(commands);
  }
  this->Pass.recordList(commands, band);
}

void PictureJob::Took(double seconds, double pixels)
{
  this->Rays += static_cast<std::size_t>(pixels);
  this->Pixels.took(seconds, pixels);
}

double PictureJob::progress() const
{
  const double all = static_cast<double>(this->Width) * this->Height;
  return all > 0.0 ? static_cast<double>(this->Rays + this->Predicted) / all : 1.0;
}

const glm::vec4* PictureJob::pixels() const
{
  return static_cast<const glm::vec4*>(this->Picture.data());
}
}
}
