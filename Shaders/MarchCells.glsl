// SPDX-License-Identifier: BSD-3-Clause
// Nearest: the field has the value of the leaf cell that the ray is in, and does not change up to the
// next face of a cell, so the integral is exact.
void marchCell(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float value;
  float end = cursor.exit;
  if (findCell(cursor.brick, cursor.others, ray, cursor.entry, end, value))
  {
    const float middle = 0.5 * (cursor.entry + end);
    vec3 gradient = vec3(0.0);
    if (needsGradient)
    {
      gradient = sampleFieldJet(cursor.brick, cursor.others, ray, middle).xyz;
    }
    addConstant(value, (end - cursor.entry) * ray.unitsPerHalfCell,
      spotAt(ray, cursor.brick, cursor.others, middle, vec2(value), gradient), gathered);
  }
  else
  {
    addAbsent(value, (end - cursor.entry) * ray.unitsPerHalfCell, gathered);
    cursor.known = false;
  }
  endCell(end, cursor);
}
