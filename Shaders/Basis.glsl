// SPDX-License-Identifier: BSD-3-Clause
// Basis: the mean of the cells' values weighted with their tents, B = sum H_c v_c / sum H_c (Wald et
// al. 2020, section 3). Within a brick the tents add up to trilinear interpolation times the tent of
// the distance from the box of cell centres.

// The values of the eight cells around `c`, in cells from the lower corner's centre and within the box
// of cell centres, n along each axis; and where c lies among them.
vec3 readCells(
  Brick brick, uvec3 n, vec3 c, uint component, out vec4 lower, out vec4 upper)
{
  const vec3 corner = min(floor(c), vec3(max(ivec3(n) - 2, 0)));
  const uvec3 i = toIndex(corner);
  const uint dx = n.x > 1u ? 1u : 0u;
  const uint dy = n.y > 1u ? n.x : 0u;
  const uint dz = n.z > 1u ? n.x * n.y : 0u;
  const uint at = i.x + n.x * (i.y + n.y * i.z);
  Values values = Values(brick.values);
  lower = vec4(readValue(values, at, component), readValue(values, at + dx, component),
    readValue(values, at + dy, component), readValue(values, at + dy + dx, component));
  upper = vec4(readValue(values, at + dz, component), readValue(values, at + dz + dx, component),
    readValue(values, at + dz + dy, component), readValue(values, at + dz + dy + dx, component));
  return c - corner;
}

// Of a brick alone, all of whose cells are there: whatever its tents weigh.
float interpolateBrick(Brick brick, vec3 q, uint component)
{
  const uvec3 n = cellsOf(brick);
  vec4 lower;
  vec4 upper;
  const vec3 f =
    readCells(brick, n, clamp(q - 0.5, vec3(0.0), vec3(n) - 1.0), component, lower, upper);
  return clamp(interpolate(lower, upper, f), 0.0, 1.0); // which rounding may pass
}

// Adds a brick's tents at `q`, in cells from its lower corner.
void addBasis(Brick brick, vec3 q, uint component, inout float sum, inout float weight)
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
  vec4 lower;
  vec4 upper;
  const vec3 f = readCells(brick, n, c, component, lower, upper);
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
