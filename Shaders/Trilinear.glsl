// SPDX-License-Identifier: BSD-3-Clause
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
