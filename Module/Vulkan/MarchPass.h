// SPDX-License-Identifier: BSD-3-Clause
// The compute pass that marches all rays of a picture (Shaders/March.comp).
#ifndef ExaBricksVulkanMarchPass_h
#define ExaBricksVulkanMarchPass_h

#include "Layout.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/MarchPipelines.h"

namespace exabricks
{
namespace vulkan
{
class MarchPass
{
public:
  MarchPass(std::shared_ptr<Device> device, std::shared_ptr<MarchPipelines> pipelines);

  /// Marches one picture. `frame` comes with all that concerns the volume; size, depth and picture
  /// are filled in here.
  void run(const MarchVariant& variant, layout::Frame frame, const View& view,
    std::vector<glm::vec4>& picture);

private:
  std::shared_ptr<Device> Owner;
  std::shared_ptr<MarchPipelines> Pipelines;
  Buffer Constants;
  Buffer Depth;
  Buffer NearDepth;
  Buffer Picture;
};
}
}

#endif
