// SPDX-License-Identifier: BSD-3-Clause
// Where a ray is: the region that it is in, and how far it has come there. What it has gathered is
// kept apart, by the way of blending.

struct Cursor
{
  Brick brick; // the first of the region's: most regions have one alone
  uint others; // place of the rest in the lists; 0: there are none
  float entry; // distance at which the next interval begins
  float exit;  // distance at which the ray leaves the region
  uint intervals; // number still to do; where they end at faces of cells: 0, or 1 for some

  // Where the field is continuous; of surfaces `interval` and `halved` tell the lattice
  bool cut;       // some cells are absent: intervals end at faces
  float interval; // greatest length of an interval; unless cut, a whole number fills the region
  bool halved;    // by a sample in its middle
  float lead;     // where samples are jittered: length of the region's first interval, while it lasts
  bool known;     // the field at `entry` is
  float value;    // it
  vec3 gradient;  // its gradient by half cells, where that is needed
#ifdef FAMILY_COMPONENTS
  vec4 values; // its components
  mat4x3 gradients;
#endif
};

// In no region, and nothing is known.
Cursor startCursor()
{
  Cursor cursor;
  cursor.intervals = 0;
  cursor.exit = -1.0;
  cursor.known = false;
  cursor.value = 0.0;
  cursor.gradient = vec3(0.0);
#ifdef FAMILY_COMPONENTS
  cursor.values = vec4(0.0);
  cursor.gradients = mat4x3(0.0);
#endif
  return cursor;
}

// Distances count anew: what was known at the last of the old ones is of no use.
void forgetPoint(inout Cursor cursor)
{
  cursor.exit = -1.0;
}

// One brick alone makes the field, of cells that are all there.
bool isOfOneBrick(Cursor cursor)
{
  return cursor.others == 0u && (cursor.brick.dimensions & BRICK_HAS_ABSENT_CELLS) == 0u;
}

// Where surfaces are sought: a piece of the field's course lies in a cell of a lattice of the finest cells'
// centres; or, where cells of several widths meet, of their centres and faces.
void findLattice(inout Cursor cursor)
{
  int width = cursor.brick.width;
  uint others = cursor.others;
  cursor.halved = false;
  while (others != 0u)
  {
    const int other = nextBrick(others).width;
    cursor.halved = cursor.halved || other != width;
    width = min(width, other);
  }
  cursor.interval = float(cursor.halved ? width : 2 * width);
}

// The march goes on at the end of the interval.
void endInterval(float end, inout Cursor cursor)
{
  cursor.entry = end;
  cursor.lead = 0.0;
  cursor.intervals = cursor.cut ? (end < cursor.exit ? 1 : 0) : cursor.intervals - 1;
}

// The march goes on where the ray leaves a cell, or a piece of one.
void endCell(float end, inout Cursor cursor)
{
  cursor.entry = end;
  cursor.intervals = end < cursor.exit ? 1 : 0;
}

// How much longer intervals of a region may be than those of its step; or, where all steps are equal,
// are.
float growthOfStep(Ray ray, float step, Accumulator gathered)
{
  return fixedStep > 0.0 ? fixedStep / (ray.unitsPerHalfCell * stepScale * abs(step))
                         : growthOfIntervals(gathered);
}

// Of a region's intervals those that lie in the part that is drawn, be it in part, each where it is
// without parts: so what several processes draw is together what one draws. False: there are none.
bool keepIntervalsOfPart(Ray ray, float entry, inout Cursor cursor)
{
  const float count = float(cursor.intervals);
  const float first = clamp(floor((ray.partBegin - entry) / cursor.interval), 0.0, count);
  const float last = clamp(ceil((ray.partEnd - entry) / cursor.interval), 0.0, count);
  if (last < count)
  {
    cursor.exit = entry + last * cursor.interval;
  }
  if (first > 0.0)
  {
    cursor.entry = entry + first * cursor.interval;
    cursor.known = false;
  }
  cursor.intervals = uint(max(last - first, 0.0));
  return cursor.intervals > 0;
}

// Which of an interval is in the part that is drawn, as fractions of it.
vec2 keptOf(Ray ray, float from, float to)
{
  return isPart ? clamp((vec2(ray.partBegin, ray.partEnd) - from) / (to - from), 0.0, 1.0)
                : vec2(0.0, 1.0);
}

bool isInPart(Ray ray, float at)
{
  return !isPart || (at >= ray.partBegin && at < ray.partEnd);
}

// `step`: as in ActiveBox. `growth`: of intervals, as their error is seen less.
void enterRegion(Ray ray, uint firstBrick, float step, float growth, float entry, float exit,
  inout Cursor cursor)
{
  // Intervals of a part reach beyond it, where there are cells for them: as far as two of those of
  // the step go. Others end at its faces; crossings of surfaces are found one by one.
  const bool keepsIntervals = isPart && !isNearest && !isSlice && !isIsosurface && step > 0.0 && !jittered &&
    2.0 * stepScale * growth <= float(PART_REACH);
  bool isEmpty = false;
  if (isPart && isSlice)
  {
    isEmpty = !isInPart(ray, ray.begin); // the place of the slice
  }
  else if (isPart && !keepsIntervals)
  {
    // Surfaces between cells may be at the part's face, and take the cells on both sides.
    const float beyond = isNearest && isIsosurface ? 0.1 : 0.0;
    isEmpty = !(max(entry, ray.partBegin - beyond) < min(exit, ray.partEnd + beyond));
    entry = max(entry, ray.partBegin - beyond);
    exit = min(exit, ray.partEnd + beyond);
  }
  cursor.others = firstBrick;
  cursor.brick = nextBrick(cursor.others);
  cursor.intervals = 1;
  if (isIsosurface)
  {
    cursor.known = cursor.known && cursor.exit == entry;
    cursor.cut = step < 0.0;
    findLattice(cursor);
  }
  else if (!isNearest)
  {
    // Samples at most a step apart, two to an interval, unless one alone does for the region.
    cursor.cut = step < 0.0;
    const float interval = 2.0 * stepScale * abs(step) * growth;
    const float count = max(ceil((exit - entry) / interval), 1.0);
    cursor.halved = cursor.cut || exit - entry > 0.5 * interval;
    cursor.interval = cursor.cut ? interval : (exit - entry) / count;
    cursor.intervals = cursor.cut ? 1 : uint(count);
    cursor.lead = 0.0;
    if (jittered && !cursor.cut && count > 1.0)
    {
      cursor.lead = jitterOfPixel * cursor.interval;
      ++cursor.intervals;
    }
    // The field is continuous: the last point of the region before is the first of this one.
    cursor.known = cursor.known && cursor.exit == entry;
  }
  cursor.entry = entry;
  cursor.exit = exit;
  if (keepsIntervals)
  {
    isEmpty = !keepIntervalsOfPart(ray, entry, cursor);
  }
  if (isPart && isEmpty)
  {
    cursor.intervals = 0;
    cursor.exit = -1.0; // nothing is known behind it
  }
}
