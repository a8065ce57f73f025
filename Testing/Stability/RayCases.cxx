// SPDX-License-Identifier: BSD-3-Clause
// Rays that run along axes, in faces, along edges and through corners of cells and regions.
#include "MakeAMR.h"

#include <glm/geometric.hpp>

namespace exabricks
{
namespace stability
{
namespace
{
constexpr char eitherSide[] =
  "either side of a face is right for a ray in it, as long as the ray stays on one side";

// Parallel rays along `direction` through the scene of two levels (32 finest cells wide). Pixels
// are `pixel` finest cells apart, and the middle of the picture, a corner of four pixels, looks
// through `through`.
Setting parallelRays(const glm::dvec3& direction, const glm::dvec3& up, const glm::dvec3& through,
  double pixel, int size)
{
  Setting setting = shellSetting(twoLevels());
  setting.width = setting.height = size;
  setting.camera.viewAngle = 0.0;
  setting.camera.viewUp = up;
  setting.camera.position = through - 64.0 * glm::normalize(direction);
  setting.camera.focalPoint = through;
  setting.camera.parallelScale = 0.5 * size * pixel;
  setting.camera.nearest = 1.0;
  setting.camera.farthest = 200.0;
  return setting;
}

Setting alongAxis(int axis, double sign)
{
  glm::dvec3 direction(0.0);
  glm::dvec3 up(0.0);
  direction[axis] = sign;
  up[(axis + 1) % 3] = 1.0;
  return parallelRays(direction, up, { 16.3, 15.9, 16.4 }, 0.75, 48);
}

// Pixels' centres lie on lattice points in x, and on half ones in y.
Setting inFaces()
{
  Setting setting = parallelRays({ 0, 0, -1 }, { 0, 1, 0 }, { 16.0, 16.5, 16.0 }, 1.0, 31);
  setting.beside = 1e-6;
  return setting;
}

Setting alongEdges()
{
  Setting setting = parallelRays({ 0, 0, -1 }, { 0, 1, 0 }, { 16.0, 16.0, 16.0 }, 1.0, 31);
  setting.beside = 1e-6;
  return setting;
}

// In faces of constant z, through edges along it.
Setting diagonalInFaces()
{
  Setting setting = parallelRays({ 1, 1, 0 }, { 0, 0, 1 }, { 16.0, 16.0, 16.0 }, 1.0, 31);
  setting.beside = 1e-6;
  return setting;
}

// Rays along the main diagonal, some of them through corners of cells one after the other.
Setting throughCorners()
{
  Setting setting = parallelRays({ 1, 1, 1 }, { 0, 0, 1 }, glm::dvec3(16.0), std::sqrt(0.5), 31);
  setting.beside = 1e-6;
  return setting;
}

// One cell up or down from one side of the data to the other, or far less.
Setting grazing(double slope)
{
  return parallelRays({ 1.0, slope, -0.5 * slope }, { 0, 0, 1 }, { 16.0, 16.0, 16.5 }, 0.99, 32);
}

// A perspective camera in a face: the middle column of pixels runs in it.
Setting fanInFace()
{
  Setting setting = shellSetting(twoLevels());
  setting.width = setting.height = 31;
  setting.camera.position = glm::dvec3(16.0, -30.0, 40.0);
  setting.camera.focalPoint = glm::dvec3(16.0, 16.0, 16.0);
  setting.camera.viewUp = glm::dvec3(0.0, 0.0, 1.0);
  setting.camera.viewAngle = 50.0;
  setting.camera.nearest = 1.0;
  setting.camera.farthest = 200.0;
  setting.beside = 1e-6;
  return setting;
}
}

std::vector<Case> rayCases()
{
  return {
    { "AlongX", "1 / 0 in the distance to faces", [] { return alongAxis(0, 1.0); }, 60.0, 100.0,
      "as any other direction" },
    { "AlongMinusY", "1 / -0 in the distance to faces", [] { return alongAxis(1, -1.0); }, 60.0,
      100.0, "as any other direction" },
    { "AlongZ", "1 / 0 in the distance to faces", [] { return alongAxis(2, 1.0); }, 60.0, 100.0,
      "as any other direction" },
    { "InFaces", "0 * infinity: rays lost, or noise between the two sides", inFaces, 60.0, 90.0,
      eitherSide },
    { "AlongEdges", "as in faces, of four sides", alongEdges, 60.0, 90.0, eitherSide },
    { "DiagonalInFaces", "two faces at one distance: a region is left out or taken twice",
      diagonalInFaces, 60.0, 90.0, eitherSide },
    { "ThroughCorners", "three faces at one distance: a region is left out or taken twice",
      throughCorners, 60.0, 90.0, eitherSide },
    { "FanInAFace", "a seam in the one column of pixels that lies in the face", fanInFace, 60.0,
      90.0, eitherSide },
    { "AlmostInFaces", "distances to faces are huge and lose their digits",
      [] { return grazing(1e-7); }, 60.0, 90.0,
      "float32 cannot tell the slope, and moves the ray by no more than 1e-4 of a cell" },
    { "Grazing", "a ray changes cells where rounding says, not where the face is",
      [] { return grazing(0.03); }, 60.0, 90.0,
      "positions are good to 1e-4 of a cell, which a slope of 0.03 turns to 3e-3 along the ray" },
  };
}
}
}
