// SPDX-License-Identifier: BSD-3-Clause
// Shaders/TransferFunction.glsl in C++: extinction of a value, and its mean between two.
#ifndef ExaBricksBenchmarksNativeTransfer_h
#define ExaBricksBenchmarksNativeTransfer_h

#include "Core/TransferTable.h"
#include "NativeVector.h"

namespace exabricks
{
namespace benchmarks
{
namespace native
{
struct TransferPart
{
  int number; // bins first, then the parts between knots
  float share;
  float width;
  Vec4 lower;
  Vec4 upper;
  IVec4 integral;
  int opaque;
};

struct TransferPoint
{
  float value = 0.0f;
  int number = 0;
  float share = 0.0f;
  IVec4 integral{ 0, 0, 0, 0 };          // from 0 to the lower end of the part
  Vec4 inside{ 0.0f, 0.0f, 0.0f, 0.0f }; // from there to the value, in the same units
  int opaque = 0;
};

struct Transfer
{
  const layout::TransferBin* bins;
  const layout::TransferKnot* knots;
  float integralUnit;
  float inverseIntegralUnit;
};

// Rare: not among the code of the loop.
#if defined(__GNUC__)
__attribute__((noinline))
#endif
inline TransferPart
findPartBetweenKnots(const Transfer& transfer, const layout::TransferBin& bin, float value)
{
  int k = bin.integral.x;
  int end = k + bin.integral.y;
  while (end - k > 1)
  {
    const int middle = (k + end) / 2;
    (transfer.knots[middle].value <= value ? k : end) = middle;
  }
  const layout::TransferKnot& knot = transfer.knots[k];
  const float width = transfer.knots[k + 1].value - knot.value;
  return { layout::TRANSFER_BINS + k, (value - knot.value) / width, width, load<Vec4>(knot.lower),
    load<Vec4>(knot.upper), load<IVec4>(knot.integral), knot.opaque };
}

inline TransferPart findPart(const Transfer& transfer, float value)
{
  const float x = std::min(std::max(value, 0.0f), 1.0f) * static_cast<float>(layout::TRANSFER_BINS);
  const int i = std::min(static_cast<int>(x), layout::TRANSFER_BINS - 1);
  const layout::TransferBin& bin = transfer.bins[i];
  if (bin.lower.a < 0.0f)
  {
    return findPartBetweenKnots(transfer, bin, value);
  }
  return { i, x - static_cast<float>(i), 1.0f / static_cast<float>(layout::TRANSFER_BINS),
    load<Vec4>(bin.lower), load<Vec4>(bin.upper), load<IVec4>(bin.integral), bin.opaque };
}

inline TransferPoint makePoint(const Transfer& transfer, const TransferPart& part, float value)
{
  const Vec4 inside = mix(part.lower, part.upper, 0.5f * part.share);
  const float values = part.share * part.width * transfer.inverseIntegralUnit;
  return { value, part.number, part.share, part.integral, inside * values, part.opaque };
}

/// Colour, times opacity, and opacity of a length of the ray in unit distances.
inline Vec4 absorb(Vec4 extinction, float units)
{
  const float a = extinction[3];
  if (!(a > 0.0f))
  {
    return broadcast(0.0f);
  }
  const float depth = a * units;
  // 1 - exp(-depth), without the loss of digits where it is small.
  const float alpha = a > 0.99999f * layout::DENSEST ? 1.0f
    : depth < 0.02f ? depth * (1.0f - depth * (0.5f - depth * (1.0f / 6.0f)))
                    : 1.0f - std::exp(-depth);
  return extinction * (alpha / a);
}

/// Mean extinction over the values between two points. `part`: of the second one.
inline Vec4 meanBetween(const Transfer& transfer, const TransferPoint& from,
  const TransferPoint& to, const TransferPart& part)
{
  if (from.number == to.number)
  {
    return mix(part.lower, part.upper, 0.5f * (from.share + to.share));
  }
  const float way = to.value - from.value;
  const Vec4 between = toFloat(to.integral - from.integral) + (to.inside - from.inside);
  // Quotients of small differences have few digits: then the function is as good as constant.
  if (std::abs(way) < 1e-5f && std::abs(between[3]) < 1000.0f)
  {
    return mix(part.lower, part.upper, to.share);
  }
  const Vec4 mean = max(between * (transfer.integralUnit / way), broadcast(0.0f));
  return min(mean, broadcast(mean[3])); // no colour is above 1, but for rounding
}

/// An interval that becomes opaque on its way: what is before that place, and the colour there.
#if defined(__GNUC__)
__attribute__((noinline))
#endif
inline Vec4
absorbUpToSurface(const Transfer& transfer, const TransferPoint& from, const TransferPoint& to,
  TransferPart part, float units)
{
  float before = from.value;
  float behind = to.value;
  for (int halving = 0; halving < 64; ++halving)
  {
    const float middle = 0.5f * (before + behind);
    if (middle == before || middle == behind)
    {
      break;
    }
    const TransferPart there = findPart(transfer, middle);
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
  const TransferPart last = findPart(transfer, before);
  const Vec4 veil = absorb(meanBetween(transfer, from, makePoint(transfer, last, before), last),
    units * (before - from.value) / (to.value - from.value));
  // No value lies in an opaque part of no width.
  const Vec4 surface = mix(part.lower, part.upper, part.share);
  return (part.opaque & 1) != 0 ? veil + (1.0f - veil[3]) * surface / surface[3] : veil;
}

/// Colour, times opacity, and opacity of an interval of some unit distances, over which the value
/// goes evenly from one point to the other. `part`: of the second one.
inline Vec4 absorbBetween(const Transfer& transfer, const TransferPoint& from,
  const TransferPoint& to, const TransferPart& part, float units)
{
  if ((from.opaque & 1) != 0)
  {
    const TransferPart surface = findPart(transfer, from.value);
    const Vec4 extinction = mix(surface.lower, surface.upper, surface.share);
    return extinction / extinction[3];
  }
  if (from.opaque != to.opaque)
  {
    return absorbUpToSurface(transfer, from, to, part, units);
  }
  return absorb(meanBetween(transfer, from, to, part), units);
}
}
}
}

#endif
