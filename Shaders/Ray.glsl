// SPDX-License-Identifier: BSD-3-Clause
// A ray near the place where it is, in half cells, accurate in float32 on lattices of any size: its
// distances count from a lattice point close by (its base), so that they stay small. A ray that has
// come further than REBASE_DISTANCE from its base needs another one (Advance.glsl).

struct Ray
{
  ivec3 base;    // lattice point, half cells
  vec3 fraction; // of the ray's origin: base + fraction
  vec3 direction; // of length 1 in half cells
  vec3 inverse;   // 1 / direction
  float begin;    // distances from the origin at which the ray enters the bounds, ...
  float end;      // ... and leaves them, or at which its segment ends
  float partBegin; // where it is in the part that is drawn
  float partEnd;
  float unitsPerHalfCell; // length of a step of length 1 in opacity unit distances
};

const float REBASE_DISTANCE = 1024.0; // half cells: distances are exact to 1e-4 of them

// Distance to a plane of constant x, y or z. One formula for every plane: two regions that share a
// plane get the same bits.
float planeDistance(Ray ray, int plane, uint axis)
{
  const int base = axis == 0 ? ray.base.x : axis == 1 ? ray.base.y : ray.base.z;
  const float fraction = axis == 0 ? ray.fraction.x : axis == 1 ? ray.fraction.y : ray.fraction.z;
  const float inverse = axis == 0 ? ray.inverse.x : axis == 1 ? ray.inverse.y : ray.inverse.z;
  return (float(plane - base) - fraction) * inverse;
}

// A distance for a new base: two units in the last place less, so that rounding cuts nothing off
// what lies behind it.
float beforeRounding(float distance)
{
  return uintBitsToFloat(floatBitsToUint(distance) - 2u);
}

// Positions are exact to about 1e-4 half cells, or some units in the last place of the distance where
// that is more: this far behind a face, a point is in the next cell.
float behindFace(float distance)
{
  return distance + max(5e-4, 5e-7 * distance);
}

// The part of the line between two distances, seen from a base at `begin`. False: nothing of it is
// in the bounds.
bool makeRay(Line line, Pair begin, Pair end, ivec3 size, out Ray ray)
{
  const Pair3 position = add(line.origin, multiply(line.direction, begin));
  const vec3 whole = floor(position.high);
  const vec3 rest = (position.high - whole) + position.low;
  ray.base = ivec3(whole) + ivec3(floor(rest));
  ray.fraction = rest - floor(rest);
  ray.direction = line.direction.high;
  ray.inverse = 1.0 / ray.direction;
  // By the one formula too, so that the first and last regions get the same bits however found.
  const vec3 low = vec3(planeDistance(ray, 0, 0), planeDistance(ray, 0, 1), planeDistance(ray, 0, 2));
  const vec3 high =
    vec3(planeDistance(ray, size.x, 0), planeDistance(ray, size.y, 1), planeDistance(ray, size.z, 2));
  const vec3 enter = min(low, high);
  const vec3 leave = max(low, high);
  ray.begin = max(0.0, max(enter.x, max(enter.y, enter.z)));
  float reach = add(end, negative(begin)).high;
  if ((clipped || cropped) && reach > REBASE_DISTANCE)
  {
    // It is found exactly from a base nearby: from here, rounding must not bring it before a face
    // that the ray passes first.
    reach = behindFace(reach);
  }
  ray.end = min(reach, min(leave.x, min(leave.y, leave.z)));
  ray.unitsPerHalfCell = line.unitsPerHalfCell;
  if (isPart)
  {
    const ivec3 lower = constants.frame.partLower;
    const ivec3 upper = constants.frame.partUpper;
    const vec3 toLower = vec3(planeDistance(ray, lower.x, 0), planeDistance(ray, lower.y, 1),
      planeDistance(ray, lower.z, 2));
    const vec3 toUpper = vec3(planeDistance(ray, upper.x, 0), planeDistance(ray, upper.y, 1),
      planeDistance(ray, upper.z, 2));
    const vec3 entries = min(toLower, toUpper);
    const vec3 exits = max(toLower, toUpper);
    ray.partBegin = max(entries.x, max(entries.y, entries.z));
    ray.partEnd = min(exits.x, min(exits.y, exits.z));
    return ray.begin < ray.end && max(ray.partBegin, ray.begin) < min(ray.partEnd, ray.end);
  }
  return ray.begin < ray.end;
}
