// SPDX-License-Identifier: BSD-3-Clause
// The active regions along a ray, by an acceleration structure of their boxes.

// Where the ray enters and leaves a box, between `distance` and its end.
vec2 crossing(Ray ray, ActiveBox box, float distance)
{
  const vec3 a = (vec3(box.lo - ray.base) - ray.fraction) * ray.inverse;
  const vec3 b = (vec3(box.hi - ray.base) - ray.fraction) * ray.inverse;
  const vec3 entries = min(a, b);
  const vec3 exits = max(a, b);
  return vec2(max(distance, max(entries.x, max(entries.y, entries.z))),
    min(ray.end, min(exits.x, min(exits.y, exits.z))));
}

const int NEAREST = 8;

// The nearest few regions at a time, sorted by entry. The query starts at the ray's present point:
// on some drivers a later start prunes nothing.
void traverse(FrameBuffer f, uvec2 place, inout Accumulator gathered)
{
  ActiveBoxes boxes = ActiveBoxes(f.frame.activeBoxes);
  Pixel pixel;
  Ray ray;
  if (!startRay(f, place, pixel, ray))
  {
    return;
  }
  Cursor cursor = startCursor();
  float distance = ray.begin;
  while (goesOn(pixel, ray, distance))
  {
    if (isUsedUp(ray, distance))
    {
      if (!advance(f, pixel, ray, distance))
      {
        return;
      }
      distance = ray.begin;
      forgetPoint(cursor);
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
      uint r = rayQueryGetIntersectionPrimitiveIndexEXT(query, false);
      const vec2 cross = crossing(ray, boxes.items[r], distance);
      float t = cross.x;
      if (cross.x < cross.y && t < entry[NEAREST - 1] && !isPassed(r, gathered))
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
    bool isFar = false;
    for (int k = 0; k < NEAREST && !isFar; ++k)
    {
      if (region[k] == KD_NO_REGION)
      {
        break;
      }
      const ActiveBox box = boxes.items[region[k]];
      const vec2 cross = crossing(ray, box, distance);
      if (cross.x > REBASE_DISTANCE)
      {
        distance = cross.x;
        isFar = true;
        break;
      }
      if (isPassed(region[k], gathered))
      {
        distance = cross.y;
        continue;
      }
      enterRegion(ray, box.firstBrick, box.step, growthOfStep(ray, box.step, gathered), cross.x, cross.y,
        cursor);
      while (cursor.intervals > 0)
      {
        marchOn(ray, cursor, gathered);
        if (isComplete(gathered))
        {
          return;
        }
      }
      distance = cross.y;
    }
    if (!full && !isFar)
    {
      distance = ray.end; // nothing is left up to there
    }
  }
}
