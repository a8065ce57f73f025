// SPDX-License-Identifier: BSD-3-Clause
// The compute pass that marches all rays of a picture (Shaders/March.comp).
#ifndef ExaBricksVulkanMarchPass_h
#define ExaBricksVulkanMarchPass_h

#include "Layout.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/VolumeRenderer.h"

namespace exabricks
{
namespace vulkan
{
class MarchPass
{
public:
  /// `traversal`: RayQuery or KdTree. `program`: may be null, or have no shader.
  /// `beginsAtDepth`: for views with a nearDepth; they and the others have a pass each.
  MarchPass(std::shared_ptr<Device> device, Traversal traversal, Reconstruction reconstruction,
    bool beginsAtDepth, const MarchProgram* program);

  Traversal traversal() const { return this->How; }
  Reconstruction reconstruction() const { return this->Field; }

  /// Marches one picture. `frame` comes with all that concerns the volume; size, depth and picture
  /// are filled in here.
  void run(layout::Frame frame, const View& view, std::vector<glm::vec4>& picture);

private:
  std::shared_ptr<Device> Owner;
  Traversal How;
  Reconstruction Field;
  vk::raii::PipelineLayout Layout = nullptr;
  vk::raii::Pipeline Pipeline = nullptr;
  Buffer Constants;
  Buffer Depth;
  Buffer NearDepth;
  Buffer Picture;
};
}
}

#endif
