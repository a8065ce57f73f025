// SPDX-License-Identifier: BSD-3-Clause
// The pixels of a picture that are predicted from others, and those that are not (PredictedRays),
// grid by grid, as commands; whoever records them marches the pixels that are listed.
#ifndef ExaBricksVulkanRayRefinement_h
#define ExaBricksVulkanRayRefinement_h

#include "Core/PredictedRays.h"
#include "Vulkan/ComputePipeline.h"
#include "Vulkan/Exchange.h"

namespace exabricks
{
namespace vulkan
{
class RayRefinement
{
public:
  explicit RayRefinement(std::shared_ptr<Device> device);

  /// A picture whose pixels at every FirstSpacing-th place are marched, by `frame`, so that
  /// predictions err by `tolerance`. Throws PictureFailure, where there is no memory for the list.
  void begin(const layout::Frame& frame, double tolerance);

  /// Of the present grid, the pixels that are marched to check predictions by: their number, which
  /// may be 0, and the device address of their list.
  std::uint32_t checks() const { return this->CheckCount; }
  vk::DeviceAddress checkList() const { return this->Checked.address(); }
  /// Before the first of them is marched.
  void recordCheckList(const vk::raii::CommandBuffer& commands) const;
  /// When all of them are, and when that is done.
  void recordChecks(const vk::raii::CommandBuffer& commands) const;
  void takeChecks();

  /// Predicts the others, and when that is done: those that were predicted, and those that are to
  /// be marched.
  void recordPrediction(const vk::raii::CommandBuffer& commands) const;
  void takePrediction();
  std::uint32_t predicted() const
  {
    return this->Places() - this->CheckCount - this->RemainingCount;
  }
  std::uint32_t remaining() const { return this->RemainingCount; }
  vk::DeviceAddress remainingList() const { return this->Remaining.address(); }

  /// When these have been marched. False: that was the last grid.
  bool goOn();

private:
  void ListChecks();
  /// Pixels that the grid adds to the one before.
  std::uint32_t Places() const;
  layout::Refinement MakeConstants() const;

  std::shared_ptr<Device> Owner;
  ComputePipeline<layout::Refinement> Check;   // Shaders/CheckPredictions.comp
  ComputePipeline<layout::Refinement> Predict; // Shaders/PredictPixels.comp
  layout::Frame Frame{};                       // the picture's
  double Tolerance = 0.0;
  std::uint32_t Spacing = 1; // of the grid
  std::uint32_t Side = 1;    // of its blocks
  float Threshold = 0.0f;
  Input Checked; // list
  Output Checks;
  Buffer Remaining; // list
  Output Count;     // of them
  std::uint32_t CheckCount = 0;
  std::uint32_t RemainingCount = 0;
};
}
}

#endif
