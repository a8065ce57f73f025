// SPDX-License-Identifier: BSD-3-Clause
// Which leaf cell a ray is in, and where it leaves it.

// Where the ray passes the first of three planes, one along each axis, but not before `inside`; or `end`, if
// that is nearer.
float leaveThrough(Ray ray, ivec3 planes, float inside, float end)
{
  vec3 leaves = vec3(planeDistance(ray, planes.x, 0), planeDistance(ray, planes.y, 1),
    planeDistance(ray, planes.z, 2));
  // A ray in a plane does not leave through it.
  leaves = mix(leaves, vec3(1e30), lessThan(abs(ray.direction), vec3(1e-8)));
  return min(end, max(min(leaves.x, min(leaves.y, leaves.z)), inside));
}

// The leaf cell that the ray enters at `distance`: the brick that holds it, where it is there, and
// `end`, which comes as the end of the region and goes as the end of the cell, if that is nearer. The
// region lies in leaf cells, so one of its bricks holds the point; by rounding it may miss them all by
// a hair, so take the closest.
void findHolder(Brick brick, uint others, Ray ray, float distance, inout float end,
  out Brick holder, out uvec3 cell)
{
  const float inside = min(behindFace(distance), end);
  float closest = 1e30;
  holder = brick;
  cell = uvec3(0);
  while (true)
  {
    const uvec3 n = cellsOf(brick);
    const vec3 q = toCells(brick, ray, inside);
    const vec3 off = abs(q - clamp(q, vec3(0.0), vec3(n))) * float(brick.width);
    // A cell's upper faces are those of the next cells: on them both sides miss by nothing.
    const float miss = off.x + off.y + off.z + (any(greaterThanEqual(q, vec3(n))) ? 1e-20 : 0.0);
    if (miss < closest)
    {
      closest = miss;
      holder = brick;
      cell = toIndex(floor(clamp(q, vec3(0.0), vec3(n) - 0.5)));
    }
    if (others == 0u || closest == 0.0)
    {
      break;
    }
    brick = nextBrick(others);
  }
  const ivec3 ahead = ivec3(cell) + ivec3(greaterThan(ray.direction, vec3(0.0)));
  end = leaveThrough(ray, holder.lo + 2 * holder.width * ahead, inside, end);
}

// The same with the cell's value. False: the cell is absent.
bool findCell(
  Brick brick, uint others, Ray ray, float distance, inout float end, out float value)
{
  Brick holder;
  uvec3 cell;
  findHolder(brick, others, ray, distance, end, holder, cell);
  value = valueAt(holder, cellsOf(holder), cell, 0u);
  return value >= 0.0;
}
