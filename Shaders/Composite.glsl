// SPDX-License-Identifier: BSD-3-Clause
// Blending by absorption and emission, front to back. The table holds extinction.

// What comes next, of some unit distances: premultiplied colour and opacity.
void addBehind(vec4 color, float units, Spot spot, inout Accumulator gathered)
{
  if (isShaded && color.a > 0.0)
  {
    color = shade(color, opacityOfUnit(color.a, units), spot, 0u);
  }
  gathered.color += (1.0 - gathered.color.a) * color;
}

void compositeConstant(float value, float units, Spot spot, inout Accumulator gathered)
{
  const TransferPart part = findPart(value);
  units *= hasGradientOpacity ? opacityOfGradient(spot, 0u) : 1.0;
  addBehind(absorb(mix(part.lower, part.upper, part.fraction), units), units, spot, gathered);
}

void compositeInterval(
  float from, float to, float units, bool isFirst, Spot spot, inout Accumulator gathered)
{
  const TransferPart part = findPart(to);
  const TransferPoint point = makePoint(part);
  if (!isFirst)
  {
    units *= hasGradientOpacity ? opacityOfGradient(spot, 0u) : 1.0;
    addBehind(absorbBetween(gathered.last, point, vec2(from, to), part, units), units, spot,
      gathered);
  }
  gathered.last = point;
}
