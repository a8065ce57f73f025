// SPDX-License-Identifier: BSD-3-Clause
// The way of a pixel's ray: its line between two depths.

// `begin`: where rays begin at depths of their own. False: there is none.
bool findWay(FrameBuffer f, uvec2 pixel, out Line line, out Pair begin, out Pair end)
{
  const uint place = pixel.y * f.frame.width + pixel.x;
  float near = 0.0;
  if (beginsAtDepth)
  {
    near = Values(f.frame.nearDepth).items[place];
  }
  float far = 1.0;
  if (f.frame.hasDepth != 0)
  {
    far = Values(f.frame.depth).items[place];
  }
  if ((beginsAtDepth && !(near < far)) || !findLine(f, pixel, line))
  {
    return false;
  }
  begin = makePair(0.0);
  if (beginsAtDepth)
  {
    begin = distanceAt(f, line, near);
  }
  end = line.extent;
  if (f.frame.hasDepth != 0)
  {
    end = distanceAt(f, line, far);
  }
  return true;
}
