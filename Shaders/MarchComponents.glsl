// SPDX-License-Identifier: BSD-3-Clause
// The march through several components: cell by cell, or by intervals as MarchIntervals.glsl has them.

// The cell's values; below 0: it is absent. A cell has all of its components, or none.
vec4 componentsOfCell(Ray ray, Cursor cursor, inout float end)
{
  Brick holder;
  uvec3 cell;
  findHolder(cursor.brick, cursor.others, ray, cursor.entry, end, holder, cell);
  const uvec3 n = cellsOf(holder);
  vec4 values = vec4(0.0);
  for (uint k = 0u; k < componentCount; ++k)
  {
    values[k] = valueAt(holder, n, cell, k);
  }
  return values;
}

void addComponents(Piece piece, inout Accumulator gathered)
{
  if (isExtremum)
  {
    widenComponentsTo(piece.to, gathered);
  }
  else if (isComposite)
  {
    const vec4 color =
      mixing == MIXING_PLANAR ? absorbPlanar(piece) : absorbComponents(piece);
    gathered.color += (1.0 - gathered.color.a) * color;
  }
  else if (mixing == MIXING_PLANAR)
  {
    sumPlanar(piece, gathered);
  }
  else
  {
    sumComponents(piece, gathered);
  }
}

void marchComponentsOfCell(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float end = cursor.exit;
  vec4 values = componentsOfCell(ray, cursor, end);
  if (values.x >= 0.0)
  {
    const float middle = 0.5 * (cursor.entry + end);
    mat4x3 gradients = mat4x3(0.0);
    if (needsGradient)
    {
      const vec4 sampled = sampleComponents(cursor, ray, middle, gradients);
      values.y = mapsGradient ? sampled.y : values.y;
    }
    addComponents(Piece(values, values, (end - cursor.entry) * ray.unitsPerHalfCell, gradients,
                    spotAt(ray, cursor.brick, cursor.others, middle, vec2(0.0), vec3(0.0))),
      gathered);
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
    mat4x3 middleGradients = mat4x3(0.0);
    mat4x3 gradients = mat4x3(0.0);
    for (int k = 1; k <= count; ++k)
    {
      middle = values;
      middleGradients = gradients;
      const float at = first ? cursor.entry : k == count ? end : cursor.entry + 0.5 * length;
      values = sampleComponents(cursor, ray, at, gradients);
    }
    const vec4 last = cursor.values;
    if (isExtremum && count == 2)
    {
      widenComponentsToVertices(last, middle, values, gathered);
    }
    middle = clamp((4.0 * middle - 0.5 * (last + values)) / 3.0, min(middle, min(last, values)),
      max(middle, max(last, values)));
    const float units = length / float(count) * ray.unitsPerHalfCell;
    for (int k = 1; k <= count; ++k)
    {
      const vec4 next = k == count ? values : middle;
      const mat4x3 nextGradients = k == count ? gradients : middleGradients;
      if (!first || isExtremum)
      {
        const float at = cursor.entry + (float(k) - 0.5) / float(count) * length;
        const vec4 from = first ? next : cursor.values;
        const float reach = 0.5 / float(count) * length;
        const vec2 part = first ? vec2(0.0, 1.0) : keptOf(ray, at - reach, at + reach);
        if (part.x < part.y)
        {
          addComponents(Piece(isPart ? mix(from, next, part.x) : from,
                          isPart ? mix(from, next, part.y) : next,
                          isPart ? (part.y - part.x) * units : units,
                          0.5 * (cursor.gradients + nextGradients),
                          spotAt(ray, cursor.brick, cursor.others, at, vec2(0.0), vec3(0.0))),
            gathered);
        }
      }
      cursor.values = next;
      cursor.gradients = nextGradients;
    }
  }
  cursor.known = there;
  if (!first)
  {
    endInterval(end, cursor);
  }
}

// The values at the place where a ray passes a plane: there its one segment begins (Segments.glsl).
void marchComponentsOfSlice(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float end = cursor.exit;
  vec4 values = componentsOfCell(ray, cursor, end);
  if (values.x >= 0.0)
  {
    mat4x3 gradients = mat4x3(0.0);
    if (!isNearest || needsGradient)
    {
      const vec4 sampled = sampleComponents(cursor, ray, cursor.entry, gradients);
      values = !isNearest ? sampled : mapsGradient ? vec4(values.x, sampled.yzw) : values;
    }
    gathered.color = colorOfComponents(
      Piece(values, values, 0.0, gradients,
        spotAt(ray, cursor.brick, cursor.others, cursor.entry, vec2(0.0), vec3(0.0))));
    gathered.value = 0.0; // it is complete
  }
  cursor.entry = cursor.exit;
  cursor.intervals = 0;
}

void marchComponents(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  if (isSlice)
  {
    marchComponentsOfSlice(ray, cursor, gathered);
  }
  else if (isNearest)
  {
    marchComponentsOfCell(ray, cursor, gathered);
  }
  else
  {
    marchComponentsOfInterval(ray, cursor, gathered);
  }
}
