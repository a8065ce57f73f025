// SPDX-License-Identifier: BSD-3-Clause
// The march through several components: cell by cell, or by intervals as MarchIntervals.glsl has them.

void addComponents(Ray ray, Cursor cursor, vec4 from, vec4 to, float length,
  inout Accumulator gathered)
{
  addBehind(absorbComponents(from, to, length * ray.unitsPerHalfCell),
    spotAt(ray, cursor.brick, cursor.entry, vec3(0.0)), gathered);
}

void marchComponentsOfCell(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  Brick holder;
  uvec3 cell;
  float end = cursor.exit;
  findHolder(cursor.brick, cursor.others, ray, cursor.entry, end, holder, cell);
  const uvec3 n = cellsOf(holder);
  vec4 values = vec4(0.0);
  for (uint k = 0u; k < componentCount; ++k)
  {
    values[k] = valueAt(holder, n, cell, k);
  }
  if (values.x >= 0.0) // a cell has all of its components, or none
  {
    addComponents(ray, cursor, values, values, end - cursor.entry, gathered);
  }
  endCell(end, cursor);
}

void marchComponentsOfInterval(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float end;
  const bool there = findEnd(ray, cursor, end);
  const bool first = there && !cursor.known;
  if (there)
  {
    const float length = end - cursor.entry;
    const int count = cursor.halved && !first ? 2 : 1;
    vec4 middle = vec4(0.0);
    vec4 values = vec4(0.0);
    for (int k = 1; k <= count; ++k)
    {
      middle = values;
      const float at = first ? cursor.entry : k == count ? end : cursor.entry + 0.5 * length;
      values = sampleComponents(cursor, ray, at);
    }
    const vec4 last = cursor.values;
    middle = clamp((4.0 * middle - 0.5 * (last + values)) / 3.0, min(middle, min(last, values)),
      max(middle, max(last, values)));
    for (int k = 1; k <= count; ++k)
    {
      const vec4 next = k == count ? values : middle;
      if (!first)
      {
        addComponents(ray, cursor, cursor.values, next, length / float(count), gathered);
      }
      cursor.values = next;
    }
  }
  cursor.known = there;
  if (!first)
  {
    endInterval(end, cursor);
  }
}

void marchComponents(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  if (isNearest)
  {
    marchComponentsOfCell(ray, cursor, gathered);
  }
  else
  {
    marchComponentsOfInterval(ray, cursor, gathered);
  }
}
