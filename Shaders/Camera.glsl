// SPDX-License-Identifier: BSD-3-Clause
// From a pixel to the line that is seen through it, in half cells and in pairs of floats: cameras
// may be far away, and lattices large. The host has chosen two depths that bracket the data's
// bounds: between them no coordinate is larger than it need be, wherever the camera is.
#include "FloatPair.glsl"

struct Line
{
  Pair3 origin;    // at the first of these depths
  Pair3 direction; // of length 1
  Pair extent;     // to the second one
  Pair firstW;     // homogeneous coordinates at these depths
  Pair secondW;
  float unitsPerHalfCell; // length of a step of length 1 in opacity unit distances
};

Pair w(Pair4 a) { return Pair(a.high.w, a.low.w); }

// Makes every distance along a line finite: no component of its direction is 0.
Pair3 withoutZeros(Pair3 direction)
{
  const bvec3 none = lessThan(abs(direction.high), vec3(1e-12));
  direction.high = mix(direction.high,
    mix(vec3(-1e-12), vec3(1e-12), greaterThanEqual(direction.high, vec3(0.0))), none);
  direction.low = mix(direction.low, vec3(0.0), none);
  return direction;
}

float unitsAlong(FrameBuffer f, vec3 direction)
{
  return length(f.frame.halfCellsToUnitsX * direction.x + f.frame.halfCellsToUnitsY * direction.y +
    f.frame.halfCellsToUnitsZ * direction.z);
}

// The line of a pixel. False: it has no length.
bool findLine(FrameBuffer f, uvec2 pixel, out Line line)
{
  // From the middle of the picture: a number of halves of pixels, exactly.
  const vec2 at = vec2(pixel) + 0.5 - 0.5 * vec2(f.frame.width, f.frame.height);
  const Pair4 aside = add(multiply(f.frame.perColumn, Pair4(vec4(at.x), vec4(0.0))),
    multiply(f.frame.perRow, Pair4(vec4(at.y), vec4(0.0))));
  const Pair4 first = add(f.frame.first, aside);
  const Pair4 second = add(f.frame.second, aside);
  line.firstW = w(first);
  line.secondW = w(second);
  line.origin = divide(xyz(first), line.firstW);
  const Pair3 path = add(divide(xyz(second), line.secondW), negative(line.origin));
  line.extent = lengthOf(path);
  if (!(line.extent.high > 0.0) || isinf(line.extent.high))
  {
    return false;
  }
  line.direction = withoutZeros(divide(path, line.extent));
  line.unitsPerHalfCell = unitsAlong(f, line.direction.high);
  return true;
}

// The distance along the line of a window depth in [0, 1], as a depth buffer holds it; of one that
// is not between the two depths, that of the next one, as no data lie beyond. On a line, depths go
// as distances divided by the homogeneous coordinates.
Pair distanceAt(FrameBuffer f, Line line, float depth)
{
  const Pair ndc = makePair(2.0 * depth, -1.0);
  const Pair fraction =
    multiply(add(ndc, negative(f.frame.firstDepth)), f.frame.inverseDepths);
  if (!(fraction.high > 0.0))
  {
    return makePair(0.0);
  }
  if (!(fraction.high < 1.0))
  {
    return line.extent;
  }
  const Pair rest = add(makePair(1.0), negative(fraction));
  const Pair seen = multiply(fraction, line.secondW);
  return multiply(
    divide(seen, add(multiply(rest, line.firstW), seen)), line.extent);
}
