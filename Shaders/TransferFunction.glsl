// SPDX-License-Identifier: BSD-3-Clause
// Extinction (of the unit distance, times red, green, blue, 1) of a normalised value; and its mean
// over all values between two, so that an interval misses nothing that the field passes on its way.

// The straight part of the function that a value is in.
struct TransferPart
{
  int number; // bins first, then the parts between knots
  float share; // of the value on the way from its lower to its upper end
  float width; // in values
  vec4 lower; // extinction at its ends
  vec4 upper;
  ivec4 integral; // up to its lower end
  int opaque;
};

vec2 unpack(uint64_t word) { return uintBitsToFloat(unpackUint2x32(word)); }

TransferBin readBin(TransferBins bins, uint i)
{
  const uint at = TRANSFER_BIN_WORDS * i;
  TransferBin bin;
  bin.lower = vec4(unpack(bins.words[at]), unpack(bins.words[at + 1u]));
  bin.upper = vec4(unpack(bins.words[at + 2u]), unpack(bins.words[at + 3u]));
  bin.integral =
    ivec4(unpackUint2x32(bins.words[at + 4u]), unpackUint2x32(bins.words[at + 5u]));
  bin.opaque = int(bins.words[at + 6u]);
  return bin;
}

TransferPart findPart(TransferBins bins, TransferKnots knots, float value)
{
  const float x = clamp(value, 0.0, 1.0) * float(TRANSFER_BINS);
  const float whole = min(floor(x), float(TRANSFER_BINS - 1));
  const uint i = min(toIndex(whole), uint(TRANSFER_BINS - 1)); // a NaN too is some bin's
  const TransferBin bin = readBin(bins, i);
  if (bin.lower.a >= 0.0)
  {
    return TransferPart(int(i), x - whole, 1.0 / float(TRANSFER_BINS), bin.lower, bin.upper,
      bin.integral, bin.opaque);
  }
  int k = bin.integral.x;
  int end = k + bin.integral.y;
  while (end - k > 1)
  {
    const int middle = (k + end) / 2;
    if (knots.items[middle].value <= value)
    {
      k = middle;
    }
    else
    {
      end = middle;
    }
  }
  const TransferKnot knot = knots.items[k];
  const float width = knots.items[k + 1].value - knot.value;
  return TransferPart(TRANSFER_BINS + k, (value - knot.value) / width, width, knot.lower,
    knot.upper, knot.integral, knot.opaque);
}

// What has to be kept of a value, to find the mean to the next one.
struct TransferPoint
{
  float value;
  int number;
  float share;
  ivec4 integral; // from 0 to the lower end of the part
  vec4 inside;    // from there to the value, in the same units
  int opaque;
};

TransferPoint makePoint(TransferPart part, float value, float inverseIntegralUnit)
{
  const vec4 inside = mix(part.lower, part.upper, 0.5 * part.share);
  return TransferPoint(value, part.number, part.share,
    part.integral, inside * (part.share * part.width * inverseIntegralUnit), part.opaque);
}

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

// Mean extinction over the values between two points. `part`: of the second one.
vec4 meanBetween(TransferPoint from, TransferPoint to, TransferPart part, float integralUnit)
{
  const float way = to.value - from.value;
  const vec4 between = vec4(to.integral - from.integral) + (to.inside - from.inside);
  // Quotients of small differences have few digits: then the function is as good as constant.
  if (from.number == to.number || (abs(way) < 1e-5 && abs(between.a) < 1000.0))
  {
    return mix(part.lower, part.upper,
      from.number == to.number ? 0.5 * (from.share + to.share) : to.share);
  }
  const vec4 mean = max(between * (integralUnit / way), vec4(0.0));
  return vec4(min(mean.rgb, mean.a), mean.a); // no colour is above 1, but for rounding
}

// An interval that becomes opaque on its way, at any length: what is before that place, and the
// colour there.
vec4 absorbUpToSurface(TransferBins bins, TransferKnots knots, TransferPoint from, TransferPoint to,
  TransferPart part, float integralUnit, float units)
{
  float before = from.value;
  float behind = to.value;
  for (int halving = 0; halving < 64; ++halving)
  {
    const float middle = 0.5 * (before + behind);
    if (middle == before || middle == behind)
    {
      break;
    }
    const TransferPart there = findPart(bins, knots, middle);
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
  const TransferPart last = findPart(bins, knots, before);
  const vec4 veil =
    absorb(meanBetween(from, makePoint(last, before, 1.0 / integralUnit), last, integralUnit),
      units * (before - from.value) / (to.value - from.value));
  // No value lies in an opaque part of no width.
  const vec4 surface = mix(part.lower, part.upper, part.share);
  return (part.opaque & 1) != 0 ? veil + (1.0 - veil.a) * surface / surface.a : veil;
}

// Colour, times opacity, and opacity of an interval of some unit distances, over which the value
// goes evenly from one point to the other. `part`: of the second one.
vec4 absorbBetween(TransferBins bins, TransferKnots knots, TransferPoint from, TransferPoint to,
  TransferPart part, float integralUnit, float units)
{
  if ((from.opaque & 1) != 0)
  {
    const TransferPart surface = findPart(bins, knots, from.value);
    const vec4 extinction = mix(surface.lower, surface.upper, surface.share);
    return extinction / extinction.a;
  }
  if (from.opaque != to.opaque)
  {
    return absorbUpToSurface(bins, knots, from, to, part, integralUnit, units);
  }
  return absorb(meanBetween(from, to, part, integralUnit), units);
}
