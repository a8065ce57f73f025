// SPDX-License-Identifier: BSD-3-Clause
// The components of a volume and their gradients, where the field is continuous.

// Of components that are not independent, the one that has opacity; of a function of two variables the
// first one.
const uint leadingComponent = mixing == MIXING_PLANAR ? 0u : componentCount - 1u;

// Whether a component's gradient is asked for.
bool hasGradient(uint component)
{
  return needsGradient && (mixing == MIXING_INDEPENDENT || component == leadingComponent);
}

// `gradients`: by half cells, a column for each component that has one.
vec4 sampleComponents(Cursor cursor, Ray ray, float distance, out mat4x3 gradients)
{
  Brick brick = cursor.brick;
  uint others = cursor.others;
  mat4 sums = mat4(0.0); // of each component a column: gradient and value
  mat4 weights = mat4(0.0);
  while (true)
  {
    const vec3 q = toCells(brick, ray, distance);
    for (uint k = 0u; k < componentCount; ++k)
    {
      if (hasGradient(k))
      {
        addReconstructedJet(brick, q, k, sums[k], weights[k]);
      }
      else
      {
        addReconstructed(brick, q, k, sums[k].w, weights[k].w);
      }
    }
    if (others == 0u)
    {
      break;
    }
    brick = nextBrick(others);
  }
  vec4 values = vec4(0.0);
  gradients = mat4x3(0.0);
  for (uint k = 0u; k < componentCount; ++k)
  {
    values[k] = clamp(sums[k].w / weights[k].w, 0.0, 1.0);
    if (hasGradient(k))
    {
      gradients[k] = divideJets(sums[k], weights[k]).xyz;
    }
  }
  if (mapsGradient)
  {
    values.y = shareOfGradient(gradients[0]);
  }
  return values;
}
