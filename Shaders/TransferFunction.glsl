// SPDX-License-Identifier: BSD-3-Clause
// Extinction (of the unit distance, times red, green, blue, 1) of a normalised value; and its mean
// over all values between two, so that an interval misses nothing that the field passes on its way.

// The straight part of the function that a value is in.
struct TransferPart
{
  int number; // bins first, then the parts between knots
  float fraction; // of the value on the way from its lower to its upper end
  float width; // in values
  vec4 lower; // extinction at its ends
  vec4 upper;
  ivec4 integral; // up to its lower end
  int opaque;
};

// Of several functions, which one is looked up.
#if defined(FAMILY_COMPONENTS) || defined(FAMILY_SURFACE)
uint firstBin = 0u;
void selectFunction(uint number)
{
  firstBin = number * uint(TRANSFER_BINS);
  integralUnit = constants.frame.integralUnits[number];
  inverseIntegralUnit = 1.0 / integralUnit;
}
#else
const uint firstBin = 0u;
#endif

vec2 unpackFloats(Word word) { return uintBitsToFloat(unpackWord(word)); }

TransferBin readBin(uint i)
{
  const uint at = TRANSFER_BIN_WORDS * (firstBin + i);
  TransferBin bin;
  bin.lower = vec4(unpackFloats(transferBins.words[at]), unpackFloats(transferBins.words[at + 1u]));
  bin.upper =
    vec4(unpackFloats(transferBins.words[at + 2u]), unpackFloats(transferBins.words[at + 3u]));
  bin.integral =
    ivec4(unpackWord(transferBins.words[at + 4u]), unpackWord(transferBins.words[at + 5u]));
  bin.opaque = int(unpackWord(transferBins.words[at + 6u]).x);
  return bin;
}

TransferPart findPart(float value)
{
  const float x = clamp(value, 0.0, 1.0) * float(TRANSFER_BINS);
  const float whole = min(floor(x), float(TRANSFER_BINS - 1));
  const uint i = min(toIndex(whole), uint(TRANSFER_BINS - 1)); // a NaN too is some bin's
  const TransferBin bin = readBin(i);
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
    if (transferKnots.items[middle].value <= value)
    {
      k = middle;
    }
    else
    {
      end = middle;
    }
  }
  const TransferKnot knot = transferKnots.items[k];
  const float width = transferKnots.items[k + 1].value - knot.value;
  return TransferPart(TRANSFER_BINS + k, (value - knot.value) / width, width, knot.lower,
    knot.upper, knot.integral, knot.opaque);
}

// What has to be kept of a value beside itself, to find the mean to the next one.
struct TransferPoint
{
  int number;
  float fraction;
  ivec4 integral; // from 0 to the lower end of the part
  vec4 inside;    // from there to the value, in the same units
  int opaque;
};

TransferPoint makePoint(TransferPart part)
{
  const vec4 inside = mix(part.lower, part.upper, 0.5 * part.fraction);
  return TransferPoint(part.number, part.fraction, part.integral,
    inside * (part.fraction * part.width * inverseIntegralUnit), part.opaque);
}

// Mean extinction over the values between two points. `values`: theirs. `part`: of the second one.
vec4 meanBetween(TransferPoint from, TransferPoint to, vec2 values, TransferPart part)
{
  const float way = values.y - values.x;
  const vec4 between = vec4(to.integral - from.integral) + (to.inside - from.inside);
  // Quotients of small differences have few digits: then the function is as good as constant.
  if (from.number == to.number || (abs(way) < 1e-5 && abs(between.a) < 1000.0))
  {
    return mix(part.lower, part.upper,
      from.number == to.number ? 0.5 * (from.fraction + to.fraction) : to.fraction);
  }
  const vec4 mean = max(between * (integralUnit / way), vec4(0.0));
  return vec4(min(mean.rgb, mean.a), mean.a); // no colour is above 1, but for rounding
}
