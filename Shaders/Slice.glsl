// SPDX-License-Identifier: BSD-3-Clause
// The value at the place where a ray passes a plane: there its one segment begins (Segments.glsl). The
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
    gathered.value = value;
  }
  cursor.entry = cursor.exit;
  cursor.intervals = 0;
}
