// SPDX-License-Identifier: BSD-3-Clause
// Lattices of odd shapes and sizes, and cameras in odd places.
#include "MakeAMR.h"

namespace exabricks
{
namespace stability
{
namespace
{
constexpr char asAnywhere[] =
  "as at the origin with spacing 1: what is drawn is the same picture, set up "
  "in double precision";

// The scene of two levels somewhere else.
Hierarchy placed(const glm::dvec3& origin, const glm::dvec3& spacing)
{
  Hierarchy hierarchy = twoLevels();
  hierarchy.origin = origin;
  hierarchy.spacing = spacing;
  return hierarchy;
}

// Its finest cells are `size` wide in the world.
Setting ofSize(double size, double scale)
{
  const Hierarchy hierarchy = placed(glm::dvec3(0.0), glm::dvec3(size));
  Setting setting = shellSetting(hierarchy);
  setting.scale = scale;
  setting.unitDistance = size * scale;
  look(setting, { -0.6, 0.5, -0.4 }, 30.0);
  return setting;
}

// Looks along the longest axis, a little to the side, at the middle of the scene; the picture shows
// `width` there.
Setting stretched(const glm::dvec3& spacing, const glm::dvec3& direction, double width)
{
  Setting setting = shellSetting(placed(glm::dvec3(5.0, -3.0, 2.0), spacing));
  look(setting, direction, 0.0);
  setting.camera.parallelScale = 0.5 * width;
  setting.unitDistance = glm::max(spacing.x, glm::max(spacing.y, spacing.z));
  return setting;
}

// The scene, and one coarse block 2^20 finest cells away: the camera looks at the scene.
Setting onLargeLattice()
{
  Hierarchy hierarchy = placed(glm::dvec3(0.0), glm::dvec3(1.0));
  const Box scene = reference::boundsOf(hierarchy);
  for (Block& block : hierarchy.blocks)
  {
    const Int3 shift((std::int64_t(1) << 20) / hierarchy.cellWidth[block.level]);
    block.cells.lo += shift;
    block.cells.hi += shift;
  }
  hierarchy.blocks.insert(hierarchy.blocks.begin(), { 0, { Int3(0), Int3(2) } });
  const Int3 shift(std::int64_t(1) << 20);
  const Box there{ scene.lo + shift, scene.hi + shift };
  Setting setting;
  setting.hierarchy = hierarchy;
  setting.amr = makeAMR(hierarchy,
    [there, widths = hierarchy.cellWidth](int level, const Int3& cell)
    {
      const glm::dvec3 center = (glm::dvec3(cell) + 0.5) * static_cast<double>(widths[level]);
      return reference::shellAndBlobs(there, center);
    });
  setting.transfer = layers();
  setting.camera = reference::frame(hierarchy, there, { -0.6, 0.5, -0.4 }, 30.0, 1.0);
  return setting;
}

// The same, from behind the block at the other end: rays come through 2^20 cells of nothing.
Setting throughLargeLattice()
{
  Setting setting = onLargeLattice();
  Box there = reference::boundsOf(setting.hierarchy);
  there.lo = there.hi - std::int64_t(32);
  setting.camera = reference::frame(setting.hierarchy, there, { 1.0, 1.0001, 0.9999 }, 1.6e-3, 1.0);
  setting.camera.nearest = 1.0;
  return setting;
}

Setting fromWithin(const glm::dvec3& position, const glm::dvec3& direction)
{
  Setting setting = shellSetting(twoLevels());
  setting.transfer = layers(0.0, 2.0); // thin, so that rays come far
  setting.camera.position = position;
  setting.camera.focalPoint = position + direction;
  setting.camera.viewAngle = 70.0;
  setting.camera.nearest = 0.01;
  setting.camera.farthest = 400.0;
  return setting;
}

// The near plane is a face of cells of all levels, and the rays are normal to it.
Setting fromNearPlaneOnFace()
{
  Setting setting = shellSetting(twoLevels(), 0.0);
  setting.camera.position = glm::dvec3(15.3, 14.9, 100.0);
  setting.camera.focalPoint = glm::dvec3(15.3, 14.9, 0.0);
  setting.camera.viewUp = glm::dvec3(0.0, 1.0, 0.0);
  setting.camera.parallelScale = 15.0;
  setting.camera.nearest = 100.0 - 16.0;
  setting.camera.farthest = 200.0;
  return setting;
}

Setting fromFarAway(double domains)
{
  Setting setting = shellSetting(twoLevels());
  look(setting, { -0.6, 0.5, -0.4 }, 30.0 / domains);
  return setting;
}
}

std::vector<Case> geometryCases()
{
  return {
    { "Anisotropy1To100", "one width is taken for all axes: steps too long, opacity wrong",
      [] {
        return stretched({ 1.0, 1.0, 100.0 }, { -0.6, 0.5, -80.0 }, 40.0);
      },
      60.0, 100.0, "steps are a quarter of a cell whatever its shape" },
    { "Anisotropy100To1To10", "one width is taken for all axes: steps too long, opacity wrong",
      [] {
        return stretched({ 100.0, 1.0, 10.0 }, { -80.0, 0.6, -7.0 }, 100.0);
      },
      60.0, 100.0, "steps are a quarter of a cell whatever its shape" },
    { "SpacingTiny",
      "float32 world coordinates vanish; VTK's cameras end at 1e-20, so the volume's "
      "matrix enlarges it",
      [] { return ofSize(1e-30, 1e30); }, 60.0, 100.0, asAnywhere },
    { "SpacingHuge", "float32 squares of lengths overflow", [] { return ofSize(1e30, 1.0); }, 60.0,
      100.0, asAnywhere },
    { "SpacingHugeMadeSmall", "as above, and the inverse of the volume's matrix",
      [] { return ofSize(1e30, 1e-30); }, 60.0, 100.0, asAnywhere },
    { "OriginAMillionDomainsAway", "float32 world coordinates have no digits left for cells",
      []
      {
        Setting setting = shellSetting(placed(glm::dvec3(32e6, -32e6, 32e6), glm::dvec3(1.0)));
        return setting;
      },
      60.0, 100.0, asAnywhere },
    { "LatticeOf2To20", "float32 positions on the lattice are good to 1/8 of a cell only",
      onLargeLattice, 60.0, 90.0,
      "distances count from a lattice point near the ray, so that 1e-4 of a cell is left of "
      "float32" },
    { "ThroughALatticeOf2To20", "distances along the ray have lost their digits on arrival",
      throughLargeLattice, 60.0, 90.0, "a ray is set up anew, in double precision, on its way" },
    { "CameraInsideACell", "the first step, and blocks behind the camera sorted before it",
      [] {
        return fromWithin({ 13.3, 18.2, 14.4 }, { 0.4, -0.5, 0.3 });
      },
      60.0, 100.0, "rays begin anywhere in a cell; the first interval begins there too" },
    { "CameraOnAFace", "0 / 0 in the distance to the face it is on",
      [] {
        return fromWithin({ 16.0, 18.2, 14.4 }, { 0.0, -0.5, 0.3 });
      },
      60.0, 100.0,
      "the face is behind or before all rays but those in it, none of which is a pixel's" },
    { "CameraOnACorner", "0 / 0 in the distance to the faces it is on",
      [] {
        return fromWithin({ 16.0, 16.0, 16.0 }, { 0.9, -0.5, 0.3 });
      },
      60.0, 100.0, "as on a face" },
    { "NearPlaneOnAFace", "a first interval of no length, or a layer of cells too many",
      fromNearPlaneOnFace, 60.0, 100.0,
      "a ray that begins in a face has all of the cell behind it before it" },
    { "CameraAHundredThousandDomainsAway", "float32 distances from the camera have no digits left",
      [] { return fromFarAway(1e5); }, 60.0, 90.0,
      "distances count from where rays enter the data; the double-precision matrices lose 1e-11" },
    { "ParallelProjection", "rays are taken to start in one point",
      [] { return shellSetting(twoLevels(), 0.0); }, 60.0, 100.0, "as in perspective" },
  };
}
}
}
