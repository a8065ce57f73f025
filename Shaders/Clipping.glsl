// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes, and the plane of a slice. What clipping planes leave is convex, so that of a line it
// is one piece, whose ends are found in pairs of floats: they may lie anywhere between two faces.

// A slope below which a line runs along a plane: over all of a lattice it does not come nearer to it
// than positions are exact.
const float LEAST_SLOPE = 1e-12;

// Where the line passes the plane, if its slope is not too small, and whether it comes from below.
struct Passage
{
  Pair distance;
  float slope;  // of the line, from below upwards
  float height; // of the line's origin above the plane
};

Passage passPlane(Line line, Pair4 plane)
{
  const Pair4 direction = Pair4(vec4(line.direction.high, 0.0), vec4(line.direction.low, 0.0));
  const Pair height = sum(multiply(plane, widen(line.origin)));
  const Pair slope = sum(multiply(plane, direction));
  return Passage(negative(divide(height, slope)), slope.high, height.high);
}

// Shortens the piece of the line from `begin` to `end`. False: nothing of it is left.
bool clip(FrameBuffer f, Line line, inout Pair begin, inout Pair end)
{
  for (uint i = 0; i < f.frame.clippingPlaneCount; ++i)
  {
    const Passage passage = passPlane(line, f.frame.clippingPlanes[i]);
    if (abs(passage.slope) < LEAST_SLOPE)
    {
      if (passage.height < 0.0)
      {
        return false;
      }
      continue;
    }
    if (passage.slope > 0.0)
    {
      begin = greater(begin, passage.distance);
    }
    else
    {
      end = lesser(end, passage.distance);
    }
  }
  return isLess(begin, end);
}

// So long is what is left of the line at a slice's plane, half cells: enough to find the region there.
const float SLICE_LENGTH = 2e-3;

// Shortens the piece of the line to the place where it passes the slice's plane. False: it does not.
bool slice(FrameBuffer f, Line line, inout Pair begin, inout Pair end)
{
  const Passage passage = passPlane(line, f.frame.slicePlane);
  if (abs(passage.slope) < LEAST_SLOPE || isLess(passage.distance, begin) ||
    !isLess(passage.distance, end))
  {
    return false;
  }
  begin = passage.distance;
  end = lesser(end, add(begin, makePair(SLICE_LENGTH)));
  return true;
}
