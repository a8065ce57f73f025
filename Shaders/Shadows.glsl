// SPDX-License-Identifier: BSD-3-Clause
// How much of a light comes through the medium to a place: the shares of the cells (ShadowCells.glsl),
// reconstructed as the field is.

// Where a brick's shares of a light are: as components of its values would be.
DeviceAddress sharesOf(Brick brick, uint light)
{
  return Addresses(constants.frame.shares)
    .words[light / componentCount * constants.frame.brickCount + brick.number];
}

// The ray's point at `distance` has to lie in a cell that is there.
float shareOfLight(Brick brick, uint others, Ray ray, float distance, uint light)
{
  const uint component = light % componentCount;
  float sum = 0.0;
  float weight = 0.0;
  while (true)
  {
    const vec3 q = toCells(brick, ray, distance);
    brick.values = sharesOf(brick, light);
    addReconstructed(brick, q, component, sum, weight);
    if (others == 0u)
    {
      break;
    }
    brick = nextBrick(others);
  }
  return clamp(sum / weight, 0.0, 1.0);
}
