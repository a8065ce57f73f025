// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes. What they leave is convex, so that of a line it is one piece, whose ends are found
// in pairs of floats: they may lie anywhere between two faces.

// A slope below which a line runs along a plane: over all of a lattice it does not come nearer to it
// than positions are exact.
const float LEAST_SLOPE = 1e-12;

// Shortens the piece of the line from `begin` to `end`. False: nothing of it is left.
bool clip(FrameBuffer f, Line line, inout Pair begin, inout Pair end)
{
  const Pair4 origin = widen(line.origin);
  const Pair4 direction = Pair4(vec4(line.direction.high, 0.0), vec4(line.direction.low, 0.0));
  for (uint i = 0; i < f.frame.clippingPlaneCount; ++i)
  {
    const Pair4 plane = f.frame.clippingPlanes[i];
    const Pair height = sum(multiply(plane, origin)); // of the line's origin above the plane
    const Pair slope = sum(multiply(plane, direction));
    if (abs(slope.high) < LEAST_SLOPE)
    {
      if (height.high < 0.0)
      {
        return false;
      }
      continue;
    }
    const Pair distance = negative(divide(height, slope));
    if (slope.high > 0.0)
    {
      begin = greater(begin, distance);
    }
    else
    {
      end = lesser(end, distance);
    }
  }
  return isLess(begin, end);
}
