// SPDX-License-Identifier: BSD-3-Clause
// The ray of a pixel, in half cells, kept accurate in float32 on lattices of any size and for
// cameras at any distance: it is set up in double precision, and its distances count from a lattice
// point close to where the ray is (its base), so that they stay small. A ray that has come further
// than REBASE_DISTANCE from its base is set up anew from there.

// Rays begin at depths of their own; else at the near plane, and nothing is read.
layout(constant_id = 2) const bool beginsAtDepth = false;

struct Ray
{
  ivec3 base;    // lattice point, half cells
  vec3 fraction; // of the ray's origin: base + fraction
  vec3 direction; // of length 1 in half cells
  vec3 inverse;   // 1 / direction
  float begin;    // distances from the origin at which the ray enters the bounds, ...
  float end;      // ... and leaves them, or hits geometry
  float dataPerHalfCell; // length of a step of length 1 in the data's coordinates
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

// Of a window depth in [0, 1], as a depth buffer holds it.
double ndcDepth(Values depth, uvec2 pixel, uint width)
{
  return 2.0LF * double(depth.items[pixel.y * width + pixel.x]) - 1.0LF;
}

// The ray of `pixel` from `skip` half cells behind its entry into the bounds on. False: a miss.
bool makeRay(FrameBuffer f, uvec2 pixel, double skip, out Ray ray)
{
  const dvec2 ndc = 2.0LF * (dvec2(pixel) + 0.5LF) / dvec2(f.frame.width, f.frame.height) - 1.0LF;
  double near = -1.0LF;
  if (beginsAtDepth)
  {
    near = ndcDepth(Values(f.frame.nearDepth), pixel, f.frame.width);
  }
  double far = 1.0LF;
  if (f.frame.hasDepth != 0)
  {
    far = ndcDepth(Values(f.frame.depth), pixel, f.frame.width);
  }
  if (beginsAtDepth && !(near < far))
  {
    return false;
  }
  const dvec4 a = f.frame.ndcToHalfCells * dvec4(ndc, near, 1.0LF);
  const dvec4 b = f.frame.ndcToHalfCells * dvec4(ndc, far, 1.0LF);
  const dvec4 dataA = f.frame.ndcToData * dvec4(ndc, near, 1.0LF);
  const dvec4 dataB = f.frame.ndcToData * dvec4(ndc, far, 1.0LF);
  const dvec3 origin = a.xyz / a.w;
  const dvec3 path = b.xyz / b.w - origin;
  const double pathLength = length(path);
  if (!(pathLength > 0.0LF) || isinf(pathLength))
  {
    return false;
  }
  dvec3 direction = path / pathLength;
  // No component is 0, so that every distance is finite.
  direction = mix(direction, mix(dvec3(-1e-12LF), dvec3(1e-12LF), greaterThanEqual(direction, dvec3(0.0LF))),
    lessThan(abs(direction), dvec3(1e-12LF)));
  const dvec3 toLower = -origin / direction;
  const dvec3 toUpper = (dvec3(f.frame.size) - origin) / direction;
  const dvec3 entries = min(toLower, toUpper);
  const dvec3 exits = max(toLower, toUpper);
  const double start = max(0.0LF, max(entries.x, max(entries.y, entries.z))) + skip;
  const double end = min(pathLength, min(exits.x, min(exits.y, exits.z)));
  if (!(start < end))
  {
    return false;
  }
  const dvec3 position = origin + start * direction;
  ray.base = ivec3(floor(position));
  ray.fraction = vec3(position - dvec3(ray.base));
  ray.direction = vec3(direction);
  ray.inverse = 1.0 / ray.direction;
  // By the one formula too, so that the first and last regions get the same bits however found.
  const vec3 low = vec3(planeDistance(ray, 0, 0), planeDistance(ray, 0, 1), planeDistance(ray, 0, 2));
  const vec3 high = vec3(planeDistance(ray, f.frame.size.x, 0), planeDistance(ray, f.frame.size.y, 1),
    planeDistance(ray, f.frame.size.z, 2));
  const vec3 enter = min(low, high);
  const vec3 leave = max(low, high);
  ray.begin = max(0.0, max(enter.x, max(enter.y, enter.z)));
  ray.end = min(float(pathLength - start), min(leave.x, min(leave.y, leave.z)));
  ray.dataPerHalfCell = float(length(dataB.xyz / dataB.w - dataA.xyz / dataA.w) / pathLength);
  return ray.begin < ray.end;
}

// A distance for a new base: two units in the last place less, so that rounding cuts nothing off
// what lies behind it.
float beforeRounding(float distance)
{
  return uintBitsToFloat(floatBitsToUint(distance) - 2u);
}
