// SPDX-License-Identifier: BSD-3-Clause
// The greatest or the least value along the ray. The table holds opacity, for this one value.

void widenTo(float value, inout Accumulator gathered)
{
  gathered.value = blending == BLENDING_MAXIMUM ? max(gathered.value, value)
                                                : min(gathered.value, value);
}

// The vertex of the parabola through three values at equal distances, if it lies between them.
void widenToVertex(float first, float middle, float last, inout Accumulator gathered)
{
  const float bend = 2.0 * (first - 2.0 * middle + last);
  const float slope = last - first - bend;
  const float where = -0.5 * slope / bend; // where nothing bends, it is nowhere
  if (where > 0.0 && where < 1.0)
  {
    widenTo(clamp(first + where * (slope + where * bend), 0.0, 1.0), gathered);
  }
}

vec4 colorOfExtremum(Accumulator gathered)
{
  if (!(gathered.value >= 0.0 && gathered.value <= 1.0))
  {
    return vec4(0.0); // as at the start: the ray has met no value
  }
  const TransferPart part = findPart(gathered.value);
  return mix(part.lower, part.upper, part.fraction);
}
