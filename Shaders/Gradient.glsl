// SPDX-License-Identifier: BSD-3-Clause
// The field together with its gradient, analytically. A quantity and its derivatives along x, y and
// z are one vec4: w and xyz.

vec4 multiplyJets(vec4 a, vec4 b) { return vec4(a.w * b.xyz + b.w * a.xyz, a.w * b.w); }

vec4 divideJets(vec4 a, vec4 b)
{
  const float quotient = a.w / b.w;
  return vec4((a.xyz - quotient * b.xyz) / b.w, quotient);
}

// Trilinear, of the eight values around a point; derivatives by its place f.
vec4 interpolateJet(vec4 lower, vec4 upper, vec3 f)
{
  const vec4 xy = mix(lower, upper, f.z);
  const vec2 x = mix(xy.xy, xy.zw, f.y);
  const vec4 up = upper - lower;
  const vec2 upX = mix(up.xy, up.zw, f.y);
  const vec2 along = xy.zw - xy.xy;
  return vec4(x.y - x.x, mix(along.x, along.y, f.x), mix(upX.x, upX.y, f.x), mix(x.x, x.y, f.x));
}

// The tent of the distance from the box of cell centres, n along each axis, at q.
vec4 tentJet(vec3 q, vec3 n)
{
  const vec3 off = q - clamp(q, vec3(0.0), n - 1.0);
  const vec3 h = max(1.0 - abs(off), 0.0);
  return vec4(-sign(off) * vec3(h.y * h.z, h.x * h.z, h.x * h.y), h.x * h.y * h.z);
}

// Whether the brick's upper faces are those of the data's bounds.
bvec3 endsWithBounds(Brick brick, vec3 n)
{
  return equal(brick.lo + 2 * brick.width * ivec3(n), constants.frame.size);
}

// q, moved to the box of cell centres where the brick ends with the data's bounds: in the outermost
// half of a cell the field is constant, which would leave a dull skin on the data, and its slope is
// taken to go on.
vec3 insideBounds(Brick brick, vec3 q, vec3 n)
{
  const bvec3 first = equal(brick.lo, ivec3(0));
  q = mix(q, min(q, n - 1.0), endsWithBounds(brick, n));
  return mix(q, max(q, vec3(0.0)), first);
}

// Basis (Basis.glsl): adds a brick's tents at q, in cells from its lower corner; derivatives by half
// cells.
void addBasisJet(Brick brick, vec3 q, uint component, inout vec4 sum, inout vec4 weight)
{
  const uvec3 n = cellsOf(brick);
  q -= 0.5;
  const vec4 w = tentJet(q, vec3(n));
  if (w.w <= 0.0)
  {
    return;
  }
  const vec3 c = clamp(q, vec3(0.0), vec3(n) - 1.0);
  vec4 lower;
  vec4 upper;
  const vec3 f = readCells(brick, n, c, component, lower, upper);
  vec4 present = vec4(0.0, 0.0, 0.0, 1.0);
  // Outside of the box of centres the nearest place in it counts.
  const vec4 inside = vec4(equal(insideBounds(brick, q, vec3(n)), c), true);
  if ((brick.dimensions & BRICK_HAS_ABSENT_CELLS) != 0u)
  {
    const vec4 lowerThere = vec4(greaterThanEqual(lower, vec4(0.0)));
    const vec4 upperThere = vec4(greaterThanEqual(upper, vec4(0.0)));
    present = interpolateJet(lowerThere, upperThere, f) * inside;
    lower *= lowerThere;
    upper *= upperThere;
  }
  const vec4 value = interpolateJet(lower, upper, f) * inside;
  const vec4 toHalfCells = vec4(vec3(0.5 / float(brick.width)), 1.0);
  sum += multiplyJets(w, value) * toHalfCells;
  weight += multiplyJets(w, present) * toHalfCells;
}

// Completed (Completed.glsl), likewise.
void addCompletedJet(Brick brick, vec3 q, uint component, inout vec4 sum, inout vec4 weight)
{
  const uvec3 n = cellsOf(brick);
  q -= 0.5;
  vec4 w = tentJet(q, vec3(n));
  if (w.w <= 0.0)
  {
    return;
  }
  q = insideBounds(brick, q, vec3(n));
  // -1 to n - 1; behind the last centre before the bounds the slope before it goes on
  const vec3 i = min(floor(q), vec3(n) - mix(vec3(1.0), vec3(2.0), endsWithBounds(brick, vec3(n))));
  const vec3 f = q - i;
  vec4 lower;
  vec4 upper;
  readLattice(brick, n, i, component, lower, upper);
  vec4 value;
  if ((brick.dimensions & BRICK_HAS_ABSENT_CELLS) == 0u)
  {
    value = interpolateJet(lower, upper, f);
  }
  else
  {
    const vec4 lowerThere = vec4(greaterThanEqual(lower, vec4(0.0)));
    const vec4 upperThere = vec4(greaterThanEqual(upper, vec4(0.0)));
    // those of the brick's own cells
    const vec3 first = vec3(greaterThanEqual(i, vec3(0.0)));
    const vec3 last = vec3(lessThan(i, vec3(n) - 1.0));
    const vec4 own = vec4(first.x * first.y, last.x * first.y, first.x * last.y, last.x * last.y);
    w = interpolateJet(own * first.z * lowerThere, own * last.z * upperThere, f);
    if (w.w <= 0.0)
    {
      return;
    }
    value = divideJets(interpolateJet(lower * lowerThere, upper * upperThere, f),
      interpolateJet(lowerThere, upperThere, f));
  }
  const vec4 toHalfCells = vec4(vec3(0.5 / float(brick.width)), 1.0);
  sum += multiplyJets(w, value) * toHalfCells;
  weight += w * toHalfCells;
}

// As addReconstructed() (Field.glsl).
void addReconstructedJet(Brick brick, vec3 q, uint component, inout vec4 sum, inout vec4 weight)
{
  if (isCompleted)
  {
    addCompletedJet(brick, q, component, sum, weight);
  }
  else
  {
    addBasisJet(brick, q, component, sum, weight);
  }
}

// As sampleComponent() (Field.glsl): the field at the ray's point, and its gradient by half cells.
// Where cells have one value each, the gradient is that of the basis.
vec4 sampleComponentJet(Brick brick, uint others, Ray ray, float distance, uint component)
{
  vec4 sum = vec4(0.0);
  vec4 weight = vec4(0.0);
  while (true)
  {
    addReconstructedJet(brick, toCells(brick, ray, distance), component, sum, weight);
    if (others == 0u)
    {
      break;
    }
    brick = nextBrick(others);
  }
  vec4 jet = divideJets(sum, weight);
  jet.w = clamp(jet.w, 0.0, 1.0);
  return jet;
}

// Of the first component.
vec4 sampleFieldJet(Brick brick, uint others, Ray ray, float distance)
{
  return sampleComponentJet(brick, others, ray, distance, 0u);
}
