// SPDX-License-Identifier: BSD-3-Clause
// The colour at the place where a ray passes a plane: there its one segment begins (Segments.glsl). The
// table holds opacity.
void marchSlice(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float value;
  float end = cursor.exit;
  if (findCell(cursor.brick, cursor.others, ray, cursor.entry, end, value))
  {
    vec3 gradient = vec3(0.0);
    if (isShaded || hasGradientOpacity || mapsGradient)
    {
      gradient = sampleFieldJet(cursor.brick, cursor.others, ray, cursor.entry).xyz;
    }
    if (!isNearest)
    {
      value = sampleField(cursor.brick, cursor.others, ray, cursor.entry);
    }
    addFlat(colorOfSurface(value, gradient, cursor, ray, cursor.entry),
      spotAt(ray, cursor.brick, cursor.entry, gradient), gathered);
    gathered.value = value; // it is complete
  }
  else if (showsUndefined && value == UNDEFINED)
  {
    gathered.color = absorb(constants.frame.undefined, 1.0);
    gathered.value = value;
  }
  cursor.entry = cursor.exit;
  cursor.intervals = 0;
}
