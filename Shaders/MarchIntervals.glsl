// SPDX-License-Identifier: BSD-3-Clause
// Where the field is continuous: intervals over which it is taken to go evenly from the last point to
// the sample in the middle, and on to the next point.

// Where the next interval ends. False: there is nothing up to there but a cell without a value, and
// `absent` is what has come in its place.
bool findEnd(Ray ray, Cursor cursor, out float end, out float absent)
{
  absent = ABSENT;
  if (!cursor.cut)
  {
    const float length = jittered && cursor.lead > 0.0 ? cursor.lead : cursor.interval;
    end = cursor.intervals == 1 ? cursor.exit : cursor.entry + length;
    return true;
  }
  end = cursor.exit;
  const bool there = findCell(cursor.brick, cursor.others, ray, cursor.entry, end, absent);
  const float count = ceil((end - cursor.entry) / cursor.interval);
  end = there && count > 1.0 ? cursor.entry + (end - cursor.entry) / count : end;
  return there;
}

bool findEnd(Ray ray, Cursor cursor, out float end)
{
  float absent;
  return findEnd(ray, cursor, end, absent);
}

// What of an interval lies in the part that is drawn. What is gathered goes on from its end: points are
// where the next one begins.
void addPartOfInterval(float from, float to, float units, bool isFirst, vec2 part, Spot spot,
  inout Accumulator gathered)
{
  const bool isCut = part != vec2(0.0, 1.0) && !isFirst;
  const bool isEmpty = !(part.x < part.y);
  const float begin = mix(from, to, part.x);
  const float end = mix(from, to, part.y);
  // Where the piece begins, the piece, and where the interval ends: in a loop, as compilers take their
  // time for each place where intervals are added.
  for (int step = isCut ? (isEmpty ? 2 : 0) : 1; step <= (isCut && !isExtremum ? 2 : 1); ++step)
  {
    addInterval(step == 2 ? to : begin, step == 0 ? begin : step == 1 ? end : to,
      (part.y - part.x) * units, isFirst || step != 1, spot, gathered);
  }
}

// The next interval; at first, the point where the first one begins.
void marchInterval(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float end;
  float absent;
  const bool there = findEnd(ray, cursor, end, absent);
  const bool first = there && !cursor.known;
  if (there)
  {
    const float length = end - cursor.entry;
    const int count = cursor.halved && !first ? 2 : 1;
    float middle = 0.0;
    float value = 0.0;
    vec3 middleGradient = vec3(0.0);
    vec3 gradient = vec3(0.0);
    for (int k = 1; k <= count; ++k)
    {
      middle = value;
      middleGradient = gradient;
      const float at = first ? cursor.entry : k == count ? end : cursor.entry + 0.5 * length;
      if (needsGradient)
      {
        const vec4 jet = sampleFieldJet(cursor.brick, cursor.others, ray, at);
        gradient = jet.xyz;
        value = jet.w;
      }
      else
      {
        value = sampleField(cursor.brick, cursor.others, ray, at);
      }
    }
    // The middle that gives the halves together the mean of the parabola through all three (Simpson's
    // rule); but no value that lies beyond them, which the field may not take.
    const float last = cursor.value;
    if (count == 2 && isInPart(ray, cursor.entry) && isInPart(ray, end))
    {
      addSamples(last, middle, value, gathered);
    }
    middle = clamp((4.0 * middle - 0.5 * (last + value)) / 3.0, min(middle, min(last, value)),
      max(middle, max(last, value)));
    const float units = length / float(count) * ray.unitsPerHalfCell;
    for (int k = 1; k <= count; ++k)
    {
      const float next = k == count ? value : middle;
      const vec3 nextGradient = k == count ? gradient : middleGradient;
      const Spot spot = spotAt(ray, cursor.brick, cursor.others,
        cursor.entry + (float(k) - 0.5) / float(count) * length, vec2(cursor.value, next),
        0.5 * (cursor.gradient + nextGradient));
      if (isPart)
      {
        const float begin = cursor.entry + float(k - 1) / float(count) * length;
        addPartOfInterval(cursor.value, next, units, first,
          first ? vec2(0.0, 1.0) : keptOf(ray, begin, begin + length / float(count)), spot, gathered);
      }
      else
      {
        addInterval(cursor.value, next, units, first, spot, gathered);
      }
      cursor.value = next;
      cursor.gradient = nextGradient;
    }
  }
  else
  {
    addAbsent(absent, (end - cursor.entry) * ray.unitsPerHalfCell, gathered);
  }
  cursor.known = there;
  if (!first)
  {
    endInterval(end, cursor);
  }
}
