// SPDX-License-Identifier: BSD-3-Clause
// What is cut away of a volume before it is drawn: rays have nothing of it, wherever the cut goes
// through cells and steps.
#ifndef ExaBricksCoreCutaway_h
#define ExaBricksCoreCutaway_h

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

namespace exabricks
{
/// Two planes across each axis divide space into 27 regions, of which some are shown.
struct Cropping
{
  static constexpr std::uint32_t AllRegions = (1u << 27) - 1;

  glm::dvec3 lower{ 0.0 };
  glm::dvec3 upper{ 0.0 }; // where it is less than lower, there is nothing between the two
  /// Bit x + 3 y + 9 z: x is 0 below the lower plane, 1 between the two, and 2 from the upper one
  /// on.
  std::uint32_t shownRegions = AllRegions;
};

/// In half cells from the lower corner of the data's bounds, as the Camera of a View.
struct Cutaway
{
  static constexpr std::size_t MostClippingPlanes = 32;

  /// A place p is left where dot(plane, (p, 1)) >= 0 for each of them; xyz of none is 0.
  std::vector<glm::dvec4> clippingPlanes;
  std::optional<Cropping> cropping;
};

inline bool operator==(const Cropping& a, const Cropping& b)
{
  return a.lower == b.lower && a.upper == b.upper && a.shownRegions == b.shownRegions;
}

inline bool operator==(const Cutaway& a, const Cutaway& b)
{
  return a.clippingPlanes == b.clippingPlanes && a.cropping == b.cropping;
}
}

#endif
