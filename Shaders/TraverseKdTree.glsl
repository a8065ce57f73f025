// SPDX-License-Identifier: BSD-3-Clause
// The active regions along a ray, by a walk through the k-d tree over them.

// Nodes that the ray still has to enter, nearest first, and where it leaves them. A short stack: what
// falls off its end is found again from the root, which is what 0 stands for.
struct Pending
{
  uvec4 nodes;
  vec4 limits;
};

// A node, or a leaf with nothing to draw in its place, where nothing below it counts.
KdNode readNode(KdNodes nodes, uint index, Accumulator gathered)
{
  return isPassed(index, gathered) ? KdNode(0, 4u * KD_NO_REGION + KD_LEAF) : nodes.items[index];
}

// The leaf that holds the ray just behind `distance`, and where the ray leaves it.
KdNode locate(KdNodes nodes, Ray ray, float distance, Accumulator gathered, inout Pending pending,
  out float exit)
{
  uint index = pending.nodes.x;
  exit = index == 0 ? ray.end : pending.limits.x;
  pending.nodes = uvec4(pending.nodes.yzw, 0);
  pending.limits.xyz = pending.limits.yzw;
  KdNode node = readNode(nodes, index, gathered);
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
    node = readNode(nodes, ahead ? first : last, gathered);
  }
  return node;
}

// So many regions are found ahead at most. On other devices than processors private arrays are slow. Of
// extremes one is found when it is needed: what a ray has gathered up to it says whether it can matter.
const uint MOST_AHEAD = takesPixels && !isExtremum ? 8u : 1u;

// A region that the ray comes to.
struct Ahead
{
  uint firstBrick;
  float step;
  float entry;
  float exit;
};

// One flat loop: every lane takes an interval each time round. Where a lane has no region left, all of
// its subgroup walk the tree with it, and find several ahead: of lanes that walk each when it needs the
// next region, a third are on at a time.
void traverse(FrameBuffer f, uvec2 place, inout Accumulator gathered)
{
  KdNodes nodes = KdNodes(f.frame.nodes);
  Pixel pixel;
  Ray ray;
  if (!startRay(f, place, pixel, ray))
  {
    return;
  }
  Cursor cursor = startCursor();
  float exit = ray.begin;
  Pending pending = Pending(uvec4(0), vec4(0.0));
  Ahead aheads[MOST_AHEAD]; // in a ring
  uint first = 0u;
  uint count = 0u;
  while (true)
  {
    const bool needsOne = cursor.intervals == 0 && count == 0u;
    if (isExtremum ? needsOne : subgroupAny(needsOne))
    {
      while (count < MOST_AHEAD && goesOn(pixel, ray, exit))
      {
        if (isUsedUp(ray, exit))
        {
          // What was found before is marched in the frame that it was found in.
          if (cursor.intervals > 0 || count > 0u || !advance(f, pixel, ray, exit))
          {
            break;
          }
          exit = ray.begin;
          forgetPoint(cursor);
          pending.nodes = uvec4(0);
        }
        const float entry = exit;
        const KdNode leaf = locate(nodes, ray, entry, gathered, pending, exit);
        if (leaf.link >> 2 != KD_NO_REGION)
        {
          aheads[(first + count) % MOST_AHEAD] =
            Ahead(leaf.link >> 2, intBitsToFloat(leaf.plane), entry, exit);
          ++count;
        }
      }
    }
    if (cursor.intervals == 0)
    {
      if (count == 0u)
      {
        return;
      }
      const Ahead next = aheads[first];
      first = (first + 1u) % MOST_AHEAD;
      --count;
      enterRegion(ray, next.firstBrick, next.step, growthOfStep(ray, next.step, gathered),
        next.entry, next.exit, cursor);
    }
    if (cursor.intervals > 0)
    {
      marchOn(ray, cursor, gathered);
      if (isComplete(gathered))
      {
        return;
      }
    }
  }
}
