// SPDX-License-Identifier: BSD-3-Clause
// Which march a picture takes. Each has a pipeline of its own, so that none pays for what another
// one does.
#ifndef ExaBricksVulkanMarchVariant_h
#define ExaBricksVulkanMarchVariant_h

#include "Core/Medium.h"
#include "Core/View.h"
#include "Vulkan/Traversal.h"

#include <cstdint>
#include <tuple>

namespace exabricks
{
namespace vulkan
{
struct MarchVariant
{
  Traversal traversal = Traversal::KdTree; // RayQuery or KdTree
  Reconstruction reconstruction = Reconstruction::Basis;
  Blending blending = Blending::Composite;
  bool beginsAtDepth = false;      // for views with a nearDepth
  bool shaded = false;             // for views with lighting
  bool scattering = false;         // and for those whose lighting has it
  bool normalsOfOpacity = false;   // and for those whose normals are
  bool ofCells = false;            // it marches from cells to lights, and not through pixels
  bool hasGradientOpacity = false; // where opacity depends on the gradient
  bool clipped = false;            // for views with clipping planes
  bool cropped = false;            // for views with cropping
  bool jittered = false;           // for views whose samples are
  bool showsUndefined = false;     // for views with an undefinedColor
  bool isPart = false;             // for volumes of which a part is drawn
  std::uint32_t components = 1;    // of each cell
  Mixing mixing = Mixing::Independent;
};

inline auto asTuple(const MarchVariant& variant)
{
  return std::make_tuple(variant.traversal, variant.reconstruction, variant.blending,
    variant.beginsAtDepth, variant.shaded, variant.scattering, variant.normalsOfOpacity,
    variant.ofCells, variant.hasGradientOpacity, variant.clipped, variant.cropped, variant.jittered,
    variant.showsUndefined, variant.isPart, variant.components, variant.mixing);
}

inline bool operator<(const MarchVariant& a, const MarchVariant& b)
{
  return asTuple(a) < asTuple(b);
}

inline bool operator==(const MarchVariant& a, const MarchVariant& b)
{
  return asTuple(a) == asTuple(b);
}
}
}

#endif
