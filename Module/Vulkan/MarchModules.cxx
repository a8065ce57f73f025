// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/MarchModules.h"

#include "MarchKdTreeComponentsInt64Spirv.h"
#include "MarchKdTreeComponentsShadowsInt64Spirv.h"
#include "MarchKdTreeComponentsShadowsSpirv.h"
#include "MarchKdTreeComponentsSpirv.h"
#include "MarchKdTreeCompositeInt64Spirv.h"
#include "MarchKdTreeCompositeShadowsInt64Spirv.h"
#include "MarchKdTreeCompositeShadowsSpirv.h"
#include "MarchKdTreeCompositeSpirv.h"
#include "MarchKdTreeInt64Spirv.h"
#include "MarchKdTreeProjectionInt64Spirv.h"
#include "MarchKdTreeProjectionSpirv.h"
#include "MarchKdTreeSpirv.h"
#include "MarchKdTreeSurfaceInt64Spirv.h"
#include "MarchKdTreeSurfaceSpirv.h"
#include "MarchRayQueryComponentsInt64Spirv.h"
#include "MarchRayQueryComponentsShadowsInt64Spirv.h"
#include "MarchRayQueryComponentsShadowsSpirv.h"
#include "MarchRayQueryComponentsSpirv.h"
#include "MarchRayQueryCompositeInt64Spirv.h"
#include "MarchRayQueryCompositeShadowsInt64Spirv.h"
#include "MarchRayQueryCompositeShadowsSpirv.h"
#include "MarchRayQueryCompositeSpirv.h"
#include "MarchRayQueryInt64Spirv.h"
#include "MarchRayQueryProjectionInt64Spirv.h"
#include "MarchRayQueryProjectionSpirv.h"
#include "MarchRayQuerySpirv.h"
#include "MarchRayQuerySurfaceInt64Spirv.h"
#include "MarchRayQuerySurfaceSpirv.h"

#include <cstddef>
#include <cstdint>

namespace exabricks
{
namespace vulkan
{
namespace
{
struct Words
{
  template <std::size_t N>
  constexpr Words(const std::uint32_t (&words)[N])
    : begin(words)
    , bytes(sizeof(words))
  {
  }
  const std::uint32_t* begin;
  std::size_t bytes;
};

// By traversal, and without and with integers of 64 bits.
struct Family
{
  Words kdTree;
  Words kdTreeInt64;
  Words rayQuery;
  Words rayQueryInt64;
};

// Shaders/Variant.glsl
const Family plain{ MarchKdTreeSpirv, MarchKdTreeInt64Spirv, MarchRayQuerySpirv,
  MarchRayQueryInt64Spirv };
const Family composite{ MarchKdTreeCompositeSpirv, MarchKdTreeCompositeInt64Spirv,
  MarchRayQueryCompositeSpirv, MarchRayQueryCompositeInt64Spirv };
const Family components{ MarchKdTreeComponentsSpirv, MarchKdTreeComponentsInt64Spirv,
  MarchRayQueryComponentsSpirv, MarchRayQueryComponentsInt64Spirv };
const Family compositeShadows{ MarchKdTreeCompositeShadowsSpirv,
  MarchKdTreeCompositeShadowsInt64Spirv, MarchRayQueryCompositeShadowsSpirv,
  MarchRayQueryCompositeShadowsInt64Spirv };
const Family componentsShadows{ MarchKdTreeComponentsShadowsSpirv,
  MarchKdTreeComponentsShadowsInt64Spirv, MarchRayQueryComponentsShadowsSpirv,
  MarchRayQueryComponentsShadowsInt64Spirv };
const Family projection{ MarchKdTreeProjectionSpirv, MarchKdTreeProjectionInt64Spirv,
  MarchRayQueryProjectionSpirv, MarchRayQueryProjectionInt64Spirv };
const Family surface{ MarchKdTreeSurfaceSpirv, MarchKdTreeSurfaceInt64Spirv,
  MarchRayQuerySurfaceSpirv, MarchRayQuerySurfaceInt64Spirv };

const Family& familyOf(const MarchVariant& variant)
{
  const bool isMixed = variant.components > 1 || variant.mixing == Mixing::Planar;
  if (variant.ofCells)
  {
    return isMixed ? componentsShadows : compositeShadows;
  }
  if (isMixed && variant.blending != Blending::Isosurface)
  {
    return components;
  }
  switch (variant.blending)
  {
    case Blending::Composite:
      return variant.shaded || variant.hasGradientOpacity || variant.clipped || variant.cropped ||
          variant.jittered || variant.showsUndefined || variant.isPart
        ? composite
        : plain;
    case Blending::Isosurface:
    case Blending::Slice:
      return surface;
    default:
      return projection;
  }
}
}

vk::ShaderModuleCreateInfo findMarchModule(const MarchVariant& variant, bool int64)
{
  const Family& family = familyOf(variant);
  const Words& words = variant.traversal == Traversal::RayQuery
    ? (int64 ? family.rayQueryInt64 : family.rayQuery)
    : (int64 ? family.kdTreeInt64 : family.kdTree);
  return { {}, words.bytes, words.begin };
}
}
}
