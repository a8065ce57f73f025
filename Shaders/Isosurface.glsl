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

#ifdef FAMILY_SURFACE
// The second component where a surface of the first one is: of cells that of the one behind it.
float secondValueAt(Cursor cursor, Ray ray, float at)
{
  if (!isNearest)
  {
    return sampleComponent(cursor.brick, cursor.others, ray, at, 1u);
  }
  Brick holder;
  uvec3 cell;
  float end = cursor.exit;
  findHolder(cursor.brick, cursor.others, ray, at, end, holder, cell);
  return valueAt(holder, cellsOf(holder), cell, 1u);
}

// Colour, times opacity, and opacity of a surface, by the second variable too where there is one.
vec4 colorOfSurface(float isoValue, vec3 gradient, Cursor cursor, Ray ray, float at)
{
  const float second = componentCount > 1u ? secondValueAt(cursor, ray, at)
    : mapsGradient                        ? shareOfGradient(gradient)
                                          : 0.0;
  if (mixing == MIXING_PLANAR)
  {
    return colorOfPlanar(vec2(isoValue, second));
  }
  const TransferPart part = findPart(isoValue);
  const vec4 color = mix(part.lower, part.upper, part.fraction);
  if (mixing != MIXING_COLOR_AND_OPACITY)
  {
    return color;
  }
  selectFunction(1u);
  const TransferPart opacity = findPart(second);
  selectFunction(0u);
  return color / color.a * mix(opacity.lower.a, opacity.upper.a, opacity.fraction);
}
#else
vec4 colorOfSurface(float isoValue, vec3 gradient, Cursor cursor, Ray ray, float at)
{
  const TransferPart part = findPart(isoValue);
  return mix(part.lower, part.upper, part.fraction);
}
#endif

// What is seen of the field at a place: a surface of a value, or a slice where it has that value.
void addSurface(float value, Cursor cursor, Ray ray, float at, inout Accumulator gathered)
{
  vec3 gradient = vec3(0.0);
  if (isShaded || hasGradientOpacity || mapsGradient)
  {
    gradient = sampleFieldJet(cursor.brick, cursor.others, ray, at).xyz;
  }
  const Spot spot = spotAt(ray, cursor.brick, cursor.others, at, vec2(value), gradient);
  vec4 color = colorOfSurface(value, gradient, cursor, ray, at);
  if (hasGradientOpacity)
  {
    Spot opacitySpot = spot;
    if (mixing == MIXING_COLOR_AND_OPACITY)
    {
      opacitySpot.gradient =
        sampleComponentJet(cursor.brick, cursor.others, ray, at, 1u).xyz; // which has opacity
    }
    color *= opacityOfGradient(opacitySpot, 0u);
  }
  addBehind(color, 1.0, spot, gathered);
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
      if (isInPart(ray, at))
      {
        addSurface(isoValue, cursor, ray, at, gathered);
      }
    }
  }
}

// Whether a surface's value lies between two.
bool isAnyBetween(float a, float b)
{
  for (uint k = 0; k < constants.frame.isoValueCount; ++k)
  {
    const float isoValue = constants.frame.isoValues[k];
    if ((a < isoValue) != (b < isoValue))
    {
      return true;
    }
  }
  return false;
}

// The surfaces in an interval from the cursor's entry to `end`: `values` are those at both ends and,
// where there are two pieces, in the middle. Where the parabola through the three passes a surface's
// value and comes back, as at silhouettes, the field at its vertex tells whether it does.
void addSurfacesOfInterval(
  Cursor cursor, Ray ray, float end, int pieces, vec3 values, inout Accumulator gathered)
{
  const float length = end - cursor.entry;
  vec4 places = vec4(cursor.entry, pieces == 2 ? cursor.entry + 0.5 * length : end, end, end);
  vec4 there = vec4(values, values.z);
  if (pieces == 2)
  {
    const float bend = 2.0 * (values.x - 2.0 * values.y + values.z);
    const float slope = values.z - values.x - bend;
    const float vertex = -0.5 * slope / bend; // where nothing bends, it is nowhere
    const float most = values.x + vertex * (slope + vertex * bend);
    const float nearest = bend < 0.0 ? max(values.x, max(values.y, values.z))
                                     : min(values.x, min(values.y, values.z));
    if (vertex > 0.0 && vertex < 1.0 && isAnyBetween(nearest, most))
    {
      const float at = cursor.entry + vertex * length;
      const float value = sampleField(cursor.brick, cursor.others, ray, at);
      pieces = 3;
      places.yz = vertex < 0.5 ? vec2(at, places.y) : vec2(places.y, at);
      there.yz = vertex < 0.5 ? vec2(value, values.y) : vec2(values.y, value);
    }
  }
  // In a loop, as compilers take their time for each place where the field is sampled.
  for (int k = 0; k < pieces; ++k)
  {
    addSurfaces(cursor, ray, places[k], places[k + 1], there[k], there[k + 1], gathered);
  }
}
