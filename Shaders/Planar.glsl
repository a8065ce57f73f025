// SPDX-License-Identifier: BSD-3-Clause
// A function of two variables: of a component and its gradient, or of two components
// (Core/TransferFunction2D.h).

// Red, green, blue and opacity, bilinear between the middles of the table's pixels.
vec4 lookUpPlanar(Colors table, ivec2 size, vec2 variables)
{
  const vec2 at = clamp(variables * vec2(size) - 0.5, vec2(0.0), vec2(size - 1));
  const vec2 whole = floor(at);
  const vec2 fraction = at - whole;
  const uvec2 first = toIndex(whole.xyy).xy;
  const uvec2 last = min(first + 1u, uvec2(size) - 1u);
  const uint width = uint(size.x);
  return mix(
    mix(table.items[first.x + width * first.y], table.items[last.x + width * first.y], fraction.x),
    mix(table.items[first.x + width * last.y], table.items[last.x + width * last.y], fraction.x),
    fraction.y);
}

// The same, of what has no length: colour, times opacity, and opacity.
vec4 colorOfPlanar(vec2 variables)
{
  const vec4 color =
    lookUpPlanar(Colors(constants.frame.planar), constants.frame.planarSize, variables);
  return vec4(color.rgb * color.a, color.a);
}
