// SPDX-License-Identifier: BSD-3-Clause
// The colour at the place where a ray passes a plane: there its one segment begins (Segments.glsl). The
// table holds opacity.
void marchSlice(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float value;
  float end = cursor.exit;
  if (findCell(cursor.brick, cursor.others, ray, cursor.entry, end, value))
  {
    if (!isNearest)
    {
      value = sampleField(cursor.brick, cursor.others, ray, cursor.entry);
    }
    addSurface(value, cursor, ray, cursor.entry, gathered);
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
