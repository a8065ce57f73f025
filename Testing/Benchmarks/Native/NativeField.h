// SPDX-License-Identifier: BSD-3-Clause
// Shaders/Basis.glsl in C++, without absent cells: the field at a point from a list of bricks.
#ifndef ExaBricksBenchmarksNativeField_h
#define ExaBricksBenchmarksNativeField_h

#include "NativeRay.h"

namespace exabricks
{
namespace benchmarks
{
namespace native
{
/// A brick as samples need it.
struct BrickRecord
{
  Vec4 last;           // n - 1: cell centres, in cells from that of the first one
  Vec4 lastLower;      // max(n - 2, 0)
  IVec4 strides;       // of a step to the next cell along each axis; 0 where there is none
  IVec4 lo;            // half cells
  const float* values; // with one behind the last: they are loaded in pairs
  float perHalfCell;   // cells
  int width;           // of a cell, in finest cells
};

inline BrickRecord makeRecord(
  const Brick& brick, const glm::ivec3& lo, int width, const float* values)
{
  const glm::ivec3& n = brick.cells;
  BrickRecord record;
  record.last = toFloat(IVec4{ n.x - 1, n.y - 1, n.z - 1, 0 });
  record.lastLower = max(toFloat(IVec4{ n.x - 2, n.y - 2, n.z - 2, 0 }), broadcast(0.0f));
  record.strides = IVec4{ n.x > 1, n.y > 1 ? n.x : 0, n.z > 1 ? n.x * n.y : 0, 0 };
  record.lo = IVec4{ lo.x, lo.y, lo.z, 0 };
  record.values = values;
  record.perHalfCell = 0.5f / static_cast<float>(width);
  record.width = width;
  return record;
}

/// The ray's base from the brick's lower corner, half cells.
inline Vec4 offsetOf(const BrickRecord& brick, const Ray& ray)
{
  return toFloat(load<IVec4>(ray.base) - brick.lo);
}

/// The ray's point at `distance`, in cells from the centre of the brick's first one.
inline Vec4 toCells(const BrickRecord& brick, Vec4 offset, const Ray& ray, float distance)
{
  return (offset + (ray.origin + distance * ray.direction)) * brick.perHalfCell - 0.5f;
}

/// Trilinear, of the eight values around the point `c` inside the box of cell centres.
inline float interpolate(const BrickRecord& brick, Vec4 c)
{
  const IVec4 i = toInteger(min(c, brick.lastLower));
  const Vec4 f = c - toFloat(i);
  const IVec4 place = i * brick.strides;
  const float* lower = brick.values + (place[0] + place[1] + place[2]);
  const float* upper = lower + brick.strides[2];
  const int dy = brick.strides[1];
  const Vec4 xy = mix(loadPairs(lower, lower + dy), loadPairs(upper, upper + dy), f[2]);
  const Vec4 x = mix(xy, swapHalves(xy), f[1]);
  return x[0] + (x[1] - x[0]) * f[0];
}

inline void addTents(const BrickRecord& brick, Vec4 q, float& sum, float& weight)
{
  const Vec4 c = clamp(q, broadcast(0.0f), brick.last);
  const Vec4 h = max(1.0f - abs(q - c), broadcast(0.0f));
  const float w = h[0] * h[1] * h[2];
  if (w > 0.0f)
  {
    sum += w * interpolate(brick, c);
    weight += w;
  }
}

/// The brick at a place in the lists. The place comes back as that of the next one of the list, or
/// as null after the last one.
inline const BrickRecord& nextBrick(const BrickRecord* bricks, const std::uint32_t*& place)
{
  const std::uint32_t entry = *place;
  place = (entry & layout::LAST_BRICK) == 0 ? place + 1 : nullptr;
  return bricks[entry & ~layout::LAST_BRICK];
}

/// The field at the ray's point at `distance`. `brick` (at `offset`, see above) is the first of the
/// region's, `others` is the place of the rest.
inline float sampleBasis(const BrickRecord* bricks, const BrickRecord& brick, Vec4 offset,
  const std::uint32_t* others, const Ray& ray, float distance)
{
  const Vec4 q = toCells(brick, offset, ray, distance);
  if (!others)
  {
    return interpolate(brick, clamp(q, broadcast(0.0f), brick.last)); // whatever it weighs
  }
  float sum = 0.0f;
  float weight = 0.0f;
  addTents(brick, q, sum, weight);
  while (others)
  {
    const BrickRecord& other = nextBrick(bricks, others);
    addTents(other, toCells(other, offsetOf(other, ray), ray, distance), sum, weight);
  }
  return std::min(std::max(sum / weight, 0.0f), 1.0f); // which rounding may pass
}
}
}
}

#endif
