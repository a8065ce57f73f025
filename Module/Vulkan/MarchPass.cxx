// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/MarchPass.h"

#include "Core/DepthRange.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace exabricks
{
namespace vulkan
{
namespace
{
layout::Pair makePair(double value)
{
  // Volatile, as gcc 12 takes a double for its own float where it vectorises: low was 0.
  const volatile float high = static_cast<float>(value);
  return { high, static_cast<float>(value - high) };
}

layout::Pair4 makePair(const glm::dvec4& value)
{
  layout::Pair4 result;
  for (int i = 0; i < 4; ++i)
  {
    const layout::Pair pair = makePair(value[i]);
    result.high[i] = pair.high;
    result.low[i] = pair.low;
  }
  return result;
}

struct Depths
{
  double first = -1.0;
  double second = 1.0;
};

// Two depths, in normalised device coordinates, that bracket bounds of this size: those of the near
// and the far plane, or nearer ones where all of the bounds is before the eye.
Depths findDepths(const glm::dmat4& ndcToHalfCells, const glm::dvec3& size)
{
  const DepthRange range = findDepthRange(ndcToHalfCells, size);
  if (!range.allBeforeEye || !(range.from > -1e6 && range.to < 1e6))
  {
    return {};
  }
  Depths depths{ range.from, range.to };
  // Depths that are closer together than this are not told apart well enough.
  const double slack = 0.01 * std::max(depths.second - depths.first, 1e-6);
  depths.first = std::max(depths.first - slack, -1.0);
  depths.second = std::min(depths.second + slack, 1.0);
  // Where nothing of the bounds is between the planes, any depths do.
  return depths.first < depths.second ? depths : Depths();
}

// Shadows reach so many times the bounds' size, by a number in [0, 1], as of VTK's GPU mapper.
float findShadowReach(double reach)
{
  constexpr double beyondAll = 4.0; // the diagonal is less than twice as long as each side
  return static_cast<float>(
    reach < 1.0 ? std::sqrt(3.0) * (1.0 - std::pow(1.0 - reach, 0.33)) : beyondAll);
}

// `toWorld`: linear, from half cells. `corner`: where the lower corner of the data's bounds is in
// half cells.
void fillLighting(layout::Frame& frame, const Lighting& lighting, const glm::dmat3& toWorld,
  const glm::dvec3& corner)
{
  for (std::size_t k = 0; k < lighting.materials.size(); ++k)
  {
    const Material& from = lighting.materials[k];
    frame.materials[k] = { static_cast<float>(from.ambient), static_cast<float>(from.diffuse),
      static_cast<float>(from.specular), static_cast<float>(from.specularPower) };
  }
  frame.twoSided = lighting.twoSided;
  frame.halfCellsToWorldX = toWorld[0];
  frame.halfCellsToWorldY = toWorld[1];
  frame.halfCellsToWorldZ = toWorld[2];
  // Gradients are covectors. Only their direction is asked for.
  const glm::dmat3 covector = glm::transpose(glm::inverse(toWorld));
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      largest = std::max(largest, std::abs(covector[column][row]));
    }
  }
  frame.gradientToWorldX = covector[0] / largest;
  frame.gradientToWorldY = covector[1] / largest;
  frame.gradientToWorldZ = covector[2] / largest;
  const glm::dmat3 toHalfCells = glm::inverse(toWorld);
  frame.lightCount =
    static_cast<std::uint32_t>(std::min<std::size_t>(lighting.lights.size(), layout::MOST_LIGHTS));
  for (std::uint32_t i = 0; i < frame.lightCount; ++i)
  {
    const Light& from = lighting.lights[i];
    layout::Light& to = frame.lights[i];
    to.direction = from.direction;
    to.diffuse = from.diffuse;
    to.specular = from.specular;
    to.positional = from.positional;
    to.position = from.position + toWorld * corner;
    to.inHalfCells = from.positional ? toHalfCells * from.position + corner
                                     : glm::normalize(toHalfCells * -from.direction);
    to.attenuation = from.attenuation;
    to.cosineOfCone =
      from.coneAngle > 90.0 ? -1.0f : static_cast<float>(std::cos(glm::radians(from.coneAngle)));
    to.exponent = static_cast<float>(from.exponent);
  }
  if (lighting.scattering)
  {
    frame.scatteringBlending = static_cast<float>(lighting.scattering->blending);
    // Of 1 all light would go on in one direction, which no eye is in.
    frame.scatteringAnisotropy =
      static_cast<float>(std::clamp(lighting.scattering->anisotropy, -0.99, 0.99));
    frame.shadowReach = findShadowReach(lighting.scattering->reach);
  }
}

static_assert(Cutaway::MostClippingPlanes == layout::MOST_CLIPPING_PLANES, "a frame has room");

// A plane of half cells, of a normal of length 1.
layout::Pair4 toPlane(const glm::dvec4& plane, const glm::dmat4& toHalfCells)
{
  glm::dvec4 result = plane * glm::inverse(toHalfCells);
  result /= glm::length(glm::dvec3(result));
  // So far off it cuts no bounds, wherever it is; and products of floats stay in their range.
  result.w = std::clamp(result.w, -1e12, 1e12);
  return makePair(result);
}

void fillCutaway(layout::Frame& frame, const Cutaway& cutaway, const glm::dmat4& fromHalfCells)
{
  frame.clippingPlaneCount = 0;
  for (const glm::dvec4& plane : cutaway.clippingPlanes)
  {
    frame.clippingPlanes[frame.clippingPlaneCount++] = toPlane(plane, fromHalfCells);
  }
  if (cutaway.cropping)
  {
    // Lattices have common axes. Beside the bounds, planes at any distance, also at infinity,
    // divide them the same way.
    const glm::dvec3 scale(fromHalfCells[0].x, fromHalfCells[1].y, fromHalfCells[2].z);
    const auto toPlanes = [&](const glm::dvec3& planes)
    {
      const glm::dvec3 there = scale * planes + glm::dvec3(fromHalfCells[3]);
      const glm::dvec3 beside = glm::clamp(there, glm::dvec3(-1.0), glm::dvec3(frame.size) + 1.0);
      return makePair(glm::dvec4(beside, 0.0));
    };
    frame.croppingLower = toPlanes(cutaway.cropping->lower);
    frame.croppingUpper = toPlanes(glm::max(cutaway.cropping->lower, cutaway.cropping->upper));
    frame.shownRegions = cutaway.cropping->shownRegions;
  }
}
}

void MarchPass::recordList(const vk::raii::CommandBuffer& commands, const layout::Band& band) const
{
  // Groups in a square, as a device may take less than 65536 of them along an axis.
  const std::uint32_t groups = (band.count + TileSize * TileSize - 1) / (TileSize * TileSize);
  const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(groups)));
  this->record(commands, band, columns * TileSize, (groups + columns - 1) / columns * TileSize);
}

void fillView(layout::Frame& frame, const View& view, const glm::dmat4& fromHalfCells)
{
  const glm::dmat4 ndcToHalfCells = fromHalfCells * view.camera.ndcToHalfCells;
  const Depths depths = findDepths(ndcToHalfCells, glm::dvec3(frame.size));
  const glm::dvec4 middle = ndcToHalfCells * glm::dvec4(0.0, 0.0, depths.first, 1.0);
  // Homogeneous coordinates may be of any size: these are about 1.
  const double scale = 1.0 / middle.w;
  frame.first = makePair(scale * middle);
  frame.second = makePair(scale * (ndcToHalfCells * glm::dvec4(0.0, 0.0, depths.second, 1.0)));
  frame.perColumn = makePair(ndcToHalfCells[0] * (scale * 2.0 / view.target.width));
  frame.perRow = makePair(ndcToHalfCells[1] * (scale * 2.0 / view.target.height));
  frame.firstDepth = makePair(depths.first);
  frame.inverseDepths = makePair(1.0 / (depths.second - depths.first));
  const glm::dmat3 toData = view.camera.halfCellsToData * glm::inverse(glm::dmat3(fromHalfCells));
  // In unit distances, as lengths in the data's coordinates may be beyond the range of floats.
  const glm::dmat3 toUnits = toData * (1.0 / view.opacityUnitDistance);
  frame.halfCellsToUnitsX = toUnits[0];
  frame.halfCellsToUnitsY = toUnits[1];
  frame.halfCellsToUnitsZ = toUnits[2];
  const glm::dvec3 finest(view.camera.halfCellsToData[0].x, view.camera.halfCellsToData[1].y,
    view.camera.halfCellsToData[2].z);
  frame.gradientToMagnitude = 2.0 / 3.0 * (finest.x + finest.y + finest.z) /
    glm::dvec3(toData[0].x, toData[1].y, toData[2].z);
  if (view.lighting)
  {
    fillLighting(frame, *view.lighting, view.lighting->dataToWorld * toData, fromHalfCells[3]);
  }
  frame.width = static_cast<std::uint32_t>(view.target.width);
  frame.height = static_cast<std::uint32_t>(view.target.height);
  frame.stepScale = static_cast<float>(view.quality.stepScale);
  frame.fixedStep = static_cast<float>(view.quality.sampleDistance / view.opacityUnitDistance);
  frame.terminationOpacity = static_cast<float>(view.quality.terminationOpacity);
  for (std::size_t k = 0; k < view.averageRanges.size(); ++k)
  {
    frame.leastToAverage[static_cast<glm::length_t>(k)] =
      static_cast<float>(view.averageRanges[k].x);
    frame.mostToAverage[static_cast<glm::length_t>(k)] =
      static_cast<float>(view.averageRanges[k].y);
  }
  frame.isoValueCount = static_cast<std::uint32_t>(
    std::min<std::size_t>(view.isoValues.size(), layout::MOST_ISO_VALUES));
  std::copy_n(view.isoValues.begin(), frame.isoValueCount, frame.isoValues);
  frame.hasDepth = view.target.depth != nullptr;
  fillCutaway(frame, view.cutaway, fromHalfCells);
  frame.slicePlane = toPlane(view.slicePlane, fromHalfCells);
  if (view.undefinedColor)
  {
    const double extinction =
      std::min(-std::log1p(-view.undefinedColor->a), double(layout::DENSEST));
    frame.undefined = extinction * glm::dvec4(glm::dvec3(*view.undefinedColor), 1.0);
  }
}
}
}
