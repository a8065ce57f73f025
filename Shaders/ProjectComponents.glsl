// SPDX-License-Identifier: BSD-3-Clause
// Several components where blending is not by absorption: extremes, sums and slices. The tables hold
// opacity.

// The greatest or least value of each independent component; of others all values where that of the
// leading one is.
void widenComponentsTo(vec4 values, inout Accumulator gathered)
{
  const vec4 compared = mixing == MIXING_INDEPENDENT ? values : vec4(values[leadingComponent]);
  const vec4 before =
    mixing == MIXING_INDEPENDENT ? gathered.values : vec4(gathered.values[leadingComponent]);
  const bvec4 wider = blending == BLENDING_MAXIMUM ? greaterThan(compared, before)
                                                   : lessThan(compared, before);
  gathered.values = mix(gathered.values, values, wider);
}

// As widenToVertex() (Extremum.glsl), of each component.
void widenComponentsToVertices(vec4 first, vec4 middle, vec4 last, inout Accumulator gathered)
{
  const vec4 bend = 2.0 * (first - 2.0 * middle + last);
  const vec4 slope = last - first - bend;
  const uint end = mixing == MIXING_INDEPENDENT ? componentCount : leadingComponent + 1u;
  for (uint k = mixing == MIXING_INDEPENDENT ? 0u : leadingComponent; k < end; ++k)
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

// Premultiplied colour and opacity of a piece of no length: of independent components the weighted
// sum. Extremes are neither shaded nor less opaque by gradients.
vec4 colorOfComponents(Piece piece)
{
  if (mixing == MIXING_PLANAR)
  {
    const vec4 color = colorOfPlanar(piece.to.xy);
    return isShaded && color.a > 0.0 ? shade(color, color.a, spotOfComponent(piece, 0u), 0u) : color;
  }
  const vec4 colors = mixing == MIXING_INDEPENDENT
    ? vec4(1.0)
    : vec4(meanColorOfComponents(piece.to, piece.to), 1.0);
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < opacityCount; ++i)
  {
    const uint component = componentOfOpacity(i);
    const Spot spot = spotOfComponent(piece, component);
    selectFunction(functionOfOpacity(i));
    const TransferPart part = findPart(piece.to[component]);
    vec4 color = colors * mix(part.lower, part.upper, part.fraction);
    color *= hasGradientOpacity ? opacityOfGradient(spot, i) : 1.0;
    color = isShaded && color.a > 0.0 ? shade(color, color.a, spot, i) : color;
    sum += constants.frame.componentWeights[i] * color;
  }
  return clamp(sum, 0.0, 1.0);
}

// Premultiplied red, green, blue, opacity.
vec4 toPixelOfComponents(Accumulator gathered)
{
  if (isComposite || isSlice)
  {
    return gathered.color;
  }
  if (isExtremum)
  {
    // as at the start: the ray has met no values
    const bool met = gathered.values.x >= 0.0 && gathered.values.x <= 1.0;
    Spot nowhere;
    nowhere.gradient = vec3(0.0);
    return met
      ? colorOfComponents(Piece(gathered.values, gathered.values, 0.0, mat4x3(0.0), nowhere))
      : vec4(0.0);
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
