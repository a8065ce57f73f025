// SPDX-License-Identifier: BSD-3-Clause
// Blending by absorption and emission, front to back. The table holds extinction.

void compositeConstant(float value, float units, inout Accumulator gathered)
{
  const TransferPart part = findPart(value);
  gathered.color +=
    (1.0 - gathered.color.a) * absorb(mix(part.lower, part.upper, part.fraction), units);
}

void compositeInterval(
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
