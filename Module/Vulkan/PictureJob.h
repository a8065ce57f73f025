// SPDX-License-Identifier: BSD-3-Clause
// One picture as a job: begin, march some pixels after others, finish. A job can be used for one
// picture after another, and keeps its buffers.
#ifndef ExaBricksVulkanPictureJob_h
#define ExaBricksVulkanPictureJob_h

#include "Vulkan/Exchange.h"
#include "Vulkan/MarchPass.h"
#include "Vulkan/Pace.h"
#include "Vulkan/RayRefinement.h"

namespace exabricks
{
namespace vulkan
{
class PictureJob
{
public:
  explicit PictureJob(std::shared_ptr<Device> device);

  /// `frame` comes with all that concerns volume, transfer function and view (fillView()). The
  /// target's depths are read before it returns. `predictionTolerance`: what pixels may err by
  /// that are predicted from others (PredictedRays); 0: all are marched. Throws PictureFailure,
  /// where there is no memory for a picture of that size.
  void begin(const layout::Frame& frame, const Target& target, const MarchPass& pass,
    double predictionTolerance = 0.0);

  /// Marches the next pixels, a piece at a time (Pace). False: all are done.
  bool march();
  /// Pixels done, of all.
  double progress() const;

  /// The picture, [height][width], when all pixels are done; and how many of them were marched.
  const glm::vec4* pixels() const;
  std::size_t rays() const { return this->Rays; }

private:
  enum class Stage
  {
    Grid,    // rows of a grid of pixels; of all, where none are predicted
    Check,   // pixels by which predictions are checked
    Predict, // pixels between those that are known
    List,    // those that could not be predicted
    Fetch,   // the picture, where something was predicted
    Done
  };

  void MarchRows();
  void MarchChecks();
  void PredictPixels();
  void MarchList();
  void Fetch();

  void RecordInputs(const vk::raii::CommandBuffer& commands) const;
  void RecordPicture(const vk::raii::CommandBuffer& commands) const;
  /// So many pixels of a list, from the first one on.
  void RecordList(const vk::raii::CommandBuffer& commands, vk::DeviceAddress list,
    std::uint32_t first, std::uint32_t count) const;
  /// The next piece of a list of so many pixels, with what is recorded before the first one and
  /// after the last one. True: all of them are done.
  bool MarchPiece(vk::DeviceAddress list, std::uint32_t all, const Device::Record& before = {},
    const Device::Record& after = {});
  void Took(double seconds, double pixels);

  std::shared_ptr<Device> Owner;
  Input Constants;
  Input Depth;
  Input NearDepth;
  Output Picture;
  PixelCounters Counters;
  std::unique_ptr<RayRefinement> Refinement; // made when first needed
  MarchPass Pass;
  bool HasDepth = false;
  bool HasNearDepth = false;
  bool Predicts = false;
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  Stage Next = Stage::Done;
  std::uint32_t Spacing = 1; // of the grid that is marched by rows
  std::uint32_t NextRow = 0; // of it
  std::uint32_t NextOfList = 0;
  std::size_t Rays = 0;
  std::size_t Predicted = 0;
  Pace Pixels{ 2e6 }; // of this picture and those before
};
}
}

#endif
