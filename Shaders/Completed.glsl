// SPDX-License-Identifier: BSD-3-Clause
// Completed: W_l T_l / sum of W_l over the levels l. W_l is the sum of the level's tents, as in the
// basis; T_l interpolates all eight lattice points of the level around the point, those too that are
// none of its leaf cells. Bricks of a level agree on T_l, so each adds it with its own tents' weight.

// The values of the eight lattice points from `i` on, -1 to n - 1.
void readLattice(
  Brick brick, uvec3 n, vec3 i, uint component, out vec4 lower, out vec4 upper)
{
  const uint dy = n.x + 2u;
  const uint dz = dy * (n.y + 2u);
  const uint at = placeOf(n, ivec3(i));
  Values values = Values(brick.values);
  lower = vec4(readValue(values, at, component), readValue(values, at + 1u, component),
    readValue(values, at + dy, component), readValue(values, at + dy + 1u, component));
  upper = vec4(readValue(values, at + dz, component), readValue(values, at + dz + 1u, component),
    readValue(values, at + dz + dy, component), readValue(values, at + dz + dy + 1u, component));
}

// Adds a brick's part at `q`, in cells from its lower corner.
void addCompleted(Brick brick, vec3 q, uint component, inout float sum, inout float weight)
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
  vec4 lower;
  vec4 upper;
  readLattice(brick, n, i, component, lower, upper);
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
