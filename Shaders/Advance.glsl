// SPDX-License-Identifier: BSD-3-Clause
// A pixel's ray as its traversal sees it: one local frame after the other, front to back. It need
// not know why there is another one: the ray has come far from its base, or a segment has ended and
// the next one begins.

struct Pixel
{
  uvec2 place;
  int segment; // that the ray is in; -1: before the first
  Pair skip;   // from the beginning of the segment to that of the local frame, half cells
};

// Whether there may be more of the ray behind `distance`. Where there is one segment alone, the
// compiler knows that its end is that of the ray.
bool goesOn(Pixel pixel, Ray ray, float distance)
{
  return distance < ray.end || (SEGMENTS > 1 && pixel.segment + 1 < SEGMENTS);
}

// Whether it takes another frame to go on.
bool isUsedUp(Ray ray, float distance)
{
  return distance > REBASE_DISTANCE || (SEGMENTS > 1 && !(distance < ray.end));
}

// What comes behind `distance`, at which the ray is used up. Distances count anew from there, and
// ray.begin is where it goes on. False: the pixel's ray has ended.
bool advance(FrameBuffer f, inout Pixel pixel, inout Ray ray, float distance)
{
  const bool sameSegment = distance < ray.end;
  pixel.segment += sameSegment ? 0 : 1;
  if (sameSegment)
  {
    pixel.skip = add(pixel.skip, makePair(beforeRounding(distance)));
  }
  else
  {
    pixel.skip = makePair(0.0);
  }
  for (; pixel.segment < SEGMENTS; ++pixel.segment)
  {
    Segment segment;
    if (!findSegment(f, pixel.place, pixel.segment, segment))
    {
      return false;
    }
    if (makeRay(segment.line, add(segment.begin, pixel.skip), segment.end, f.frame.size, ray))
    {
      return true;
    }
    pixel.skip = makePair(0.0);
  }
  return false;
}

// The pixel's ray from its beginning on. False: there is nothing of it.
bool startRay(FrameBuffer f, uvec2 place, out Pixel pixel, out Ray ray)
{
  pixel.place = place;
  pixel.segment = -1;
  pixel.skip = makePair(0.0);
  ray.begin = 0.0;
  ray.end = 0.0;
  return advance(f, pixel, ray, 0.0);
}
