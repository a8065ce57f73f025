// SPDX-License-Identifier: BSD-3-Clause
// A volume, and what is left of it without some of its finest levels, each made and put on the
// device when it is first drawn.
#ifndef ExaBricksVulkanLevelsOfDetail_h
#define ExaBricksVulkanLevelsOfDetail_h

#include "Core/Appearance.h"
#include "Core/Coarsening.h"
#include "Vulkan/CellShadows.h"
#include "Vulkan/DeviceVolume.h"

#include <atomic>
#include <future>

namespace exabricks
{
namespace vulkan
{
/// What of a volume is walked, and in which form.
struct Selection
{
  /// Empty: all regions with bricks, as wholes.
  Visibility visibility;
  const StepWeights* weights = nullptr;    // null: one cell of the finest brick everywhere
  ActiveForm form{ false, Extreme::None }; // boxes: for ray queries; else the k-d tree
};

class LevelsOfDetail
{
public:
  /// Waits for the level that is being made, if any is.
  ~LevelsOfDetail() { this->DropAhead(); }

  /// Another array or time step on the same structure keeps all but values; of another structure
  /// nothing is kept. An empty volume frees everything.
  void setVolume(const Volume& volume);
  bool empty() const { return this->Levels.empty(); }
  const Volume& volume() const { return this->Levels.front().volume; }

  struct Level
  {
    Volume volume;
    glm::dmat4 fromHalfCells{ 1.0 };        // of the whole volume
    std::unique_ptr<DeviceVolume> onDevice; // null before it is uploaded
    std::unique_ptr<CellShadows> shadows;   // null before any are cast
    bool valuesOnDevice = false;            // and not those of another array or time step
    bool activeOnDevice = false;            // and selected by the present transfer function
  };

  /// The whole volume, up to date on the device. Throws Failure.
  Level& updateFinest(const std::shared_ptr<Device>& device, const Selection& selection);
  /// The volume without so many levels, up to date; null: it has not so many to leave out, or there
  /// is no memory to do so. The whole one has to be up to date.
  Level* findCoarser(
    int levelsLeftOut, const std::shared_ptr<Device>& device, const Selection& selection);

  /// Starts to make the volumes without up to so many levels, on a thread of its own.
  void makeAhead(int levelsLeftOut);
  /// How many levels may be left out of what was made so far, on the host.
  int ready();

  /// About how many seconds it will take to bring the volume without so many levels, which is
  /// ready, up to date on the device.
  double secondsToUpdate(int levelsLeftOut) const;

  static ActiveRegions select(const Volume& volume, const Selection& selection);
  /// Other colours or opacities cast other shadows.
  void dropShadows();

  /// The active regions have to be selected anew.
  void invalidateSelection();
  void dropCoarser();
  /// Frees everything on the device.
  void dropDevice();
  /// On the device.
  vk::DeviceSize bytes() const;

  /// Of the whole volume, seconds, of the last time each was done.
  double uploadTime() const { return this->UploadTime; }
  double selectionTime() const { return this->SelectionTime; }
  /// How often structures and values were uploaded, of all levels.
  std::size_t structureUploads() const { return this->StructureUploads; }
  std::size_t valueUploads() const { return this->ValueUploads; }

private:
  void Update(Level& level, const std::shared_ptr<Device>& device, const Selection& selection);
  void DropFrom(std::size_t level);

  // What of a level does not need the device.
  struct OnHost
  {
    Volume volume;
    glm::dmat4 fromHalfCells{ 1.0 };
  };
  std::vector<OnHost> Known() const;
  static std::vector<OnHost> Make(
    std::vector<OnHost> known, std::size_t count, const std::atomic<bool>& givenUp);
  void Adopt(const std::vector<OnHost>& made, std::size_t count);
  void TakeAhead();
  void DropAhead();
  void ForgetDropped();

  std::vector<Level> Levels;                  // the whole volume, and then one level less each
  bool CoarsestMade = false;                  // there are no more levels to leave out
  std::shared_ptr<std::atomic<bool>> GivenUp; // what is being made is of no use any more
  std::size_t CountAhead = 0;                 // of levels that are left out of it
  std::future<std::vector<OnHost>> MadeAhead;
  std::vector<std::future<std::vector<OnHost>>> Dropped; // that have not come to their end yet
  double UploadTime = 0.0;
  double SelectionTime = 0.0;
  std::size_t StructureUploads = 0;
  std::size_t ValueUploads = 0;
};
}
}

#endif
