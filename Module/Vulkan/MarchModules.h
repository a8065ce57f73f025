// SPDX-License-Identifier: BSD-3-Clause
// What Shaders/March.comp was compiled to.
#ifndef ExaBricksVulkanMarchModules_h
#define ExaBricksVulkanMarchModules_h

#include "Vulkan/MarchVariant.h"

#include <vulkan/vulkan_raii.hpp>

namespace exabricks
{
namespace vulkan
{
/// The smallest module with the variant in it; `int64`: for devices with integers of 64 bits
/// (Shaders/Buffers.glsl).
vk::ShaderModuleCreateInfo findMarchModule(const MarchVariant& variant, bool int64);
}
}

#endif
