// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/FirstSeen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace exabricks
{
namespace
{
// Differences of less than half a step of 8-bit colours do not show: steps are others where a line
// ends elsewhere, and extremes between them are found to second order.
constexpr float HalfAColorStep = 0.5f / 255.0f;

struct Line
{
  glm::dvec3 from; // half cells
  glm::dvec3 to;
};

// The part of the place's line of sight that is in the bounds.
std::optional<Line> findLine(const View& view, const PlaceInPicture& place, const glm::dvec3& size)
{
  const auto unproject = [&](double depth)
  {
    const glm::dvec4 at =
      view.camera.ndcToHalfCells * glm::dvec4(place.ndc, 2.0 * depth - 1.0, 1.0);
    return glm::dvec3(at) / at.w;
  };
  const glm::dvec3 near = unproject(0.0);
  const glm::dvec3 way = unproject(place.depth) - near;
  double begin = 0.0;
  double end = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = (0.0 - near[axis]) / way[axis];
    const double second = (size[axis] - near[axis]) / way[axis];
    if (way[axis] != 0.0)
    {
      begin = std::max(begin, std::min(first, second));
      end = std::min(end, std::max(first, second));
    }
    else if (near[axis] < 0.0 || near[axis] > size[axis])
    {
      return std::nullopt;
    }
  }
  return begin < end ? std::make_optional(Line{ near + begin * way, near + end * way })
                     : std::nullopt;
}

// A camera whose pixels all look along the line, with depths that go evenly from its one end to the
// other.
glm::dmat4 lookAlong(const Line& line)
{
  const glm::dvec3 half = 0.5 * (line.to - line.from);
  const glm::dvec3 aside =
    std::abs(half.x) < std::abs(half.y) ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  // So narrow that all pixels are on the line, but for rounding.
  const double width = 1e-9 * glm::length(half);
  const glm::dvec3 x = width * glm::normalize(glm::cross(half, aside));
  const glm::dvec3 y = width * glm::normalize(glm::cross(half, x));
  return { glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(half, 0.0),
    glm::dvec4(line.from + half, 1.0) };
}
}

std::optional<FirstSeen> findFirstSeen(VolumeRenderer& renderer, View view,
  const PlaceInPicture& place, const glm::dvec3& size, double opacity, std::string& fault)
{
  const std::optional<Line> line = findLine(view, place, size);
  if (!line)
  {
    return std::nullopt;
  }
  view.quality.terminationOpacity = std::max(view.quality.terminationOpacity, opacity);
  keepWhole(view);
  view.camera.ndcToHalfCells = lookAlong(*line);
  // Each pixel ends at a depth of its own: a search among 64 at a time.
  std::array<float, 64> depths;
  view.target.width = static_cast<int>(depths.size());
  view.target.height = 1;
  view.target.depth = depths.data();
  view.target.nearDepth = nullptr;
  const bool isExtremum = view.blending == Blending::Maximum || view.blending == Blending::Minimum;
  glm::vec4 whole(0.0f); // what the whole line looks like
  const auto seen = [&](const glm::vec4& pixel)
  {
    const glm::vec4 off = glm::abs(pixel - whole);
    return pixel.a >= static_cast<float>(opacity) &&
      (!isExtremum || std::max({ off.r, off.g, off.b, off.a }) <= HalfAColorStep);
  };
  double before = 0.0;
  double behind = 1.0;
  for (int round = 0; round < 4; ++round)
  {
    const double piece = (behind - before) / static_cast<double>(depths.size());
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      depths[i] = static_cast<float>(before + piece * static_cast<double>(i + 1));
    }
    std::vector<glm::vec4> picture;
    fault = renderer.render(view, picture);
    if (!fault.empty() || picture.empty())
    {
      return std::nullopt;
    }
    whole = round == 0 ? picture.back() : whole;
    const auto first = std::find_if(picture.begin(), picture.end(), seen);
    if (first == picture.end())
    {
      if (round == 0)
      {
        return std::nullopt;
      }
      break; // by rounding
    }
    behind = depths[static_cast<std::size_t>(first - picture.begin())];
    before = std::max(before, behind - piece);
  }
  // Faces are found in single precision (Shaders/Ray.glsl, behindFace()).
  const double length = glm::length(line->to - line->from);
  const double ahead = behind + std::max(1e-3, 1e-6 * length) / length;
  const auto at = [&](double part) { return line->from + part * (line->to - line->from); };
  return FirstSeen{ at(behind), at(std::min(ahead, 1.0 - 1e-12)) };
}
}
