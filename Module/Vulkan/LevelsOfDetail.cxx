// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/LevelsOfDetail.h"

#include "Core/Stopwatch.h"

#include <algorithm>
#include <chrono>

namespace exabricks
{
namespace vulkan
{
namespace
{
// All components of the volume, in the structure that coarsen() made of its own.
Volume coarsenValues(const Volume& finer, const std::shared_ptr<const Structure>& structure)
{
  Volume coarser{ structure, coarsen(finer, *structure) };
  for (const std::shared_ptr<const Values>& values : finer.furtherValues)
  {
    coarser.furtherValues.push_back(coarsen({ finer.structure, values }, *structure));
  }
  return coarser;
}
}

void LevelsOfDetail::setVolume(const Volume& volume)
{
  this->ForgetDropped();
  if (!volume)
  {
    this->DropFrom(0);
    return;
  }
  if (this->empty() || volume.structure != this->volume().structure ||
    volume.components() != this->volume().components())
  {
    this->DropFrom(0);
    this->Levels.emplace_back();
    this->Levels.front().volume = volume;
    return;
  }
  if (volume.values == this->volume().values &&
    volume.furtherValues == this->volume().furtherValues)
  {
    return;
  }
  this->DropAhead();
  for (Level& level : this->Levels)
  {
    level.volume.values.reset(); // of coarser ones, made when they are drawn
    level.volume.furtherValues.clear();
    level.valuesOnDevice = false;
    level.activeOnDevice = false;
  }
  this->Levels.front().volume.values = volume.values;
  this->Levels.front().volume.furtherValues = volume.furtherValues;
}

LevelsOfDetail::Level& LevelsOfDetail::updateFinest(
  const std::shared_ptr<Device>& device, const Selection& selection)
{
  Level& finest = this->Levels.front();
  this->Update(finest, device, selection);
  return finest;
}

LevelsOfDetail::Level* LevelsOfDetail::findCoarser(
  int levelsLeftOut, const std::shared_ptr<Device>& device, const Selection& selection)
{
  if (levelsLeftOut <= 0)
  {
    return &this->Levels.front();
  }
  const auto index = static_cast<std::size_t>(levelsLeftOut);
  try
  {
    for (std::size_t i = 1; i <= index; ++i)
    {
      const bool known = i < this->Levels.size();
      if (!known && this->CoarsestMade)
      {
        return nullptr;
      }
      if (!known || !this->Levels[i].volume.values)
      {
        this->Adopt(Make(this->Known(), i, std::atomic<bool>(false)), i);
      }
      if (i >= this->Levels.size())
      {
        return nullptr;
      }
    }
    this->Update(this->Levels[index], device, selection);
    return &this->Levels[index];
  }
  catch (const std::bad_alloc&)
  {
  }
  catch (const Failure&)
  {
  }
  catch (const vk::OutOfDeviceMemoryError&)
  {
  }
  this->DropFrom(index);
  this->CoarsestMade = true;
  return nullptr;
}

double LevelsOfDetail::secondsToUpdate(int levelsLeftOut) const
{
  const auto index = static_cast<std::size_t>(levelsLeftOut);
  if (index >= this->Levels.size() || !this->Levels[index].volume.values)
  {
    return 0.0;
  }
  const auto bytesOf = [](const Volume& volume)
  { return static_cast<double>(volume.structure->bytes() + volume.values->bytes()); };
  const auto secondsOf = [this](const Level& level)
  {
    return (level.onDevice && level.valuesOnDevice ? 0.0 : this->UploadTime) +
      (level.activeOnDevice ? 0.0 : this->SelectionTime);
  };
  const double whole = secondsOf(this->Levels.front()); // which is brought up to date too
  const Level& level = this->Levels[index];
  const double seconds = index > 0 ? secondsOf(level) : 0.0;
  return whole + (seconds > 0.0 ? seconds * bytesOf(level.volume) / bytesOf(this->volume()) : 0.0);
}

ActiveRegions LevelsOfDetail::select(const Volume& volume, const Selection& selection)
{
  std::vector<const TransferFunction*> shown;
  for (const std::optional<TransferFunction>& function : selection.visibility)
  {
    shown.push_back(function ? &*function : nullptr);
  }
  return shown.empty() ? selectAllRegions(volume, selection.form)
                       : selectActiveRegions(volume, shown, selection.weights, selection.form);
}

void LevelsOfDetail::dropShadows()
{
  for (Level& level : this->Levels)
  {
    level.shadows.reset();
  }
}

void LevelsOfDetail::Update(
  Level& level, const std::shared_ptr<Device>& device, const Selection& selection)
{
  this->ForgetDropped();
  const bool finest = &level == &this->Levels.front();
  if (!level.onDevice || !level.valuesOnDevice)
  {
    const Stopwatch watch;
    if (level.onDevice)
    {
      level.onDevice->setValues(level.volume);
    }
    else
    {
      level.activeOnDevice = false;
      level.onDevice = std::make_unique<DeviceVolume>(device, level.volume);
      ++this->StructureUploads;
    }
    ++this->ValueUploads;
    level.valuesOnDevice = true;
    this->UploadTime = finest ? watch.seconds() : this->UploadTime;
  }
  if (!level.activeOnDevice)
  {
    const Stopwatch watch;
    level.onDevice->setActive(select(level.volume, selection));
    level.shadows.reset();
    level.activeOnDevice = true;
    this->SelectionTime = finest ? watch.seconds() : this->SelectionTime;
  }
}

std::vector<LevelsOfDetail::OnHost> LevelsOfDetail::Known() const
{
  std::vector<OnHost> known;
  for (const Level& level : this->Levels)
  {
    known.push_back({ level.volume, level.fromHalfCells });
  }
  return known;
}

// Without up to `count` levels, as far as there are as many. The first one known is the whole
// volume; others may have no values yet.
std::vector<LevelsOfDetail::OnHost> LevelsOfDetail::Make(
  std::vector<OnHost> known, std::size_t count, const std::atomic<bool>& givenUp)
{
  for (std::size_t i = 1; i <= count && !givenUp; ++i)
  {
    const OnHost& finer = known[i - 1];
    if (i == known.size())
    {
      const std::optional<CoarserStructure> coarser = coarsen(*finer.volume.structure);
      if (!coarser)
      {
        break;
      }
      const glm::dmat4 fromHalfCells = coarser->fromHalfCells * finer.fromHalfCells;
      known.push_back({ { coarser->structure, nullptr }, fromHalfCells });
    }
    if (!known[i].volume.values)
    {
      known[i].volume = coarsenValues(known[i - 1].volume, known[i].volume.structure);
    }
  }
  return known;
}

// Takes over what was made of what was known before, for `count` levels less.
void LevelsOfDetail::Adopt(const std::vector<OnHost>& made, std::size_t count)
{
  for (std::size_t i = 1; i < made.size(); ++i)
  {
    if (i == this->Levels.size())
    {
      this->Levels.emplace_back();
      this->Levels.back().volume.structure = made[i].volume.structure;
      this->Levels.back().fromHalfCells = made[i].fromHalfCells;
    }
    Level& level = this->Levels[i];
    if (!level.volume.values && level.volume.structure == made[i].volume.structure)
    {
      level.volume = made[i].volume;
    }
  }
  this->CoarsestMade = this->CoarsestMade || made.size() <= count;
}

void LevelsOfDetail::makeAhead(int levelsLeftOut)
{
  const auto count = static_cast<std::size_t>(levelsLeftOut);
  const bool noneLeft = this->CoarsestMade && count >= this->Levels.size();
  this->ForgetDropped();
  // One thread at a time.
  const bool isBusy = this->MadeAhead.valid() || !this->Dropped.empty();
  if (isBusy || this->empty() || noneLeft || levelsLeftOut <= this->ready())
  {
    return;
  }
  this->GivenUp = std::make_shared<std::atomic<bool>>(false);
  this->CountAhead = count;
  try
  {
    this->MadeAhead = std::async(std::launch::async,
      [givenUp = this->GivenUp, known = this->Known(), count]
      { return Make(known, count, *givenUp); });
  }
  catch (const std::exception&) // no thread is to be had
  {
    this->CoarsestMade = true;
  }
}

void LevelsOfDetail::TakeAhead()
{
  if (!this->MadeAhead.valid() ||
    this->MadeAhead.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
  {
    return;
  }
  try
  {
    this->Adopt(this->MadeAhead.get(), this->CountAhead);
  }
  catch (const std::exception&) // most likely of too little memory
  {
    this->CoarsestMade = true;
  }
}

// Nobody waits for a level that is being made: it comes to its end by itself.
void LevelsOfDetail::DropAhead()
{
  if (this->MadeAhead.valid())
  {
    *this->GivenUp = true;
    this->Dropped.push_back(std::move(this->MadeAhead));
  }
}

// Frees what came to its end of no use.
void LevelsOfDetail::ForgetDropped()
{
  const auto isDone = [](const std::future<std::vector<OnHost>>& made)
  { return made.wait_for(std::chrono::seconds(0)) == std::future_status::ready; };
  this->Dropped.erase(
    std::remove_if(this->Dropped.begin(), this->Dropped.end(), isDone), this->Dropped.end());
}

int LevelsOfDetail::ready()
{
  this->TakeAhead();
  std::size_t count = 0;
  while (count + 1 < this->Levels.size() && this->Levels[count + 1].volume.values)
  {
    ++count;
  }
  return static_cast<int>(count);
}

void LevelsOfDetail::invalidateSelection()
{
  for (Level& level : this->Levels)
  {
    level.activeOnDevice = false;
  }
}

void LevelsOfDetail::DropFrom(std::size_t level)
{
  this->DropAhead();
  if (level < this->Levels.size())
  {
    this->Levels.erase(this->Levels.begin() + level, this->Levels.end());
  }
  this->CoarsestMade = false;
}

void LevelsOfDetail::dropCoarser() { this->DropFrom(1); }

void LevelsOfDetail::dropDevice()
{
  for (Level& level : this->Levels)
  {
    level.shadows.reset();
    level.onDevice.reset();
    level.valuesOnDevice = false;
    level.activeOnDevice = false;
  }
}

vk::DeviceSize LevelsOfDetail::bytes() const
{
  vk::DeviceSize bytes = 0;
  for (const Level& level : this->Levels)
  {
    bytes += level.onDevice ? level.onDevice->bytes() : 0;
    bytes += level.shadows ? level.shadows->bytes() : 0;
  }
  return bytes;
}
}
}
