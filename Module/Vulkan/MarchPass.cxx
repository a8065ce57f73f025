// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/MarchPass.h"

namespace exabricks
{
namespace vulkan
{
void fillView(layout::Frame& frame, const View& view, const glm::dmat4& fromHalfCells)
{
  frame.ndcToHalfCells = fromHalfCells * view.camera.ndcToHalfCells;
  frame.ndcToData = view.camera.ndcToData;
  frame.width = static_cast<std::uint32_t>(view.target.width);
  frame.height = static_cast<std::uint32_t>(view.target.height);
  frame.stepScale = static_cast<float>(view.quality.stepScale);
  frame.inverseUnit = static_cast<float>(1.0 / view.opacityUnitDistance);
  frame.terminationOpacity = static_cast<float>(view.quality.terminationOpacity);
  frame.hasDepth = view.target.depth != nullptr;
}
}
}
