#version 460
// SPDX-License-Identifier: BSD-3-Clause
// Predicts the pixels of a grid from those at its even places, and lists those that are to be marched.
#extension GL_GOOGLE_include_directive : require
#include "Prediction.glsl"
#include "Tile.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void put(Prediction prediction, ivec2 place)
{
  if (any(greaterThanEqual(place, placesOfGrid())) || isChecked(place))
  {
    return;
  }
  if (prediction.estimate < push.refinement.threshold)
  {
    Pixels(push.refinement.picture).items[pixelAt(place)] = prediction.color;
    return;
  }
  const uint at = atomicAdd(Numbers(push.refinement.results).items[0], 1u);
  Numbers(push.refinement.pixels).items[at] = pixelAt(place);
}

void main()
{
  const ivec2 corner =
    2 * ivec2(8u * gl_WorkGroupID.xy + placeInTile(gl_LocalInvocationIndex));
  if (any(greaterThanEqual(corner, placesOfGrid())))
  {
    return;
  }
  const Quad quad = predictQuad(corner);
  put(quad.right, corner + ivec2(1, 0));
  put(quad.above, corner + ivec2(0, 1));
  put(quad.aslant, corner + ivec2(1, 1));
}
