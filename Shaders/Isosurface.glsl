// SPDX-License-Identifier: BSD-3-Clause
// Surfaces at which the field has one of some values, each with the colour and opacity of its value.
// The table holds opacity.

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
