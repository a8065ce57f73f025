// SPDX-License-Identifier: BSD-3-Clause
// One region of a ray: its bricks, the length of its intervals, and what they absorb.

// What a lane knows of the region it is in, and what it has gathered.
struct March
{
  Brick brick; // the first of the region's: most regions have one alone
  uint list;   // place of the rest in the lists; 0: there are none
  float entry;    // distance at which the next interval begins
  float exit;     // distance at which the ray leaves the region
  uint intervals; // number still to do; where they end at faces of cells: 0, or 1 for some
  vec4 color;     // premultiplied

  // Basis
  bool cut;           // intervals end at faces of cells, as some are absent
  float interval;     // greatest length of an interval; unless cut, a whole number fills the region
  bool halved;        // by a sample in its middle
  bool known;         // the point at `entry` is
  TransferPoint last; // it
};

// `step`: as in ActiveBox.
void enterRegion(uint firstBrick, float step, float entry, float exit, inout March march)
{
  march.list = firstBrick;
  march.brick = nextBrick(march.list);
  march.intervals = 1;
  if (!nearest)
  {
    // Samples at most a step apart, two to an interval, unless one alone does for the region. An error
    // behind what is opaque is seen less.
    march.cut = step < 0.0;
    const float interval = 2.0 * stepScale * abs(step) *
      exp2(-veiled * log2(max(1.0 - march.color.a, 1.0 / 1024.0)));
    const float count = max(ceil((exit - entry) / interval), 1.0);
    march.halved = march.cut || exit - entry > 0.5 * interval;
    march.interval = march.cut ? interval : (exit - entry) / count;
    march.intervals = march.cut ? 1 : uint(count);
    // The field is continuous: the last point of the region before is the first of this one.
    march.known = march.known && march.exit == entry;
  }
  march.entry = entry;
  march.exit = exit;
}

// The value of the cell that the ray is in, and where it leaves it. False: it is absent.
bool findCell(Ray ray, March march, out float end, out float value)
{
  end = march.exit;
  return sampleNearest(march.brick, march.list, ray, march.entry, end, value);
}

// Nearest: the value does not change up to the next face of a cell.
void marchCell(Ray ray, inout March march)
{
  float value;
  float end;
  if (findCell(ray, march, end, value))
  {
    const TransferPart part = findPart(transferBins, transferKnots, value);
    march.color += (1.0 - march.color.a) *
      absorb(mix(part.lower, part.upper, part.share),
        (end - march.entry) * ray.dataPerHalfCell * inverseUnit);
  }
  march.entry = end;
  march.intervals = end < march.exit ? 1 : 0;
}

// Where the next interval ends. False: there is nothing up to there.
bool findEnd(Ray ray, March march, out float end)
{
  if (!march.cut)
  {
    end = march.intervals == 1 ? march.exit : march.entry + march.interval;
    return true;
  }
  float value;
  const bool there = findCell(ray, march, end, value);
  const float count = ceil((end - march.entry) / march.interval);
  end = there && count > 1.0 ? march.entry + (end - march.entry) / count : end;
  return there;
}

// Basis: the next interval, over which the value goes evenly from the last point to the sample in
// the middle and on to the next point. At first, the point where the first interval begins.
void marchInterval(Ray ray, inout March march)
{
  float end;
  const bool there = findEnd(ray, march, end);
  const bool first = there && !march.known;
  if (there)
  {
    const float length = end - march.entry;
    const int count = march.halved && !first ? 2 : 1;
    float middle = 0.0;
    float value = 0.0;
    for (int k = 1; k <= count; ++k)
    {
      middle = value;
      value = sampleBasis(march.brick, march.list, ray,
        first ? march.entry : k == count ? end : march.entry + 0.5 * length);
    }
    // The middle that gives the halves together the mean of the parabola through all three (Simpson's
    // rule); but no value that lies beyond them, which the field may not take.
    const float last = march.last.value;
    middle = clamp((4.0 * middle - 0.5 * (last + value)) / 3.0, min(middle, min(last, value)),
      max(middle, max(last, value)));
    const float units = length / float(count) * ray.dataPerHalfCell * inverseUnit;
    for (int k = 1; k <= count; ++k)
    {
      const float next = k == count ? value : middle;
      const TransferPart part = findPart(transferBins, transferKnots, next);
      const TransferPoint point = makePoint(part, next, inverseIntegralUnit);
      if (!first)
      {
        march.color += (1.0 - march.color.a) *
          absorbBetween(
            transferBins, transferKnots, march.last, point, part, integralUnit, units);
      }
      march.last = point;
    }
  }
  march.known = there;
  if (!first)
  {
    march.entry = end;
    march.intervals = march.cut ? (end < march.exit ? 1 : 0) : march.intervals - 1;
  }
}

void marchOn(Ray ray, inout March march)
{
  if (nearest)
  {
    marchCell(ray, march);
  }
  else
  {
    marchInterval(ray, march);
  }
}
