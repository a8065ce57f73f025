// SPDX-License-Identifier: BSD-3-Clause
// The field at a point from a list of bricks (Wald et al. 2020, section 3).

// The brick at a place in the lists. The place comes back as that of the next one of the list, or as 0
// after the last one, which no list goes on from.
Brick nextBrick(inout uint place)
{
  const uint entry = brickLists.items[place];
  place = (entry & LAST_BRICK) == 0u ? place + 1u : 0u;
  return bricks.items[entry & ~LAST_BRICK];
}

// Whole numbers in [0, 2^23), without the conversion that saturates: slow on processors.
uint toIndex(float whole) { return floatBitsToUint(whole + 8388608.0) & 0x7fffffu; }
uvec3 toIndex(vec3 whole) { return floatBitsToUint(whole + 8388608.0) & 0x7fffffu; }

uvec3 cellsOf(Brick brick)
{
  return uvec3(brick.dimensions, brick.dimensions >> 8, brick.dimensions >> 16) & 0xffu;
}

// The ray's point at `distance`, in cells from the brick's lower corner.
vec3 toCells(Brick brick, Ray ray, float distance)
{
  return (vec3(ray.base - brick.lo) + (ray.fraction + distance * ray.direction)) *
    (0.5 / float(brick.width));
}

// Where the value of a cell is. Completed bricks have a layer of one more around them, from -1 on.
uint placeOf(uvec3 n, ivec3 cell)
{
  const uint layer = completed ? 1u : 0u;
  const uvec3 at = uvec3(cell + int(layer));
  const uvec3 size = n + 2u * layer;
  return at.x + size.x * (at.y + size.y * at.z);
}

float valueAt(Brick brick, uvec3 n, uvec3 cell)
{
  return Values(brick.values).items[placeOf(n, ivec3(cell))];
}

// Trilinear, of the eight values around a point, x fastest.
float interpolate(vec4 lower, vec4 upper, vec3 f)
{
  const vec4 xy = mix(lower, upper, f.z);
  const vec2 x = mix(xy.xy, xy.zw, f.y);
  return mix(x.x, x.y, f.x);
}

vec4 tentsOf(vec2 f)
{
  return vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
}

// Basis: the mean of the cells' values weighted with their tents, B = sum H_c v_c / sum H_c. Within
// a brick the tents add up to trilinear interpolation times the tent of the distance from the box of
// cell centres.
void addTents(Brick brick, vec3 q, inout float sum, inout float weight)
{
  const uvec3 n = cellsOf(brick);
  q -= 0.5;
  const vec3 c = clamp(q, vec3(0.0), vec3(n) - 1.0);
  const vec3 h = max(1.0 - abs(q - c), 0.0);
  const float w = h.x * h.y * h.z;
  if (w <= 0.0)
  {
    return;
  }
  const vec3 corner = min(floor(c), vec3(max(ivec3(n) - 2, 0)));
  const uvec3 i = toIndex(corner);
  const vec3 f = c - corner;
  const uint dx = n.x > 1u ? 1u : 0u;
  const uint dy = n.y > 1u ? n.x : 0u;
  const uint dz = n.z > 1u ? n.x * n.y : 0u;
  const uint at = i.x + n.x * (i.y + n.y * i.z);
  Values values = Values(brick.values);
  const vec4 lower = vec4(values.items[at], values.items[at + dx], values.items[at + dy],
    values.items[at + dy + dx]);
  const vec4 upper = vec4(values.items[at + dz], values.items[at + dz + dx],
    values.items[at + dz + dy], values.items[at + dz + dy + dx]);
  if ((brick.dimensions & BRICK_HAS_ABSENT_CELLS) == 0u)
  {
    sum += w * interpolate(lower, upper, f);
    weight += w;
    return;
  }
  const vec4 tents = tentsOf(f.xy);
  const vec4 lowerTents = tents * (w * (1.0 - f.z)) * vec4(greaterThanEqual(lower, vec4(0.0)));
  const vec4 upperTents = tents * (w * f.z) * vec4(greaterThanEqual(upper, vec4(0.0)));
  sum += dot(lowerTents, lower) + dot(upperTents, upper);
  weight += dot(lowerTents + upperTents, vec4(1.0));
}

// Completed: W_l T_l / sum of W_l over the levels l. W_l is the sum of the level's tents, as in the
// basis; T_l interpolates all eight lattice points of the level around the point, those too that are
// none of its leaf cells. Bricks of a level agree on T_l, so each adds it with its own tents' weight.
void addCompleted(Brick brick, vec3 q, inout float sum, inout float weight)
{
  const uvec3 n = cellsOf(brick);
  q -= 0.5;
  const vec3 h = max(1.0 - abs(q - clamp(q, vec3(0.0), vec3(n) - 1.0)), 0.0);
  const float w = h.x * h.y * h.z;
  if (w <= 0.0)
  {
    return;
  }
  const vec3 i = floor(q); // -1 to n - 1
  const vec3 f = q - i;
  const uint dy = n.x + 2u;
  const uint dz = dy * (n.y + 2u);
  const uint at = placeOf(n, ivec3(i));
  Values values = Values(brick.values);
  const vec4 lower =
    vec4(values.items[at], values.items[at + 1u], values.items[at + dy], values.items[at + dy + 1u]);
  const vec4 upper = vec4(values.items[at + dz], values.items[at + dz + 1u],
    values.items[at + dz + dy], values.items[at + dz + dy + 1u]);
  if ((brick.dimensions & BRICK_HAS_ABSENT_CELLS) == 0u)
  {
    sum += w * interpolate(lower, upper, f);
    weight += w;
    return;
  }
  const vec4 tents = tentsOf(f.xy);
  const vec4 lowerTents = tents * (1.0 - f.z) * vec4(greaterThanEqual(lower, vec4(0.0)));
  const vec4 upperTents = tents * f.z * vec4(greaterThanEqual(upper, vec4(0.0)));
  // those of the brick's own cells
  const vec3 first = vec3(greaterThanEqual(i, vec3(0.0)));
  const vec3 last = vec3(lessThan(i, vec3(n) - 1.0));
  const vec4 own = vec4(first.x * first.y, last.x * first.y, first.x * last.y, last.x * last.y);
  const float there = dot(own, lowerTents * first.z + upperTents * last.z);
  if (there > 0.0)
  {
    sum += there * (dot(lowerTents, lower) + dot(upperTents, upper)) /
      dot(lowerTents + upperTents, vec4(1.0));
    weight += there;
  }
}

// The point has to lie in a cell that is there: then its own tent alone weighs 1/8 at least.
float sampleBasis(Brick brick, uint others, Ray ray, float distance)
{
  float sum = 0.0;
  float weight = 0.0;
  while (true)
  {
    const vec3 q = toCells(brick, ray, distance);
    if (completed)
    {
      addCompleted(brick, q, sum, weight);
    }
    else
    {
      addTents(brick, q, sum, weight);
    }
    if (others == 0u)
    {
      break;
    }
    brick = nextBrick(others);
  }
  return clamp(sum / weight, 0.0, 1.0); // which rounding may pass
}

// Positions are exact to about 1e-4 half cells, or some units in the last place of the distance where
// that is more: this far behind a face, a point is in the next cell.
float behindFace(float distance)
{
  return distance + max(5e-4, 5e-7 * distance);
}

// Nearest: the value of the leaf cell that the ray enters at `distance`; `end` comes as the end of
// the region and goes as the end of the cell, if that is nearer. The field is constant in between,
// so the integral is exact. The region lies in leaf cells, so one of its bricks holds the point; by
// rounding it may miss them all by a hair, so take the closest. False: the cell is absent.
bool sampleNearest(
  Brick brick, uint others, Ray ray, float distance, inout float end, out float value)
{
  const float inside = min(behindFace(distance), end);
  float closest = 1e30;
  Brick holder = brick;
  uvec3 cell = uvec3(0);
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
  value = valueAt(holder, cellsOf(holder), cell);
  const ivec3 ahead = ivec3(cell) + ivec3(greaterThan(ray.direction, vec3(0.0)));
  const ivec3 face = holder.lo + 2 * holder.width * ahead;
  vec3 leaves = vec3(planeDistance(ray, face.x, 0), planeDistance(ray, face.y, 1),
    planeDistance(ray, face.z, 2));
  // A ray in a face does not leave through it.
  leaves = mix(leaves, vec3(1e30), lessThan(abs(ray.direction), vec3(1e-8)));
  const float leave = min(leaves.x, min(leaves.y, leaves.z));
  end = min(end, max(leave, inside));
  return value >= 0.0;
}
