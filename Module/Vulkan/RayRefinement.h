// SPDX-License-Identifier: BSD-3-Clause
// The pixels of a picture that are predicted from others, and those that are not (PredictedRays),
// grid by grid, as commands; whoever records them marches the pixels that are listed.
#ifndef ExaBricksVulkanRayRefinement_h
#define ExaBricksVulkanRayRefinement_h

#include "Core/PredictedRays.h"
#include "Vulkan/Exchange.h"

namespace exabricks
{
namespace vulkan
{
class RayRefinement
{
public:
  explicit RayRefinement(std::shared_ptr<Device> device);

  /// A picture whose pixels at every FirstSpacing-th place are marched, by `frame`. Throws
  /// PictureFailure, where there is no memory for the list.
  void begin(const layout::Frame& frame, const PredictionLimits& limits);

  /// Of the present grid: pixels, their number and the list's device address.
  std::uint32_t listed() const { return this->Listed; }
  vk::DeviceAddress list() const;

  /// Lists the pixels that are marched to check predictions by.
  void listChecks();
  /// Before they are marched, and after it.
  void recordList(const vk::raii::CommandBuffer& commands) const;
  void recordChecks(const vk::raii::CommandBuffer& commands) const;
  /// When that is done.
  void takeChecks();

  /// Predicts pixels, and lists those that are to be marched, for takeList().
  void recordPrediction(const vk::raii::CommandBuffer& commands) const;
  void takeList();

  /// When the listed pixels have been marched. False: that was the last grid.
  bool goOn();

private:
  /// Of the pixels that the present grid adds, but for checked ones, what may be marched.
  double FindShare() const;
  vk::raii::Pipeline MakePipeline(const vk::ShaderModuleCreateInfo& code) const;
  layout::Refinement MakeConstants() const;
  void Record(const vk::raii::CommandBuffer& commands, const vk::raii::Pipeline& pipeline,
    const layout::Refinement& constants, std::uint32_t columns, std::uint32_t rows) const;

  std::shared_ptr<Device> Owner;
  vk::raii::PipelineLayout Layout = nullptr;
  vk::raii::Pipeline Check = nullptr;   // Shaders/CheckPredictions.comp
  vk::raii::Pipeline Predict = nullptr; // Shaders/PredictPixels.comp
  layout::Frame Frame{};                // the picture's
  PredictionLimits Limits;
  double Marched = 0.0;      // pixels so far
  std::uint32_t Spacing = 1; // of the grid
  std::uint32_t Side = 1;    // of its blocks
  float Threshold = 0.0f;
  Input Checked; // list
  Output Checks;
  Buffer ToMarch; // list
  Output Count;
  bool Checking = false; // which of both is listed
  std::uint32_t Listed = 0;
};
}
}

#endif
