// SPDX-License-Identifier: BSD-3-Clause
// Shadows that a volume casts on itself: for each cell, how much of each light comes to it through
// the medium. Between cells they are reconstructed as the field is, so that they are as fine as the
// cells are; and they are found once for as long as lights and opacities stay, wherever the eye is.
#ifndef ExaBricksVulkanCellShadows_h
#define ExaBricksVulkanCellShadows_h

#include "Core/View.h"
#include "Vulkan/DeviceVolume.h"
#include "Vulkan/Exchange.h"
#include "Vulkan/MarchPass.h"
#include "Vulkan/Pace.h"

#include <functional>

namespace exabricks
{
namespace vulkan
{
/// What they depend on beside the volume on the device.
class ShadowCause
{
public:
  /// Of a view whose lighting has scattering.
  explicit ShadowCause(const View& view);

  /// Whether light comes the same ways through the same, but for rounding; how bright it is does
  /// not matter.
  bool operator==(const ShadowCause& other) const;
  /// Whether all but the lights is the same, as many as they are.
  bool isOfSameMedium(const ShadowCause& other) const;

  /// The view with these lights, and the steps that shadows are found with.
  View steady(View view) const;

private:
  exabricks::Cutaway Cutaway;
  exabricks::Reconstruction Reconstruction;
  glm::dmat3 HalfCellsToData;
  double OpacityUnitDistance;
  double StepScale;
  double SampleDistance;
  double Reach;
  std::optional<glm::dvec4> UndefinedColor;
  std::vector<Light> Lights;
  glm::dmat3 DataToWorld;
};

class CellShadows
{
public:
  /// Makes room for those of so many lights in the bricks of the active regions. Throws
  /// PictureFailure.
  CellShadows(std::shared_ptr<Device> device, const DeviceVolume& onDevice, const Volume& volume,
    const ActiveRegions& active, std::size_t lights);

  std::size_t lights() const { return this->Lights; }
  /// Whether they need not be found anew. `lags`: those that a search has left that was given up do
  /// too.
  bool serve(const ShadowCause& cause, bool lags) const
  {
    return this->Found ? *this->Found == cause
                       : lags && this->Filled && this->Filled->isOfSameMedium(cause);
  }

  /// Finds them, some cells after others. `frame`: of a view with these lights, after fill().
  /// `pass`: of a variant ofCells. False: `goOn`, which is asked in between, gave it up.
  bool find(const ShadowCause& cause, const layout::Frame& frame, const MarchPass& pass,
    const std::function<bool()>& goOn);

  vk::DeviceSize bytes() const;
  void fill(layout::Frame& frame) const;

private:
  void MakeList(const Volume& volume, const ActiveRegions& active);

  std::shared_ptr<Device> Owner;
  std::vector<Buffer> Shares;
  Buffer Addresses; // of [light / components][brick]
  Buffer List;      // of the bricks in which they are found
  Input Constants;
  PixelCounters Counters;
  std::uint32_t Lights;
  std::uint32_t Bricks;
  std::uint32_t ListedBricks = 0;
  std::uint32_t Cells = 0; // of those
  Pace CellPace{ 5e5 };
  std::optional<ShadowCause> Found;  // what all of them are of
  std::optional<ShadowCause> Filled; // each is of it, or of other lights in the same medium
};
}
}

#endif
