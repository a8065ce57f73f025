// SPDX-License-Identifier: BSD-3-Clause
// Blending by absorption and emission, front to back. A way of blending is a struct Accumulator and
// the functions below.

struct Accumulator
{
  vec4 color;         // premultiplied
  TransferPoint last; // of the value at which the ray is, where the field is continuous
};

Accumulator startAccumulator()
{
  Accumulator gathered;
  gathered.color = vec4(0.0);
  return gathered;
}

// Whether nothing that comes behind counts.
bool isOpaque(Accumulator gathered)
{
  return gathered.color.a >= terminationOpacity;
}

// How much longer intervals may be: an error behind what is opaque is seen less.
float growthOfIntervals(Accumulator gathered)
{
  return exp2(-transmittanceExponent * log2(max(1.0 - gathered.color.a, 1.0 / 1024.0)));
}

// A length of the ray, in unit distances, at all of which the field has one value.
void addConstant(float value, float units, inout Accumulator gathered)
{
  const TransferPart part = findPart(value);
  gathered.color +=
    (1.0 - gathered.color.a) * absorb(mix(part.lower, part.upper, part.fraction), units);
}

// A length of the ray over which the field goes evenly from the one value to the other, from where
// the last one ended. `isFirst`: there was none, and this is but the point where the next begins.
void addInterval(
  float from, float to, float units, bool isFirst, inout Accumulator gathered)
{
  const TransferPart part = findPart(to);
  const TransferPoint point = makePoint(part);
  if (!isFirst)
  {
    gathered.color += (1.0 - gathered.color.a) *
      absorbBetween(gathered.last, point, vec2(from, to), part, units);
  }
  gathered.last = point;
}

// Premultiplied red, green, blue, opacity.
vec4 toPixel(Accumulator gathered)
{
  return gathered.color;
}
