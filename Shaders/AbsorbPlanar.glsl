// SPDX-License-Identifier: BSD-3-Clause
// What pieces of a ray show by a function of two variables (Planar.glsl).

// Values go evenly from one place of the function's plane to another. A way in a plane has no table of
// integrals: so many samples are taken that no pixel of the function is passed over, but for the
// longest ways.
const float MOST_PLANAR_SAMPLES = 32.0;

float countPlanarSamples(vec2 from, vec2 to, ivec2 size)
{
  const vec2 way = abs(to - from) * vec2(size);
  return clamp(ceil(max(way.x, way.y)), 1.0, MOST_PLANAR_SAMPLES);
}

vec4 absorbPlanar(Piece piece)
{
  Colors table = Colors(constants.frame.planar);
  const ivec2 size = constants.frame.planarSize;
  const float count = countPlanarSamples(piece.from.xy, piece.to.xy, size);
  vec4 gathered = vec4(0.0);
  for (float i = 0.5; i < count; ++i)
  {
    const vec4 color = lookUpPlanar(table, size, mix(piece.from.xy, piece.to.xy, i / count));
    const float amount = color.a < 1.0 ? min(-log(1.0 - color.a), DENSEST) : DENSEST;
    gathered += (1.0 - gathered.a) * absorb(amount * vec4(color.rgb, 1.0), piece.units / count);
  }
  if (isShaded && gathered.a > 0.0)
  {
    gathered = shade(
      gathered, opacityOfUnit(gathered.a, piece.units), spotOfComponent(piece, 0u), 0u);
  }
  return gathered;
}

// The integral of the first variable times opacity, and the length on which it counts.
void sumPlanar(Piece piece, inout Accumulator gathered)
{
  const vec2 range =
    vec2(constants.frame.leastToAverage.x, constants.frame.mostToAverage.x);
  const float counted = fractionThatCounts(piece.from.x, piece.to.x, range);
  if (!(counted > 0.0))
  {
    return;
  }
  // Where what counts begins, on the way from the one place to the other.
  const float rise = piece.to.x - piece.from.x;
  const float first = counted < 1.0
    ? clamp(((rise > 0.0 ? range.x : range.y) - piece.from.x) / rise, 0.0, 1.0 - counted)
    : 0.0;
  const vec2 from = mix(piece.from.xy, piece.to.xy, first);
  const vec2 to = mix(piece.from.xy, piece.to.xy, first + counted);
  Colors table = Colors(constants.frame.planar);
  const ivec2 size = constants.frame.planarSize;
  const float count = countPlanarSamples(from, to, size);
  float sum = 0.0;
  for (float i = 0.5; i < count; ++i)
  {
    const vec2 at = mix(from, to, i / count);
    sum += at.x * lookUpPlanar(table, size, at).a;
  }
  gathered.sums[0] += counted * piece.units / count * sum;
  gathered.counts[0] += counted * piece.units;
}
