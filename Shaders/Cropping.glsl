// SPDX-License-Identifier: BSD-3-Clause
// Cropping: two planes across each axis divide space into 27 regions, each of which is shown or not.
// A line crosses six planes, and so has at most seven pieces of one region each. Neighbours that are
// both shown are one piece here, which leaves at most four.

const int MOST_PIECES = 7;
const int MOST_SHOWN = 4;

bool isLess(Pair4 a, Pair4 b, int axis)
{
  return isLess(Pair(a.high[axis], a.low[axis]), Pair(b.high[axis], b.low[axis]));
}

// Narrows the piece of the line from `begin` to `end` to that part, by its number from the front,
// which is shown. False: there are not so many.
bool crop(FrameBuffer f, Line line, int number, inout Pair begin, inout Pair end)
{
  // Distances at which the line crosses the first and the second plane of each axis.
  const Pair4 origin = negative(widen(line.origin));
  const Pair4 inverse = reciprocal(widen(line.direction));
  const Pair4 lower = multiply(add(f.frame.croppingLower, origin), inverse);
  const Pair4 upper = multiply(add(f.frame.croppingUpper, origin), inverse);
  const bvec4 up = greaterThan(inverse.high, vec4(0.0));
  const Pair4 first = Pair4(mix(upper.high, lower.high, up), mix(upper.low, lower.low, up));
  const Pair4 second = Pair4(mix(lower.high, upper.high, up), mix(lower.low, upper.low, up));

  Pair start = begin; // of the part that was shown last
  int shown = -1;     // its number
  bool wasShown = false;
  Pair at = begin;
  for (int piece = 0; piece < MOST_PIECES && isLess(at, end); ++piece)
  {
    // The region behind `at`, by the planes crossed up to there, and where the next one is crossed.
    const Pair4 here = spread(at);
    Pair next = end;
    uint region = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      uint crossed = 2;
      if (isLess(here, second, axis))
      {
        next = lesser(next, Pair(second.high[axis], second.low[axis]));
        crossed = 1;
      }
      if (isLess(here, first, axis))
      {
        next = lesser(next, Pair(first.high[axis], first.low[axis]));
        crossed = 0;
      }
      region = 3 * region + (up[axis] ? crossed : 2 - crossed);
    }
    const bool isShown = (f.frame.shownRegions >> region & 1u) != 0;
    if (isShown && !wasShown)
    {
      start = at;
      ++shown;
    }
    if (wasShown && !isShown && shown == number)
    {
      end = at;
      break;
    }
    wasShown = isShown;
    at = next;
  }
  begin = start;
  return shown == number;
}
