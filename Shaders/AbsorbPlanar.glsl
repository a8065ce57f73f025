// SPDX-License-Identifier: BSD-3-Clause
// The medium of a function of two variables: of a component and its gradient, or of two components
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

// Values go evenly from one place of the function's plane to another. A way in a plane has no table of
// integrals: so many samples are taken that no pixel of the function is passed over, but for the
// longest ways.
const float MOST_PLANAR_SAMPLES = 32.0;

vec4 absorbPlanar(Piece piece)
{
  Colors table = Colors(constants.frame.planar);
  const ivec2 size = constants.frame.planarSize;
  const vec2 way = abs(piece.to.xy - piece.from.xy) * vec2(size);
  const float count = clamp(ceil(max(way.x, way.y)), 1.0, MOST_PLANAR_SAMPLES);
  vec4 gathered = vec4(0.0);
  for (float i = 0.5; i < count; ++i)
  {
    const vec4 color = lookUpPlanar(table, size, mix(piece.from.xy, piece.to.xy, i / count));
    const float amount = color.a < 1.0 ? min(-log(1.0 - color.a), DENSEST) : DENSEST;
    gathered += (1.0 - gathered.a) * absorb(amount * vec4(color.rgb, 1.0), piece.units / count);
  }
  if (isShaded && gathered.a > 0.0)
  {
    gathered = shade(gathered, spotOfComponent(piece, 0u), 0u);
  }
  return gathered;
}
