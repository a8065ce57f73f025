// SPDX-License-Identifier: BSD-3-Clause
// Blending as the march sees it. Each way of it has a file.
#include "Accumulator.glsl"
#include "Composite.glsl"
#include "Extremum.glsl"
#include "Sum.glsl"

Accumulator startAccumulator()
{
  Accumulator gathered;
  gathered.color = vec4(0.0);
  gathered.value = blending == BLENDING_MAXIMUM ? -1.0 : 2.0; // of no cell
  gathered.counted = 0.0;
#ifdef FAMILY_COMPONENTS
  gathered.values = vec4(gathered.value);
  gathered.sums = vec4(0.0);
  gathered.counts = vec4(0.0);
#endif
  return gathered;
}

// Whether nothing that comes behind counts. All values lie in [0, 1].
bool isComplete(Accumulator gathered)
{
  if (isSlice)
  {
    return gathered.value <= 1.0;
  }
  if (isExtremum)
  {
    return componentCount == 1u &&
      (blending == BLENDING_MAXIMUM ? gathered.value >= 1.0 : gathered.value <= 0.0);
  }
  return (isComposite || isIsosurface) && gathered.color.a >= terminationOpacity;
}

// Whether nothing of a node of the k-d tree, or of a box, can change what was gathered.
bool isPassed(uint index, Accumulator gathered)
{
  if (!isExtremum || componentCount > 1u || mixing == MIXING_PLANAR)
  {
    return false;
  }
  const float extreme = Values(constants.frame.extremes).items[index];
  return blending == BLENDING_MAXIMUM ? extreme <= gathered.value : extreme >= gathered.value;
}

// How much longer intervals may be: an error behind what is opaque is seen less.
float growthOfIntervals(Accumulator gathered)
{
  return isComposite
    ? exp2(-transmittanceExponent * log2(max(1.0 - gathered.color.a, 1.0 / 1024.0)))
    : 1.0;
}

// A length of the ray, in unit distances, at all of which the field has one value.
void addConstant(float value, float units, Spot spot, inout Accumulator gathered)
{
  if (isExtremum)
  {
    widenTo(value, gathered);
  }
  else if (isComposite)
  {
    compositeConstant(value, units, spot, gathered);
  }
  else
  {
    sumConstant(value, units, gathered);
  }
}

// A length of the ray in a cell without a value, which has come in its place.
void addAbsent(float value, float units, inout Accumulator gathered)
{
  if (showsUndefined && value == UNDEFINED)
  {
    const vec4 color = absorb(constants.frame.undefined, units);
    gathered.color += (1.0 - gathered.color.a) * color;
  }
}

// A length of the ray over which the field goes evenly from the one value to the other, from where
// the last one ended. `isFirst`: there was none, and this is but the point where the next begins.
void addInterval(
  float from, float to, float units, bool isFirst, Spot spot, inout Accumulator gathered)
{
  if (isExtremum)
  {
    widenTo(to, gathered);
  }
  else if (isComposite)
  {
    compositeInterval(from, to, units, isFirst, spot, gathered);
  }
  else
  {
    sumInterval(from, to, units, isFirst, gathered);
  }
}

// The three values at the ends of an interval and in its middle.
void addSamples(float first, float middle, float last, inout Accumulator gathered)
{
  if (isExtremum)
  {
    widenToVertex(first, middle, last, gathered);
  }
}

// Premultiplied red, green, blue, opacity.
vec4 toPixel(Accumulator gathered)
{
  return isExtremum                          ? colorOfExtremum(gathered)
    : isComposite || isIsosurface || isSlice ? gathered.color
                                             : colorOfSum(gathered);
}
