// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/FirstSeen.h"

#include "Core/DepthRange.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace
{
// Differences of less than half a step of 8-bit colours do not show.
constexpr float HalfAColorStep = 0.5f / 255.0f;

// A camera whose pixels all look along the line, with depths that go evenly from its one end to the
// other.
glm::dmat4 lookAlong(const LineOfSight& line)
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

// How far behind the place the cell is looked for. Faces are found in single precision
// (Shaders/Ray.glsl, behindFace()). Half cells.
double wayInto(double length) { return std::max(1e-3, 1e-6 * length); }

// The depth at which a pixel first sees something, by halves of what is left.
struct Search
{
  explicit Search(float end)
    : behind(end)
  {
  }

  float middle() const { return static_cast<float>(0.5 * (this->before + this->behind)); }
  void halve(bool inNearerHalf) { (inNearerHalf ? this->behind : this->before) = this->middle(); }

  double before = 0.0;
  double behind;
  bool seen = false;       // whether anything is
  glm::vec4 whole{ 0.0f }; // what all of the ray shows
};

// Renders between two depths of each pixel that sees something, none elsewhere.
template <typename From, typename To>
std::string renderBetween(VolumeRenderer& renderer, View& view, const std::vector<Search>& pixels,
  const From& from, const To& to, std::vector<glm::vec4>& picture)
{
  std::vector<float> begins(pixels.size(), 0.0f);
  std::vector<float> ends(pixels.size(), 0.0f);
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    if (pixels[i].seen)
    {
      begins[i] = static_cast<float>(from(pixels[i]));
      ends[i] = static_cast<float>(to(pixels[i]));
    }
  }
  view.target.nearDepth = begins.data();
  view.target.depth = ends.data();
  const std::string fault = renderer.render(view, picture);
  view.target.nearDepth = nullptr;
  view.target.depth = nullptr;
  return fault;
}

float difference(const glm::vec4& a, const glm::vec4& b)
{
  const glm::vec4 off = glm::abs(a - b);
  return std::max({ off.r, off.g, off.b, off.a });
}

// Where the opacity from the viewer on comes to `opacity`. Rays are drawn from their beginnings on,
// so that their samples are those of the whole rays.
std::string searchOpacity(
  VolumeRenderer& renderer, View& view, double opacity, int halvings, std::vector<Search>& pixels)
{
  std::vector<glm::vec4> picture;
  for (int halving = 0; halving < halvings; ++halving)
  {
    const std::string fault = renderBetween(
      renderer, view, pixels, [](const Search&) { return 0.0f; },
      [](const Search& pixel) { return pixel.middle(); }, picture);
    if (!fault.empty() || picture.empty())
    {
      return fault;
    }
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      pixels[i].halve(picture[i].a >= static_cast<float>(opacity));
    }
  }
  return {};
}

// Where the value is that the whole ray shows: in the half whose extremum looks more like it, as
// halves have other samples than the whole.
std::string searchExtremum(
  VolumeRenderer& renderer, View& view, int halvings, std::vector<Search>& pixels)
{
  std::vector<glm::vec4> nearer;
  std::vector<glm::vec4> farther;
  for (int halving = 0; halving < halvings; ++halving)
  {
    const auto before = [](const Search& pixel) { return pixel.before; };
    const auto middle = [](const Search& pixel) { return pixel.middle(); };
    const auto behind = [](const Search& pixel) { return pixel.behind; };
    std::string fault = renderBetween(renderer, view, pixels, before, middle, nearer);
    if (fault.empty())
    {
      fault = renderBetween(renderer, view, pixels, middle, behind, farther);
    }
    if (!fault.empty() || nearer.empty() || farther.empty())
    {
      return fault;
    }
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      const glm::vec4& whole = pixels[i].whole;
      pixels[i].halve(
        difference(nearer[i], whole) <= std::max(HalfAColorStep, difference(farther[i], whole)));
    }
  }
  return {};
}

// Of each pixel; nothing where the picture was given up or failed.
std::vector<Search> search(
  VolumeRenderer& renderer, View& view, double opacity, int halvings, std::string& fault)
{
  const bool isExtremum = view.blending == Blending::Maximum || view.blending == Blending::Minimum;
  if (!isExtremum)
  {
    view.quality.terminationOpacity = opacity; // what is behind the place does not count
  }
  std::vector<glm::vec4> picture;
  fault = renderer.render(view, picture);
  if (!fault.empty() || picture.empty())
  {
    return {};
  }
  std::vector<Search> pixels;
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    pixels.emplace_back(view.target.depth ? view.target.depth[i] : 1.0f);
    pixels.back().whole = picture[i];
    pixels.back().seen = picture[i].a >= static_cast<float>(opacity);
  }
  fault = isExtremum ? searchExtremum(renderer, view, halvings, pixels)
                     : searchOpacity(renderer, view, opacity, halvings, pixels);
  return fault.empty() ? pixels : std::vector<Search>();
}

// The camera with its near and far planes at the bounds, and as many depths with it.
void tightenDepths(View& view, const glm::dvec3& size, std::vector<float>& depths)
{
  const DepthRange bounds = findDepthRange(view.camera.ndcToHalfCells, size);
  const double from = bounds.allBeforeEye ? std::clamp(bounds.from, -1.0, 1.0) : -1.0;
  const double to = std::clamp(bounds.to, from, 1.0);
  if (!(to > from))
  {
    return;
  }
  glm::dmat4 toNdc(1.0);
  toNdc[2].z = 0.5 * (to - from);
  toNdc[3].z = 0.5 * (to + from);
  view.camera.ndcToHalfCells = view.camera.ndcToHalfCells * toNdc;
  for (float& depth : depths)
  {
    depth = static_cast<float>(std::clamp((2.0 * depth - 1.0 - from) / (to - from), 0.0, 1.0));
  }
}
}

PlaceInPicture middleOfPixel(const View& view, std::size_t i)
{
  const auto width = static_cast<std::size_t>(view.target.width);
  const glm::dvec2 pixel(static_cast<double>(i % width), static_cast<double>(i / width));
  return { view.target.width, view.target.height,
    (2.0 * pixel + 1.0) / glm::dvec2(view.target.width, view.target.height) - 1.0 };
}

std::optional<LineOfSight> findLine(
  const View& view, const PlaceInPicture& place, const glm::dvec3& size)
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
  return begin < end ? std::make_optional(LineOfSight{ near + begin * way, near + end * way })
                     : std::nullopt;
}

std::optional<FirstSeen> findFirstSeen(VolumeRenderer& renderer, View view,
  const PlaceInPicture& place, const glm::dvec3& size, double opacity, std::string& fault)
{
  const std::optional<LineOfSight> line = findLine(view, place, size);
  if (!line)
  {
    return std::nullopt;
  }
  keepWhole(view);
  view.camera.ndcToHalfCells = lookAlong(*line);
  view.target.width = 1;
  view.target.height = 1;
  view.target.depth = nullptr;
  const std::vector<Search> pixels = search(renderer, view, opacity, 24, fault);
  if (pixels.empty() || !pixels.front().seen)
  {
    return std::nullopt;
  }
  const double length = glm::length(line->to - line->from);
  const double ahead = pixels.front().behind + wayInto(length) / length;
  const auto at = [&](double part) { return line->from + part * (line->to - line->from); };
  return FirstSeen{ at(pixels.front().behind), at(std::min(ahead, 1.0 - 1e-12)) };
}

std::vector<std::optional<FirstSeen>> findFirstSeen(
  VolumeRenderer& renderer, View view, const glm::dvec3& size, double opacity, std::string& fault)
{
  keepWhole(view);
  std::vector<float> depths(static_cast<std::size_t>(view.target.width) * view.target.height, 1.0f);
  if (view.target.depth)
  {
    std::copy_n(view.target.depth, depths.size(), depths.begin());
  }
  tightenDepths(view, size, depths);
  view.target.depth = depths.data();
  const std::vector<Search> pixels = search(renderer, view, opacity, 20, fault);
  std::vector<std::optional<FirstSeen>> found(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    if (pixels[i].seen)
    {
      const glm::dvec2 ndc = middleOfPixel(view, i).ndc;
      const auto at = [&](double depth)
      {
        const glm::dvec4 place =
          view.camera.ndcToHalfCells * glm::dvec4(ndc, 2.0 * depth - 1.0, 1.0);
        return glm::dvec3(place) / place.w;
      };
      const glm::dvec3 way = at(1.0) - at(0.0);
      const double length = glm::length(way);
      const glm::dvec3 place = at(pixels[i].behind);
      const glm::dvec3 ahead = place + wayInto(length) / length * way;
      found[i] = FirstSeen{ place, glm::clamp(ahead, glm::dvec3(0.0), size * (1.0 - 1e-12)) };
    }
  }
  return found;
}
}
