#version 460
// SPDX-License-Identifier: BSD-3-Clause
// Marches the ray of each pixel region by region, front to back. Compiled once for each traversal:
// TRAVERSAL_KDTREE walks the k-d tree over the regions; TRAVERSAL_RAYQUERY asks an acceleration
// structure of the active regions for the next few.
#extension GL_GOOGLE_include_directive : require
#ifdef TRAVERSAL_RAYQUERY
#extension GL_EXT_ray_query : require
#endif

#include "Buffers.glsl"
#include "Ray.glsl"

layout(constant_id = 0) const bool nearest = false;
layout(constant_id = 1) const bool completed = false; // neither: basis

#include "Reconstruction.glsl"
#include "TransferFunction.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// The frame's constants, read once: in the loops each use would be a load.
Bricks bricks;
Regions regions;
Indices brickLists;
TransferBins transferBins;
TransferKnots transferKnots;
float stepScale;
float inverseUnit;
float integralUnit;
float inverseIntegralUnit;
float terminationOpacity;

// What a lane knows of the region it is in, and what it has gathered.
struct March
{
  Brick brick;      // the first of the region's: most regions have one alone
  uint otherBricks; // place of the rest in the lists
  uint otherCount;
  float entry;    // distance at which the next interval begins
  float exit;     // distance at which the ray leaves the region
  uint intervals; // number still to do; where they end at faces of cells: 0, or 1 for some
  vec4 color;     // premultiplied

  // Basis
  bool cut;           // intervals end at faces of cells, as some are absent
  float interval;     // greatest length of an interval; unless cut, a whole number fills the region
  bool halved;        // by a sample in its middle
  bool known;         // the point at `entry` is
  TransferPoint last; // it
};

void enterRegion(uint r, float entry, float exit, inout March march)
{
  const Region region = regions.items[r];
  march.brick = bricks.items[brickLists.items[region.firstBrick]];
  march.otherBricks = region.firstBrick + 1;
  march.otherCount = region.brickCount - 1;
  march.intervals = 1;
  if (!nearest)
  {
    // Samples at most stepScale cells of the finest brick apart, two to an interval, unless one
    // alone does for the region.
    int width = march.brick.width;
    uint flags = march.brick.dimensions;
    for (uint k = 0; k < march.otherCount; ++k)
    {
      const Brick brick = bricks.items[brickLists.items[march.otherBricks + k]];
      width = min(width, brick.width);
      flags |= brick.dimensions;
    }
    march.cut = (flags & BRICK_HAS_ABSENT_CELLS) != 0u;
    const float step = 2.0 * stepScale * float(width);
    const float count = max(ceil(0.5 * (exit - entry) / step), 1.0);
    march.halved = march.cut || exit - entry > step;
    march.interval = march.cut ? 2.0 * step : (exit - entry) / count;
    march.intervals = march.cut ? 1 : uint(count);
    // The field is continuous: the last point of the region before is the first of this one.
    march.known = march.known && march.exit == entry;
  }
  march.entry = entry;
  march.exit = exit;
}

// The value of the cell that the ray is in, and where it leaves it. False: it is absent.
bool findCell(Ray ray, March march, out float end, out float value)
{
  end = march.exit;
  return sampleNearest(bricks, brickLists, march.brick, march.otherBricks, march.otherCount, ray,
    march.entry, end, value);
}

// Nearest: the value does not change up to the next face of a cell.
void marchCell(Ray ray, inout March march)
{
  float value;
  float end;
  if (findCell(ray, march, end, value))
  {
    const TransferPart part = findPart(transferBins, transferKnots, value);
    march.color += (1.0 - march.color.a) *
      absorb(mix(part.lower, part.upper, part.share),
        (end - march.entry) * ray.worldPerHalfCell * inverseUnit);
  }
  march.entry = end;
  march.intervals = end < march.exit ? 1 : 0;
}

// Where the next interval ends. False: there is nothing up to there.
bool findEnd(Ray ray, March march, out float end)
{
  if (!march.cut)
  {
    end = march.intervals == 1 ? march.exit : march.entry + march.interval;
    return true;
  }
  float value;
  const bool there = findCell(ray, march, end, value);
  const float count = ceil((end - march.entry) / march.interval);
  end = there && count > 1.0 ? march.entry + (end - march.entry) / count : end;
  return there;
}

// Basis: the next interval, over which the value goes evenly from the last point to the sample in
// the middle and on to the next point. At first, the point where the first interval begins.
void marchInterval(Ray ray, inout March march)
{
  float end;
  const bool there = findEnd(ray, march, end);
  const bool first = there && !march.known;
  if (there)
  {
    const float length = end - march.entry;
    const int count = march.halved && !first ? 2 : 1;
    float middle = 0.0;
    float value = 0.0;
    for (int k = 1; k <= count; ++k)
    {
      middle = value;
      value = sampleBasis(bricks, brickLists, march.brick, march.otherBricks, march.otherCount, ray,
        first ? march.entry : k == count ? end : march.entry + 0.5 * length);
    }
    // The middle that gives the halves together the mean of the parabola through all three (Simpson's
    // rule); but no value that lies beyond them, which the field may not take.
    const float last = march.last.value;
    middle = clamp((4.0 * middle - 0.5 * (last + value)) / 3.0, min(middle, min(last, value)),
      max(middle, max(last, value)));
    const float units = length / float(count) * ray.worldPerHalfCell * inverseUnit;
    for (int k = 1; k <= count; ++k)
    {
      const float next = k == count ? value : middle;
      const TransferPart part = findPart(transferBins, transferKnots, next);
      const TransferPoint point = makePoint(part, next, inverseIntegralUnit);
      if (!first)
      {
        march.color += (1.0 - march.color.a) *
          absorbBetween(
            transferBins, transferKnots, march.last, point, part, integralUnit, units);
      }
      march.last = point;
    }
  }
  march.known = there;
  if (!first)
  {
    march.entry = end;
    march.intervals = march.cut ? (end < march.exit ? 1 : 0) : march.intervals - 1;
  }
}

void marchOn(Ray ray, inout March march)
{
  if (nearest)
  {
    marchCell(ray, march);
  }
  else
  {
    marchInterval(ray, march);
  }
}

#ifdef TRAVERSAL_KDTREE
// Nodes that the ray still has to enter, nearest first, and where it leaves them. A short stack: what
// falls off its end is found again from the root, which is what 0 stands for.
struct Pending
{
  uvec4 nodes;
  vec4 limits;
};

// The region that holds the ray just behind `distance`, and where the ray leaves it.
uint locate(KdNodes nodes, Ray ray, float distance, inout Pending pending, out float exit)
{
  uint index = pending.nodes.x;
  exit = index == 0 ? ray.end : pending.limits.x;
  pending.nodes = uvec4(pending.nodes.yzw, 0);
  pending.limits.xyz = pending.limits.yzw;
  KdNode node = nodes.items[index];
  while ((node.link & 3u) != KD_LEAF)
  {
    const uint axis = node.link & 3u;
    const float plane = planeDistance(ray, node.plane, axis);
    const float inverse = axis == 0 ? ray.inverse.x : axis == 1 ? ray.inverse.y : ray.inverse.z;
    const bool ahead = plane > distance;
    const uint lower = node.link >> 2;
    // The lower child comes first for a ray that goes up.
    const uint first = lower + uint(inverse < 0.0);
    const uint last = lower + uint(inverse >= 0.0);
    if (ahead && plane < exit)
    {
      pending.nodes = uvec4(last, pending.nodes.xyz);
      pending.limits = vec4(exit, pending.limits.xyz);
      exit = plane;
    }
    node = nodes.items[ahead ? first : last];
  }
  return node.link >> 2;
}

// One flat loop: every lane takes an interval each time round, and walks the tree only when its
// region is used up.
void march(FrameBuffer f, uvec2 pixel, Ray ray, inout March march)
{
  KdNodes nodes = KdNodes(f.frame.nodes);
  double skip = 0.0LF;
  float exit = ray.begin;
  Pending pending = Pending(uvec4(0), vec4(0.0));
  while (true)
  {
    while (march.intervals == 0 && exit < ray.end)
    {
      if (exit > REBASE_DISTANCE)
      {
        skip += double(beforeRounding(exit));
        if (!makeRay(f, pixel, skip, ray))
        {
          return;
        }
        exit = ray.begin;
        march.exit = -1.0; // distances count anew
        pending.nodes = uvec4(0);
      }
      const float entry = exit;
      const uint region = locate(nodes, ray, entry, pending, exit);
      if (region != KD_NO_REGION)
      {
        enterRegion(region, entry, exit, march);
      }
    }
    if (march.intervals == 0)
    {
      return;
    }
    marchOn(ray, march);
    if (march.color.a >= terminationOpacity)
    {
      return;
    }
  }
}
#endif

#ifdef TRAVERSAL_RAYQUERY
// Where the ray enters and leaves a region, between `distance` and its end.
vec2 crossing(Ray ray, uint r, float distance)
{
  const Region region = regions.items[r];
  const vec3 a = (vec3(region.lo - ray.base) - ray.fraction) * ray.inverse;
  const vec3 b = (vec3(region.hi - ray.base) - ray.fraction) * ray.inverse;
  const vec3 entries = min(a, b);
  const vec3 exits = max(a, b);
  return vec2(max(distance, max(entries.x, max(entries.y, entries.z))),
    min(ray.end, min(exits.x, min(exits.y, exits.z))));
}

const int NEAREST = 8;

// The nearest few regions at a time, sorted by entry. The query starts at the ray's present point:
// on some drivers a later start prunes nothing.
void march(FrameBuffer f, uvec2 pixel, Ray ray, inout March march)
{

  Indices activeRegions = Indices(f.frame.activeRegions);
  double skip = 0.0LF;
  float distance = ray.begin;
  while (distance < ray.end)
  {
    if (distance > REBASE_DISTANCE)
    {
      skip += double(beforeRounding(distance));
      if (!makeRay(f, pixel, skip, ray))
      {
        return;
      }
      distance = ray.begin;
      march.exit = -1.0; // distances count anew
    }
    float entry[NEAREST];
    uint region[NEAREST];
    for (int k = 0; k < NEAREST; ++k)
    {
      entry[k] = 1e30;
      region[k] = KD_NO_REGION;
    }
    rayQueryEXT query;
    rayQueryInitializeEXT(query, accelerationStructureEXT(f.frame.scene), gl_RayFlagsNoneEXT, 0xff,
      vec3(ray.base) + ray.fraction + distance * ray.direction, 0.0, ray.direction,
      ray.end - distance);
    while (rayQueryProceedEXT(query))
    {
      uint r = activeRegions.items[rayQueryGetIntersectionPrimitiveIndexEXT(query, false)];
      const vec2 cross = crossing(ray, r, distance);
      float t = cross.x;
      if (cross.x < cross.y && t < entry[NEAREST - 1])
      {
        for (int k = 0; k < NEAREST; ++k)
        {
          if (t < entry[k])
          {
            const float t2 = entry[k];
            const uint r2 = region[k];
            entry[k] = t;
            region[k] = r;
            t = t2;
            r = r2;
          }
        }
        if (region[NEAREST - 1] != KD_NO_REGION)
        {
          // Nothing behind the last of them is wanted now.
          rayQueryGenerateIntersectionEXT(query, max(entry[NEAREST - 1] - distance, 0.0));
        }
      }
    }
    const bool full = region[NEAREST - 1] != KD_NO_REGION;
    bool rebase = false;
    for (int k = 0; k < NEAREST && !rebase; ++k)
    {
      if (region[k] == KD_NO_REGION)
      {
        break;
      }
      const vec2 cross = crossing(ray, region[k], distance);
      if (cross.x > REBASE_DISTANCE)
      {
        distance = cross.x;
        rebase = true;
        break;
      }
      enterRegion(region[k], cross.x, cross.y, march);
      while (march.intervals > 0)
      {
        marchOn(ray, march);
        if (march.color.a >= terminationOpacity)
        {
          return;
        }
      }
      distance = cross.y;
    }
    if (!full && !rebase)
    {
      return;
    }
  }
}
#endif

void main()
{
  FrameBuffer f = FrameBuffer(push.band.frame);
  const uvec2 pixel = gl_GlobalInvocationID.xy + uvec2(0, push.band.firstRow);
  if (pixel.x >= f.frame.width || pixel.y >= f.frame.height)
  {
    return;
  }
  bricks = Bricks(f.frame.bricks);
  regions = Regions(f.frame.regions);
  brickLists = Indices(f.frame.brickLists);
  transferBins = TransferBins(f.frame.transferBins);
  transferKnots = TransferKnots(f.frame.transferKnots);
  stepScale = f.frame.stepScale;
  inverseUnit = f.frame.inverseUnit;
  integralUnit = f.frame.integralUnit;
  inverseIntegralUnit = 1.0 / integralUnit;
  terminationOpacity = f.frame.terminationOpacity;
  March state;
  state.intervals = 0;
  state.exit = -1.0;
  state.known = false;
  state.last.value = 0.0;
  state.color = vec4(0.0);
  Ray ray;
  if (makeRay(f, pixel, 0.0LF, ray))
  {
    march(f, pixel, ray, state);
  }
  Picture(f.frame.picture).pixels[pixel.y * f.frame.width + pixel.x] = state.color;
}
