// SPDX-License-Identifier: BSD-3-Clause
// Which pieces of a pixel's line are marched, front to back. Today there is one, between two depths
// and in the bounds. More of them (what clipping planes or a cropped box leave, layers of depth) are
// to be found here alone: whoever walks along the ray asks for one number after the other.

const int SEGMENTS = 1; // the most that a ray may have

struct Segment
{
  Line line;
  double begin; // distance from the line's origin, in the bounds
  // Where it ends for another reason than that it leaves the bounds: their faces are found again in
  // the ray's local frame, by the one formula for all planes.
  double end;
};

// The segment of that number. False: there is nothing of it.
bool findSegment(FrameBuffer f, uvec2 pixel, int number, out Segment segment)
{
  double near = -1.0LF;
  if (beginsAtDepth)
  {
    near = ndcDepth(Values(f.frame.nearDepth), pixel, f.frame.width);
  }
  double far = 1.0LF;
  if (f.frame.hasDepth != 0)
  {
    far = ndcDepth(Values(f.frame.depth), pixel, f.frame.width);
  }
  if (beginsAtDepth && !(near < far))
  {
    return false;
  }
  if (!findLine(f, pixel, near, far, segment.line))
  {
    return false;
  }
  const dvec3 toLower = -segment.line.origin / segment.line.direction;
  const dvec3 toUpper = (dvec3(f.frame.size) - segment.line.origin) / segment.line.direction;
  const dvec3 entries = min(toLower, toUpper);
  const dvec3 exits = max(toLower, toUpper);
  segment.begin = max(0.0LF, max(entries.x, max(entries.y, entries.z)));
  segment.end = segment.line.extent;
  return segment.begin < min(segment.end, min(exits.x, min(exits.y, exits.z)));
}
