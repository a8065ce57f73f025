// SPDX-License-Identifier: BSD-3-Clause
// Which pieces of a line are marched, front to back: what is left of its way, in the bounds, within the
// clipping planes and of the cropping regions. More of them (layers of depth) are to be found here
// alone: whoever walks along the ray asks for one number after the other.
#include "Clipping.glsl"
#include "Cropping.glsl"

const int SEGMENTS = cropped ? MOST_SHOWN : 1; // the most that a ray may have

struct Segment
{
  Line line;
  Pair begin; // distance from the line's origin, in the bounds or a little before
  // Where it ends for another reason than that it leaves the bounds: their faces are found again in
  // the ray's local frame, by the one formula for all planes.
  Pair end;
};

// The segment of that number. False: the ray has none of it, nor any behind.
bool findSegment(FrameBuffer f, uvec2 place, int number, out Segment segment)
{
  Pair near;
  if (!findWay(f, place, segment.line, near, segment.end))
  {
    return false;
  }
  // The bounds' faces by floats, which miss them by some units in the last place of coordinates: a
  // segment begins as much before them.
  const vec3 origin = segment.line.origin.high;
  const vec3 direction = segment.line.direction.high;
  const vec3 toLower = -origin / direction;
  const vec3 toUpper = (vec3(f.frame.size) - origin) / direction;
  const vec3 slack = 3e-7 * (abs(origin) + vec3(f.frame.size)) / abs(direction);
  const vec3 entries = min(toLower, toUpper) - slack;
  const vec3 exits = max(toLower, toUpper) + slack;
  const float entry = max(entries.x, max(entries.y, entries.z));
  const float exit = min(exits.x, min(exits.y, exits.z));
  segment.begin = makePair(max(entry, 0.0));
  if (beginsAtDepth)
  {
    segment.begin = greater(segment.begin, near);
  }
  if (clipped && !clip(f, segment.line, segment.begin, segment.end))
  {
    return false;
  }
  if (cropped && !crop(f, segment.line, number, segment.begin, segment.end))
  {
    return false;
  }
  if (isSlice && !slice(f, segment.line, segment.begin, segment.end))
  {
    return false;
  }
  return segment.begin.high <= exit && isLess(segment.begin, segment.end);
}
