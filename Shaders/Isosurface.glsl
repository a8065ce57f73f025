// SPDX-License-Identifier: BSD-3-Clause
// Surfaces at which the field has one of some values, each with the colour and opacity of its value.
// The table holds opacity.

// Where the field passes a value, between two distances on whose other sides of it they lie: by false
// position, in which an end that stays counts half each time (the Illinois rule).
float findCrossing(
  Cursor cursor, Ray ray, float isoValue, float from, float to, float valueFrom, float valueTo)
{
  float before = valueFrom - isoValue;
  float behind = valueTo - isoValue;
  for (int step = 0; step < 4; ++step)
  {
    const float at = from - before * (to - from) / (behind - before);
    const float value = sampleField(cursor.brick, cursor.others, ray, at) - isoValue;
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
    if (value == 0.0)
    {
      return at;
    }
  }
  return from - before * (to - from) / (behind - before);
}

void addSurface(float isoValue, Cursor cursor, Ray ray, float at, inout Accumulator gathered)
{
  const TransferPart part = findPart(isoValue);
  vec3 gradient = vec3(0.0);
  if (isShaded)
  {
    gradient = sampleFieldJet(cursor.brick, cursor.others, ray, at).xyz;
  }
  addBehind(mix(part.lower, part.upper, part.fraction), spotAt(ray, cursor.brick, at, gradient),
    gathered);
}

// The surfaces that the ray passes from one distance and value to another. Where the values are those
// of cells, it does so at `from`.
void addSurfaces(Cursor cursor, Ray ray, float from, float to, float valueFrom, float valueTo,
  inout Accumulator gathered)
{
  const uint count = constants.frame.isoValueCount;
  for (uint k = 0; k < count; ++k)
  {
    const float isoValue = constants.frame.isoValues[valueTo > valueFrom ? k : count - 1u - k];
    if ((valueFrom < isoValue) != (valueTo < isoValue))
    {
      const float at = isNearest
        ? from
        : findCrossing(cursor, ray, isoValue, from, to, valueFrom, valueTo);
      addSurface(isoValue, cursor, ray, at, gathered);
    }
  }
}
