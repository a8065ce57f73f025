// SPDX-License-Identifier: BSD-3-Clause
// Surfaces along a ray, piece by piece. On a piece the field is a quotient of two cubics of the way that is
// done, so that crossings are exact, whatever the length of steps (Marmitt et al., "Fast and accurate
// ray-voxel intersection techniques for iso-surface ray tracing", VMV 2004). A piece lies in a dual cell,
// between the centres of eight cells; where levels meet, in half a cell of the finest, as planes through
// centres and faces bound all tents. Of completed levels that meet, the quotient is of higher degree: of it
// the cubic through four of its values is taken.

// What a piece has of the field.
struct Course
{
  bool passes;      // it may come past a surface: only then are the cubics known
  vec4 numerator;   // of the way from `entry` of the cursor, 0, to the end of the piece, 1; by its powers
  vec4 denominator;
  float first; // the values at both ends; if it passes no surface, ones on the same side of them all
  float last;
};

float valueOfCubic(vec4 cubic, float at)
{
  return cubic.x + at * (cubic.y + at * (cubic.z + at * cubic.w));
}

// By the powers of what goes from 0 to 1, from its values at thirds.
vec4 cubicThrough(vec4 values)
{
  return vec4(values.x, dot(vec4(-5.5, 9.0, -4.5, 1.0), values),
    dot(vec4(9.0, -22.5, 18.0, -4.5), values), dot(vec4(-4.5, 13.5, -13.5, 4.5), values));
}

// Where the ray leaves the cell of the lattice (findLattice) that it is in, or the end that there is
// already, if that is nearer.
float leaveLattice(Cursor cursor, Ray ray, float end)
{
  const int width = int(cursor.interval); // half cells
  const ivec3 corner = cursor.brick.lo + (cursor.halved ? 0 : width / 2);
  const float inside = min(behindFace(cursor.entry), end);
  const vec3 at = (vec3(ray.base - corner) + (ray.fraction + inside * ray.direction)) / float(width);
  const ivec3 plane =
    corner + width * (ivec3(floor(at)) + ivec3(greaterThan(ray.direction, vec3(0.0))));
  return leaveThrough(ray, plane, inside, end);
}

// The least and greatest of the values at corners, of those that are there. Completed ones may lie below 0.
void widenToCorners(Brick brick, vec4 lower, vec4 upper, inout vec2 range)
{
  const float least = (brick.dimensions & BRICK_HAS_ABSENT_CELLS) == 0u ? -1e30 : 0.0;
  const vec4 low = min(mix(lower, vec4(1e30), lessThan(lower, vec4(least))),
    mix(upper, vec4(1e30), lessThan(upper, vec4(least))));
  const vec4 high = max(lower, upper);
  range = vec2(min(range.x, min(min(low.x, low.y), min(low.z, low.w))),
    max(range.y, max(max(high.x, high.y), max(high.z, high.w))));
}

// Whether a surface's value lies between two.
bool isAnyBetween(float a, float b)
{
  for (uint k = 0; k < constants.frame.isoValueCount; ++k)
  {
    const float isoValue = constants.frame.isoValues[k];
    if ((a < isoValue) != (b < isoValue))
    {
      return true;
    }
  }
  return false;
}

// The cells around `q`, in cells from the centre of the brick's first one: their values, and where the first
// of them is.
vec3 readCorners(Brick brick, uvec3 n, vec3 q, out vec4 lower, out vec4 upper)
{
  if (isCompleted)
  {
    readLattice(brick, n, floor(q), 0u, lower, upper);
    return floor(q);
  }
  const vec3 c = clamp(q, vec3(0.0), vec3(n) - 1.0);
  return c - readCells(brick, n, c, 0u, lower, upper);
}

// The trilinear function of the values at eight corners on the line from `from` to `to`.
vec4 cubicBetween(vec4 lower, vec4 upper, vec3 from, vec3 to)
{
  const vec3 way = to - from;
  const vec4 a = mix(lower, upper, from.z);
  const vec4 b = way.z * (upper - lower);
  const vec2 c = mix(a.xy, a.zw, from.y);
  const vec2 d = mix(b.xy, b.zw, from.y) + way.y * (a.zw - a.xy);
  const vec2 e = way.y * (b.zw - b.xy);
  return vec4(mix(c.x, c.y, from.x), mix(d.x, d.y, from.x) + way.x * (c.y - c.x),
    mix(e.x, e.y, from.x) + way.x * (d.y - d.x), way.x * (e.y - e.x));
}

// Of the one brick.
Course courseOfBrick(Cursor cursor, Ray ray, float end)
{
  const uvec3 n = cellsOf(cursor.brick);
  // Beyond the centres. No vector: lavapipe took the wrong one of two constant ones.
  const float beyond = isCompleted ? 1.0 : 0.0;
  const vec3 least = vec3(-beyond);
  const vec3 greatest = vec3(n) - 1.0 + beyond;
  vec4 lower;
  vec4 upper;
  const vec3 corner = readCorners(cursor.brick, n,
    clamp(toCells(cursor.brick, ray, 0.5 * (cursor.entry + end)) - 0.5, least, greatest), lower,
    upper);
  vec2 range = vec2(1e30, -1e30);
  widenToCorners(cursor.brick, lower, upper, range);
  Course course;
  course.passes = isAnyBetween(range.x, range.y);
  course.first = course.last = range.x;
  course.numerator = course.denominator = vec4(0.0);
  if (course.passes)
  {
    const vec3 from = toCells(cursor.brick, ray, cursor.entry) - 0.5;
    const vec3 to = toCells(cursor.brick, ray, end) - 0.5;
    course.numerator = cubicBetween(lower, upper, clamp(from, least, greatest) - corner,
      clamp(to, least, greatest) - corner);
    course.denominator = vec4(1.0, vec3(0.0));
    course.first = clamp(course.numerator.x, range.x, range.y);
    course.last = clamp(dot(course.numerator, vec4(1.0)), range.x, range.y);
  }
  return course;
}

// Where bricks meet, or cells are absent.
Course courseOfBricks(Cursor cursor, Ray ray, float end)
{
  const float middle = 0.5 * (cursor.entry + end);
  vec2 range = vec2(1e30, -1e30);
  Brick brick = cursor.brick;
  uint others = cursor.others;
  while (true)
  {
    const uvec3 n = cellsOf(brick);
    const vec3 q = toCells(brick, ray, middle) - 0.5;
    if (all(greaterThan(q, vec3(-1.0))) && all(lessThan(q, vec3(n))))
    {
      vec4 lower;
      vec4 upper;
      readCorners(brick, n, q, lower, upper);
      widenToCorners(brick, lower, upper, range);
    }
    if (others == 0u)
    {
      break;
    }
    brick = nextBrick(others);
  }
  Course course;
  course.passes = isAnyBetween(range.x, range.y);
  course.first = course.last = range.x;
  course.numerator = course.denominator = vec4(0.0);
  if (course.passes)
  {
    vec4 sums;
    vec4 weights;
    for (int k = 0; k < 4; ++k)
    {
      sumBricks(cursor.brick, cursor.others, ray, mix(cursor.entry, end, float(k) / 3.0), 0u,
        sums[k], weights[k]);
    }
    const vec4 values = clamp(sums / weights, range.x, range.y);
    course.numerator = cubicThrough(isCompleted ? values : sums);
    course.denominator = isCompleted ? vec4(1.0, vec3(0.0)) : cubicThrough(weights);
    course.first = values.x;
    course.last = values.w;
  }
  return course;
}

// Where a cubic has its extrema between 0 and 1; 1, where it has none. Between them it passes 0 once at most.
vec2 extremaOf(vec4 cubic)
{
  const float root = sqrt(max(cubic.z * cubic.z - 3.0 * cubic.w * cubic.y, 0.0));
  const float q = -cubic.z - (cubic.z < 0.0 ? -root : root);
  const float a = q / (3.0 * cubic.w); // either may be infinite, or no number
  const float b = cubic.y / q;
  const vec2 places = vec2(a > 0.0 && a < 1.0 ? a : 1.0, b > 0.0 && b < 1.0 ? b : 1.0);
  return vec2(min(places.x, places.y), max(places.x, places.y));
}

// Where a cubic passes 0 between two places: by false position, in which an end that stays counts half each
// time (the Illinois rule). Where rounding hides that it does, at the end where it is closest.
float findCrossing(vec4 cubic, float from, float to)
{
  float before = valueOfCubic(cubic, from);
  float behind = valueOfCubic(cubic, to);
  if ((before < 0.0) == (behind < 0.0))
  {
    return abs(before) < abs(behind) ? from : to;
  }
  for (int step = 0; step < 6 && before != behind; ++step)
  {
    const float at = from - before * (to - from) / (behind - before);
    const float value = valueOfCubic(cubic, at);
    if ((value < 0.0) == (before < 0.0))
    {
      from = at;
      before = value;
      behind *= 0.5;
    }
    else
    {
      to = at;
      behind = value;
      before *= 0.5;
    }
  }
  return before == behind ? from : from - before * (to - from) / (behind - before);
}

// A surface that a piece passes: where, as a fraction of it, and which: of several at one place the one whose
// value comes first.
struct Crossing
{
  float at;
  int order;
  float isoValue;
};

bool isBefore(Crossing a, Crossing b)
{
  return a.at < b.at || (a.at == b.at && a.order < b.order);
}

// The first one behind another. False: there is none.
bool findNextCrossing(Course course, Crossing last, out Crossing next)
{
  const int count = int(constants.frame.isoValueCount);
  next = Crossing(2.0, 0, 0.0);
  for (int k = 0; k < count; ++k)
  {
    const int which = course.last > course.first ? k : count - 1 - k;
    const float isoValue = constants.frame.isoValues[which];
    const vec4 cubic = course.numerator - isoValue * course.denominator;
    const vec2 extrema = isNearest ? vec2(1.0) : extremaOf(cubic);
    const vec4 places = vec4(0.0, extrema, 1.0);
    bool isLow = course.first < isoValue;
    for (int piece = isNearest ? 2 : 0; piece < 3; ++piece)
    {
      const bool wasLow = isLow;
      // Rounding must not tell the end from where it has no extremum.
      isLow = places[piece + 1] < 1.0 ? valueOfCubic(cubic, places[piece + 1]) < 0.0
                                      : course.last < isoValue;
      if (wasLow != isLow)
      {
        // Cells have their surfaces where the next one begins.
        const float at =
          isNearest ? 0.0 : min(findCrossing(cubic, places[piece], places[piece + 1]), 1.0);
        const Crossing found = Crossing(at, 3 * k + piece, isoValue);
        if (isBefore(last, found) && isBefore(found, next))
        {
          next = found;
        }
      }
    }
  }
  return next.at <= 1.0;
}

// The surfaces up to the end of the piece.
void addSurfaces(Cursor cursor, Ray ray, Course course, float end, inout Accumulator gathered)
{
  Crossing crossing = Crossing(-1.0, 0, 0.0);
  while (!isComplete(gathered) && findNextCrossing(course, crossing, crossing))
  {
    const float at = mix(cursor.entry, end, crossing.at);
    if (isInPart(ray, at))
    {
      addSurface(crossing.isoValue, cursor, ray, at, gathered);
    }
  }
}

// The next piece, or the next cell that is absent.
void marchSurfaces(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float end = cursor.exit;
  float value = ABSENT;
  Course course;
  const bool isOfOne = !isNearest && isOfOneBrick(cursor);
  bool there = true;
  if (isNearest || cursor.cut)
  {
    there = findCell(cursor.brick, cursor.others, ray, cursor.entry, end, value);
  }
  if (isNearest)
  {
    course.passes = cursor.known;
    course.first = course.last = value;
    course.numerator = course.denominator = vec4(0.0);
  }
  else if (isOfOne)
  {
    end = leaveLattice(cursor, ray, end);
    course = courseOfBrick(cursor, ray, end);
  }
  else if (there)
  {
    end = leaveLattice(cursor, ray, end);
    course = courseOfBricks(cursor, ray, end);
  }
  if (there)
  {
    // Rounding must not hide a crossing between two pieces.
    course.first = cursor.known ? cursor.value : course.first;
    course.passes = course.passes || isAnyBetween(course.first, course.last);
    if (course.passes)
    {
      addSurfaces(cursor, ray, course, end, gathered);
    }
    cursor.value = course.last;
  }
  else
  {
    addAbsent(value, (end - cursor.entry) * ray.unitsPerHalfCell, gathered);
  }
  cursor.known = there;
  endCell(end, cursor);
}
