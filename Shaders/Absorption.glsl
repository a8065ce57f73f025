// SPDX-License-Identifier: BSD-3-Clause
// What a length of the ray absorbs and emits: colour, times opacity, and opacity.

// Colour, times opacity, and opacity of a length of the ray in unit distances. What is opaque is so
// at any length.
vec4 absorb(vec4 extinction, float units)
{
  const float depth = extinction.a * units;
  // 1 - exp(-depth), without the loss of digits where it is small.
  float alpha =
    depth < 0.02 ? depth * (1.0 - depth * (0.5 - depth * (1.0 / 6.0))) : 1.0 - exp(-depth);
  alpha = extinction.a > 0.99999 * DENSEST ? 1.0 : alpha;
  return extinction.a > 0.0 ? extinction * (alpha / extinction.a) : vec4(0.0);
}

// An interval that becomes opaque on its way, at any length: what is before that place, and the
// colour there.
vec4 absorbUpToSurface(
  TransferPoint from, TransferPoint to, vec2 values, TransferPart part, float units)
{
  float before = values.x;
  float behind = values.y;
  for (int halving = 0; halving < 64; ++halving)
  {
    const float middle = 0.5 * (before + behind);
    if (middle == before || middle == behind)
    {
      break;
    }
    const TransferPart there = findPart(middle);
    if (there.opaque == from.opaque)
    {
      before = middle;
    }
    else
    {
      behind = middle;
      part = there;
    }
  }
  const TransferPart last = findPart(before);
  const vec4 veil =
    absorb(meanBetween(from, makePoint(last), vec2(values.x, before), last),
      units * (before - values.x) / (values.y - values.x));
  // No value lies in an opaque part of no width.
  const vec4 surface = mix(part.lower, part.upper, part.fraction);
  return (part.opaque & 1) != 0 ? veil + (1.0 - veil.a) * surface / surface.a : veil;
}

// Colour, times opacity, and opacity of an interval of some unit distances, over which the value
// goes evenly from one point to the other. `values`: theirs. `part`: of the second one.
vec4 absorbBetween(
  TransferPoint from, TransferPoint to, vec2 values, TransferPart part, float units)
{
  if ((from.opaque & 1) != 0)
  {
    const TransferPart surface = findPart(values.x);
    const vec4 extinction = mix(surface.lower, surface.upper, surface.fraction);
    return extinction / extinction.a;
  }
  if (from.opaque != to.opaque)
  {
    return absorbUpToSurface(from, to, values, part, units);
  }
  return absorb(meanBetween(from, to, values, part), units);
}
