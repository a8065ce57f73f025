// SPDX-License-Identifier: BSD-3-Clause
// Several components where blending is not by absorption: extremes, sums and slices. The tables hold
// opacity.

// The greatest or least value of each independent component; of dependent ones all values where the
// last one, which has opacity, is greatest or least.
void widenComponentsTo(vec4 values, inout Accumulator gathered)
{
  const vec4 compared =
    mixing == MIXING_INDEPENDENT ? values : vec4(values[componentCount - 1u]);
  const vec4 before =
    mixing == MIXING_INDEPENDENT ? gathered.values : vec4(gathered.values[componentCount - 1u]);
  const bvec4 wider = blending == BLENDING_MAXIMUM ? greaterThan(compared, before)
                                                   : lessThan(compared, before);
  gathered.values = mix(gathered.values, values, wider);
}

// As widenToVertex() (Extremum.glsl), of each component.
void widenComponentsToVertices(vec4 first, vec4 middle, vec4 last, inout Accumulator gathered)
{
  const vec4 bend = 2.0 * (first - 2.0 * middle + last);
  const vec4 slope = last - first - bend;
  for (uint k = mixing == MIXING_INDEPENDENT ? 0u : componentCount - 1u; k < componentCount; ++k)
  {
    const float where = -0.5 * slope[k] / bend[k]; // where nothing bends, it is nowhere
    if (where > 0.0 && where < 1.0)
    {
      const vec4 values = clamp(first + where * (slope + where * bend), 0.0, 1.0);
      vec4 candidate = gathered.values;
      if (mixing == MIXING_INDEPENDENT)
      {
        candidate[k] = values[k];
      }
      else
      {
        candidate = values;
      }
      widenComponentsTo(candidate, gathered);
    }
  }
}

// Of each function of opacity: the integral of values times their opacity, and the length on which
// they count. Dependent components sum up the first one, with the opacity of the last.
void sumComponents(Piece piece, inout Accumulator gathered)
{
  for (uint i = 0u; i < opacityCount; ++i)
  {
    const uint component = componentOfOpacity(i);
    selectFunction(functionOfOpacity(i));
    const vec2 values = vec2(piece.from[component], piece.to[component]);
    const TransferPoint first = makePoint(findPart(values.x));
    const TransferPart part = findPart(values.y);
    const vec4 mean = meanBetween(first, makePoint(part), values, part);
    const uint summed = mixing == MIXING_INDEPENDENT ? i : 0u;
    const float counted = fractionThatCounts(piece.from[summed], piece.to[summed],
      vec2(constants.frame.leastToAverage[summed], constants.frame.mostToAverage[summed]));
    gathered.sums[i] += piece.units *
      (mixing == MIXING_INDEPENDENT
          ? mean.r
          : mean.a * counted * 0.5 * (piece.from[summed] + piece.to[summed]));
    gathered.counts[i] += counted * piece.units;
  }
}

// Premultiplied colour and opacity of values: of independent components the weighted sum.
vec4 lookUpComponents(vec4 values)
{
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < opacityCount; ++i)
  {
    selectFunction(functionOfOpacity(i));
    const TransferPart part = findPart(values[componentOfOpacity(i)]);
    sum += constants.frame.componentWeights[i] * mix(part.lower, part.upper, part.fraction);
  }
  if (mixing != MIXING_INDEPENDENT)
  {
    sum *= vec4(meanColorOfComponents(values, values), 1.0);
  }
  return clamp(sum, 0.0, 1.0);
}

// Premultiplied red, green, blue, opacity.
vec4 toPixelOfComponents(Accumulator gathered)
{
  if (isComposite)
  {
    return gathered.color;
  }
  if (isExtremum || isSlice)
  {
    // as at the start: the ray has met no values
    const bool met = gathered.values.x >= 0.0 && gathered.values.x <= 1.0;
    return met ? lookUpComponents(gathered.values) : vec4(0.0);
  }
  float sum = 0.0;
  bool any = false;
  for (uint i = 0u; i < opacityCount; ++i)
  {
    const bool counts = gathered.counts[i] > 0.0;
    const float divisor = blending == BLENDING_AVERAGE && counts ? gathered.counts[i] : 1.0;
    sum += constants.frame.componentWeights[i] * gathered.sums[i] / divisor;
    any = any || counts;
  }
  return any ? vec4(vec3(clamp(sum, 0.0, 1.0)), 1.0) : vec4(0.0);
}
