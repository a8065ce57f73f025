// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/LevelsOfDetail.h"

#include "Core/Stopwatch.h"

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
    while (index >= this->Levels.size())
    {
      if (!this->AddCoarser())
      {
        return nullptr;
      }
    }
    for (std::size_t i = 1; i <= index; ++i)
    {
      if (!this->Levels[i].volume.values)
      {
        this->Levels[i].volume =
          coarsenValues(this->Levels[i - 1].volume, this->Levels[i].volume.structure);
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

bool LevelsOfDetail::AddCoarser()
{
  if (this->CoarsestMade)
  {
    return false;
  }
  const Level& finer = this->Levels.back();
  const std::optional<CoarserStructure> coarser = coarsen(*finer.volume.structure);
  if (!coarser)
  {
    this->CoarsestMade = true;
    return false;
  }
  Level level;
  level.volume.structure = coarser->structure;
  level.fromHalfCells = coarser->fromHalfCells * finer.fromHalfCells;
  this->Levels.push_back(std::move(level));
  return true;
}

void LevelsOfDetail::Update(
  Level& level, const std::shared_ptr<Device>& device, const Selection& selection)
{
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
    std::vector<const TransferFunction*> shown;
    for (const std::optional<TransferFunction>& function : selection.visibility)
    {
      shown.push_back(function ? &*function : nullptr);
    }
    level.onDevice->setActive(shown.empty()
        ? selectAllRegions(level.volume, selection.form)
        : selectActiveRegions(level.volume, shown, selection.weights, selection.form));
    level.activeOnDevice = true;
    this->SelectionTime = finest ? watch.seconds() : this->SelectionTime;
  }
}

// The first one known is the whole volume; others may have no values yet.
LevelsOfDetail::Ahead LevelsOfDetail::Make(std::vector<Ahead::Coarser> known, std::size_t count,
  const std::shared_ptr<std::atomic<bool>>& givenUp)
{
  for (std::size_t i = 1; i <= count && !*givenUp; ++i)
  {
    const Ahead::Coarser& finer = known[i - 1];
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
  known.erase(known.begin());
  return { std::move(known) };
}

void LevelsOfDetail::makeAhead(int levelsLeftOut)
{
  const bool noneLeft =
    this->CoarsestMade && static_cast<std::size_t>(levelsLeftOut) >= this->Levels.size();
  if (this->MadeAhead.valid() || this->empty() || noneLeft || levelsLeftOut <= this->ready())
  {
    return;
  }
  std::vector<Ahead::Coarser> known;
  for (const Level& level : this->Levels)
  {
    known.push_back({ level.volume, level.fromHalfCells });
  }
  this->GivenUp = std::make_shared<std::atomic<bool>>(false);
  try
  {
    this->MadeAhead = std::async(std::launch::async, &LevelsOfDetail::Make, std::move(known),
      static_cast<std::size_t>(levelsLeftOut), this->GivenUp);
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
    const Ahead made = this->MadeAhead.get();
    for (std::size_t i = 0; i < made.coarser.size(); ++i)
    {
      if (i + 1 == this->Levels.size())
      {
        this->Levels.emplace_back();
        this->Levels.back().volume.structure = made.coarser[i].volume.structure;
        this->Levels.back().fromHalfCells = made.coarser[i].fromHalfCells;
      }
      Level& level = this->Levels[i + 1];
      if (!level.volume.values && level.volume.structure == made.coarser[i].volume.structure)
      {
        level.volume = made.coarser[i].volume;
      }
    }
  }
  catch (const std::exception&) // most likely of too little memory
  {
    this->CoarsestMade = true;
  }
}

// Waits until the level is made that is being made.
void LevelsOfDetail::DropAhead()
{
  if (this->GivenUp)
  {
    *this->GivenUp = true;
  }
  this->MadeAhead = {};
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
  }
  return bytes;
}
}
}
