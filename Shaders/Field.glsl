// SPDX-License-Identifier: BSD-3-Clause
// The field where it is continuous, at a point from a list of bricks: the reconstructions add their
// weighted values up brick by brick.

// Adds a brick's values at `q`, in cells from its lower corner, by the reconstruction.
void addReconstructed(Brick brick, vec3 q, uint component, inout float sum, inout float weight)
{
  if (isCompleted)
  {
    addCompleted(brick, q, component, sum, weight);
  }
  else
  {
    addBasis(brick, q, component, sum, weight);
  }
}

// The weighted values and the weights at the ray's point at `distance`. `others`: place of the rest of the
// list, 0: there is none.
void sumBricks(Brick brick, uint others, Ray ray, float distance, uint component, out float sum,
  out float weight)
{
  sum = 0.0;
  weight = 0.0;
  while (true)
  {
    addReconstructed(brick, toCells(brick, ray, distance), component, sum, weight);
    if (others == 0u)
    {
      break;
    }
    brick = nextBrick(others);
  }
}

// The ray's point has to lie in a cell that is there: then its own tent alone weighs 1/8 at least.
float sampleComponent(Brick brick, uint others, Ray ray, float distance, uint component)
{
  if (!isCompleted && others == 0u && (brick.dimensions & BRICK_HAS_ABSENT_CELLS) == 0u)
  {
    return interpolateBrick(brick, toCells(brick, ray, distance), component);
  }
  float sum;
  float weight;
  sumBricks(brick, others, ray, distance, component, sum, weight);
  return clamp(sum / weight, 0.0, 1.0); // which rounding may pass
}

// Of the first component, which most volumes have alone.
float sampleField(Brick brick, uint others, Ray ray, float distance)
{
  return sampleComponent(brick, others, ray, distance, 0u);
}
