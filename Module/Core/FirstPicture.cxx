// SPDX-License-Identifier: BSD-3-Clause
#include "Core/FirstPicture.h"

#include "Core/OpacityChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace exabricks
{
namespace
{
constexpr int HistogramBins = 512;
constexpr int PlaceBins = 512; // along an axis of the bounds
constexpr double MostDecades = 8.0;
constexpr double AsideShare = 0.01; // of what shows, at each end of an axis
constexpr double Margin = 0.03;     // around what shows, of its size
constexpr double MeanOpticalDepth = 1.2;
constexpr double MeanBrightness = 0.25;   // of sums along a ray
constexpr double LargestExtinction = 5.0; // of the unit distance: opacity 0.993
constexpr double SmallestExtinction = 0.02;

// Of values, normalised, to places in the range that shows.
struct Mapping
{
  double from = 0.0; // normalised
  bool constant = false;

  double operator()(float normalized) const
  {
    return this->constant
      ? 0.5
      : std::clamp((static_cast<double>(normalized) - this->from) / (1.0 - this->from), 0.0, 1.0);
  }
};

std::vector<std::uint64_t> makeHistogram(const Values& values, const Mapping& toPlace)
{
  std::vector<std::uint64_t> cells(HistogramBins, 0);
  for (const float value : values.normalized)
  {
    if (value >= 0.0f)
    {
      const int bin = static_cast<int>(toPlace(value) * HistogramBins);
      ++cells[static_cast<std::size_t>(std::min(bin, HistogramBins - 1))];
    }
  }
  return cells;
}

// How much of what shows is where along each axis of the bounds, [axis][bin].
using Profiles = std::array<std::vector<double>, 3>;

// Spreads `amount` evenly from the one place of an axis, in bins, to the other.
void spread(std::vector<double>& profile, double from, double to, double amount)
{
  const int first = std::clamp(static_cast<int>(from), 0, PlaceBins - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(to)), first + 1, PlaceBins);
  for (int bin = first; bin < last; ++bin)
  {
    const double part = std::min<double>(bin + 1, to) - std::max<double>(bin, from);
    profile[static_cast<std::size_t>(bin)] += amount * std::max(part, 0.0) / (to - from);
  }
}

// Calls `f(cell, value)` of all cells of a brick that have a value.
template <typename F>
void forEachCell(const Volume& volume, std::size_t brick, const F& f)
{
  const glm::ivec3 n = volume.structure->bricks[brick].cells;
  const float* value = volume.values->ofBrick(brick);
  for (int z = 0; z < n.z; ++z)
  {
    for (int y = 0; y < n.y; ++y)
    {
      for (int x = 0; x < n.x; ++x, ++value)
      {
        if (*value >= 0.0f)
        {
          f(glm::ivec3(x, y, z), *value);
        }
      }
    }
  }
}

Profiles makeProfiles(const Volume& volume, const Interest& interest, const Mapping& toPlace)
{
  Profiles profiles;
  profiles.fill(std::vector<double>(PlaceBins, 0.0));
  const Structure& structure = *volume.structure;
  const Box& bounds = structure.tree.bounds;
  const glm::dvec3 binsPerCell = double(PlaceBins) / glm::dvec3(bounds.hi - bounds.lo);
  for (std::size_t index = 0; index < structure.bricks.size(); ++index)
  {
    const Brick& brick = structure.bricks[index];
    const auto width = static_cast<double>(structure.width(brick));
    std::array<std::vector<double>, 3> layers;
    for (int axis = 0; axis < 3; ++axis)
    {
      layers[axis].assign(static_cast<std::size_t>(brick.cells[axis]), 0.0);
    }
    forEachCell(volume, index,
      [&](const glm::ivec3& cell, float value)
      {
        const double amount = interest.at(toPlace(value)) * width * width * width;
        for (int axis = 0; axis < 3; ++axis)
        {
          layers[axis][static_cast<std::size_t>(cell[axis])] += amount;
        }
      });
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto begin = static_cast<double>(brick.lo[axis] - bounds.lo[axis]);
      for (int cell = 0; cell < brick.cells[axis]; ++cell)
      {
        spread(profiles[axis], (begin + width * cell) * binsPerCell[axis],
          (begin + width * (cell + 1)) * binsPerCell[axis],
          layers[axis][static_cast<std::size_t>(cell)]);
      }
    }
  }
  return profiles;
}

// The ends, in [0, 1] of the axis, of what is left without so much at either of them.
std::array<double, 2> findEnds(const std::vector<double>& profile)
{
  const double total = std::accumulate(profile.begin(), profile.end(), 0.0);
  if (!(total > 0.0))
  {
    return { 0.0, 1.0 };
  }
  std::array<double, 2> ends{ 0.0, 1.0 };
  double sum = 0.0;
  bool begun = false;
  for (std::size_t bin = 0; bin < profile.size(); ++bin)
  {
    sum += profile[bin];
    if (!begun && sum > AsideShare * total)
    {
      ends[0] = static_cast<double>(bin) / PlaceBins;
      begun = true;
    }
    if (sum >= (1.0 - AsideShare) * total)
    {
      ends[1] = static_cast<double>(bin + 1) / PlaceBins;
      break;
    }
  }
  const double margin = Margin * (ends[1] - ends[0]);
  return { std::max(ends[0] - margin, 0.0), std::min(ends[1] + margin, 1.0) };
}

// Mean over the volume of the cells in a box, half cells.
double meanInterest(const Volume& volume, const Interest& interest, const Mapping& toPlace,
  const glm::dvec3& lo, const glm::dvec3& hi)
{
  double shown = 0.0;
  double all = 0.0;
  const Structure& structure = *volume.structure;
  for (std::size_t index = 0; index < structure.bricks.size(); ++index)
  {
    const Brick& brick = structure.bricks[index];
    const auto width = static_cast<double>(structure.width(brick));
    const double size = width * width * width;
    const glm::dvec3 corner(brick.lo - structure.tree.bounds.lo);
    forEachCell(volume, index,
      [&](const glm::ivec3& cell, float value)
      {
        const glm::dvec3 middle = 2.0 * (corner + width * (glm::dvec3(cell) + 0.5));
        if (glm::all(glm::greaterThanEqual(middle, lo)) && glm::all(glm::lessThan(middle, hi)))
        {
          shown += size * interest.at(toPlace(value));
          all += size;
        }
      });
  }
  return all > 0.0 ? shown / all : 0.0;
}
}

bool wantsLogarithm(const Values& values)
{
  if (!(values.range.min > 0.0) || !(values.range.max > 100.0 * values.range.min))
  {
    return false;
  }
  const double size = values.range.max - values.range.min;
  const auto limit = static_cast<float>((0.01 * values.range.max - values.range.min) / size);
  std::uint64_t small = 0;
  std::uint64_t all = 0;
  for (const float value : values.normalized)
  {
    small += value >= 0.0f && value < limit ? 1 : 0;
    all += value >= 0.0f ? 1 : 0;
  }
  return static_cast<double>(small) >= 0.9 * static_cast<double>(all);
}

namespace
{
// Opacities of the unit distance whose extinction is so many times the interest.
std::vector<OpacityPoint> makeOpacity(
  const Range& colors, const Interest& interest, double extinction)
{
  std::vector<OpacityPoint> opacity;
  const std::vector<double>& points = interest.points;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    // Between equal neighbours a point says nothing.
    if (p > 0 && p + 1 < points.size() && points[p] == points[p - 1] && points[p] == points[p + 1])
    {
      continue;
    }
    const double part = static_cast<double>(p) / static_cast<double>(points.size() - 1);
    const double value = (1.0 - part) * colors.min + part * colors.max;
    opacity.push_back({ value, 1.0 - std::exp(-extinction * points[p]) });
  }
  return opacity;
}

// Whether the part in which rare values are is looked at, or all that there is.
bool framesWhatShows(Blending blending)
{
  return blending == Blending::Composite || blending == Blending::Isosurface;
}
}

FirstPicture chooseFirstPicture(
  const Volume& volume, const glm::dvec3& spacing, bool logarithmic, Blending blending)
{
  FirstPicture picture;
  picture.colors = volume.values->range;
  const double size = picture.colors.max - picture.colors.min;
  Mapping toPlace;
  toPlace.constant = !(size > 0.0);
  if (logarithmic && std::isfinite(size) && size > MostDecades)
  {
    toPlace.from = 1.0 - MostDecades / size;
    picture.colors.min = picture.colors.max - MostDecades;
  }
  const Interest interest = chooseInterest(makeHistogram(*volume.values, toPlace), !logarithmic);
  picture.hi = glm::dvec3(volume.structure->tree.size);
  if (!toPlace.constant && framesWhatShows(blending))
  {
    const Profiles profiles = makeProfiles(volume, interest, toPlace);
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::array<double, 2> ends = findEnds(profiles[axis]);
      picture.lo[axis] = ends[0] * volume.structure->tree.size[axis];
      picture.hi[axis] = ends[1] * volume.structure->tree.size[axis];
    }
  }
  const glm::dvec3 shown = 0.5 * spacing * (picture.hi - picture.lo);
  picture.unitDistance = 0.01 * glm::length(shown);
  // The mean of a convex body is four times its volume by its surface (Cauchy).
  const double meanPath = 2.0 / (1.0 / shown.x + 1.0 / shown.y + 1.0 / shown.z);
  if (blending != Blending::Composite)
  {
    const double least = blending == Blending::Maximum && !toPlace.constant ? 0.0 : 1.0;
    picture.opacity = { { picture.colors.min, least }, { picture.colors.max, 1.0 } };
    if (blending == Blending::Additive)
    {
      const double mean =
        meanInterest(volume, Interest{ { 0.0, 1.0 } }, Mapping(), picture.lo, picture.hi);
      picture.unitDistance = mean > 0.0 ? mean * meanPath / MeanBrightness : picture.unitDistance;
    }
    return picture;
  }
  const double units = meanPath / picture.unitDistance;
  if (toPlace.constant)
  {
    picture.opacity = { { picture.colors.min, 1.0 - std::exp(-MeanOpticalDepth / units) } };
    return picture;
  }
  const double mean = meanInterest(volume, interest, toPlace, picture.lo, picture.hi);
  const double extinction = std::clamp(
    MeanOpticalDepth / (units * std::max(mean, 1e-12)), SmallestExtinction, LargestExtinction);
  picture.opacity = makeOpacity(picture.colors, interest, extinction);
  return picture;
}
}
