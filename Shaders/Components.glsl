// SPDX-License-Identifier: BSD-3-Clause
// Several components of one volume, and the one medium that they make (Core/Medium.h).

vec4 sampleComponents(Cursor cursor, Ray ray, float distance)
{
  Brick brick = cursor.brick;
  uint others = cursor.others;
  vec4 sum = vec4(0.0);
  vec4 weight = vec4(0.0);
  while (true)
  {
    const vec3 q = toCells(brick, ray, distance);
    for (uint k = 0u; k < componentCount; ++k)
    {
      if (isCompleted)
      {
        addCompleted(brick, q, k, sum[k], weight[k]);
      }
      else
      {
        addBasis(brick, q, k, sum[k], weight[k]);
      }
    }
    if (others == 0u)
    {
      break;
    }
    brick = nextBrick(others);
  }
  return clamp(sum / max(weight, 1e-30), 0.0, 1.0);
}

// Colour, times opacity, and opacity of a length over which all components go evenly from one value
// to another. Extinctions add up, each with its weight. Of dependent components there is one alone,
// which is white, and a colour beside it.
vec4 absorbComponents(vec4 from, vec4 to, float units)
{
  vec4 extinction = vec4(0.0);
  vec4 surfaces = vec4(0.0);
  vec3 color = vec3(1.0);
  if (mixing == MIXING_RGBA)
  {
    color = clamp(constants.frame.colorOffset + constants.frame.colorScale * (0.5 * (from + to)),
      0.0, 1.0).rgb;
  }
  const uint functions = mixing == MIXING_RGBA ? 1u : componentCount;
  for (uint i = 0u; i < functions; ++i)
  {
    const uint component = mixing == MIXING_RGBA ? 3u : i;
    const float weight = constants.frame.componentWeights[i];
    if (!(weight > 0.0))
    {
      continue;
    }
    selectFunction(i);
    const vec2 values = vec2(from[component], to[component]);
    const TransferPoint first = makePoint(findPart(values.x));
    const TransferPart part = findPart(values.y);
    const TransferPoint last = makePoint(part);
    vec4 found = meanBetween(first, last, values, part);
    if (mixing == MIXING_COLOR_AND_OPACITY && i == 0u)
    {
      color = found.rgb / found.a;
      continue;
    }
    if ((first.opaque & 1) != 0 || first.opaque != last.opaque)
    {
      // It may be opaque on its way, at any length.
      const vec4 seen = absorbBetween(first, last, values, part, units);
      surfaces += seen.a >= 1.0 ? seen : vec4(0.0);
      found = seen.a > 0.0 && seen.a < 1.0 ? seen * (-log(1.0 - seen.a) / (seen.a * units))
                                           : vec4(0.0);
    }
    extinction += weight * found;
  }
  const vec4 gathered = surfaces.a > 0.0 ? surfaces / surfaces.a : absorb(extinction, units);
  return gathered * vec4(color, 1.0);
}
