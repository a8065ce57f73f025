// SPDX-License-Identifier: BSD-3-Clause
// The integral along the ray of values times their opacity, or its mean over the length on which
// values count. The table holds that product in its colours, and opacity.

// The fraction of the values from one to the other that counts.
float fractionThatCounts(float from, float to, vec2 range)
{
  if (blending == BLENDING_ADDITIVE)
  {
    return 1.0;
  }
  const float least = min(from, to);
  const float most = max(from, to);
  if (most - least < 1e-6)
  {
    return to >= range.x && to <= range.y ? 1.0 : 0.0;
  }
  return max(min(most, range.y) - max(least, range.x), 0.0) / (most - least);
}

void sumConstant(float value, float units, inout Accumulator gathered)
{
  const TransferPart part = findPart(value);
  gathered.color += mix(part.lower, part.upper, part.fraction) * units;
  gathered.counted += fractionThatCounts(value, value, averageRange) * units;
}

void sumInterval(float from, float to, float units, bool isFirst, inout Accumulator gathered)
{
  const TransferPart part = findPart(to);
  const TransferPoint point = makePoint(part);
  if (!isFirst)
  {
    gathered.color += meanBetween(gathered.last, point, vec2(from, to), part) * units;
    gathered.counted += fractionThatCounts(from, to, averageRange) * units;
  }
  gathered.last = point;
}

vec4 colorOfSum(Accumulator gathered)
{
  if (!(gathered.counted > 0.0))
  {
    return vec4(0.0);
  }
  const float divisor = blending == BLENDING_AVERAGE ? gathered.counted : 1.0;
  return vec4(vec3(clamp(gathered.color.r / divisor, 0.0, 1.0)), 1.0);
}
