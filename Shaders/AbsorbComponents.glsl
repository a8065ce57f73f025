// SPDX-License-Identifier: BSD-3-Clause
// The one medium that several components make (Core/Medium.h).

// A piece of a ray over which all components go evenly from one value to another.
struct Piece
{
  vec4 from;
  vec4 to;
  float units;      // its length, in unit distances of opacity
  mat4x3 gradients; // in its middle, as sampleComponents() has them
  Spot spot;        // but for its gradient and its values
};

Spot spotOfComponent(Piece piece, uint component)
{
  Spot spot = piece.spot;
  spot.gradient = piece.gradients[component];
  spot.values = vec2(piece.from[component], piece.to[component]);
  return spot;
}

// Mean red, green and blue between the values of dependent components, whose colours do not absorb.
vec3 meanColorOfComponents(vec4 from, vec4 to)
{
  if (mixing == MIXING_RGBA)
  {
    return clamp(constants.frame.colorOffset + constants.frame.colorScale * (0.5 * (from + to)),
      0.0, 1.0).rgb;
  }
  selectFunction(0u);
  const TransferPoint first = makePoint(findPart(from.x));
  const TransferPart part = findPart(to.x);
  const vec4 color = meanBetween(first, makePoint(part), vec2(from.x, to.x), part);
  return color.rgb / color.a; // which is 1
}

// Functions of opacity: of which number, and of which component.
const uint opacityCount = mixing == MIXING_INDEPENDENT ? componentCount : 1u;
uint functionOfOpacity(uint i) { return mixing == MIXING_COLOR_AND_OPACITY ? 1u : i; }
uint componentOfOpacity(uint i) { return mixing == MIXING_INDEPENDENT ? i : componentCount - 1u; }

// Colour, times opacity, and opacity of a piece. Extinctions add up, each with its weight. Of dependent
// components there is one alone, which is white, and a colour beside it.
vec4 absorbComponents(Piece piece)
{
  vec4 extinction = vec4(0.0);
  vec4 surfaces = vec4(0.0);
  const vec4 color = vec4(
    mixing == MIXING_INDEPENDENT ? vec3(1.0) : meanColorOfComponents(piece.from, piece.to), 1.0);
  for (uint i = 0u; i < opacityCount; ++i)
  {
    const float weight = constants.frame.componentWeights[i];
    if (!(weight > 0.0))
    {
      continue;
    }
    const uint component = componentOfOpacity(i);
    const Spot spot = spotOfComponent(piece, component);
    selectFunction(functionOfOpacity(i));
    const vec2 values = vec2(piece.from[component], piece.to[component]);
    const TransferPoint first = makePoint(findPart(values.x));
    const TransferPart part = findPart(values.y);
    const TransferPoint last = makePoint(part);
    const float units = piece.units * (hasGradientOpacity ? opacityOfGradient(spot, i) : 1.0);
    vec4 found = meanBetween(first, last, values, part);
    vec4 surface = vec4(0.0);
    if ((first.opaque & 1) != 0 || first.opaque != last.opaque)
    {
      // It may be opaque on its way, at any length.
      const vec4 seen = absorbBetween(first, last, values, part, units);
      surface = seen.a >= 1.0 ? seen : vec4(0.0);
      found = seen.a > 0.0 && seen.a < 1.0 ? seen * (-log(1.0 - seen.a) / (seen.a * units))
                                           : vec4(0.0);
    }
    const float opacity = 1.0 - exp(-found.a); // of the unit distance, by the function alone
    found *= weight * (units / piece.units) * color;
    surface *= color;
    // It is one or the other.
    const bool isSurface = surface.a > 0.0;
    vec4 seen = isSurface ? surface : found;
    if (isShaded && seen.a > 0.0)
    {
      seen = shade(seen, isSurface ? 1.0 : opacity, spot, i);
    }
    extinction += isSurface ? vec4(0.0) : seen;
    surfaces += isSurface ? seen : vec4(0.0);
  }
  return surfaces.a > 0.0 ? surfaces / surfaces.a : absorb(extinction, piece.units);
}
