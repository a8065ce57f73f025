// SPDX-License-Identifier: BSD-3-Clause
// Colour and opacity (of the unit distance) of a normalised value, exact at the control points.

vec4 transfer(TransferBins bins, TransferKnots knots, float value)
{
  const float x = clamp(value, 0.0, 1.0) * float(TRANSFER_BINS);
  const int i = min(int(x), TRANSFER_BINS - 1);
  const TransferBin bin = bins.items[i];
  if (bin.lower.a >= 0.0)
  {
    return mix(bin.lower, bin.upper, x - float(i));
  }
  int knot = int(-1.0 - bin.lower.a);
  while (knots.items[knot + 1].value <= value)
  {
    ++knot;
  }
  const TransferKnot a = knots.items[knot];
  const TransferKnot b = knots.items[knot + 1];
  return mix(a.color, b.color, (value - a.value) / (b.value - a.value));
}
