#version 460
// SPDX-License-Identifier: BSD-3-Clause
// Predicts the pixels of a grid from those at its even places, and lists those that are to be marched.
#extension GL_GOOGLE_include_directive : require
#include "Prediction.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main()
{
  const ivec2 place = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(place, placesOfGrid())) || (place & 1) == ivec2(0) || isChecked(place))
  {
    return;
  }
  const Prediction prediction = predict(place);
  if (prediction.estimate < push.refinement.threshold)
  {
    Pixels(push.refinement.picture).items[pixelAt(place)] = prediction.color;
    return;
  }
  const uint at = atomicAdd(Numbers(push.refinement.results).items[0], 1u);
  Numbers(push.refinement.pixels).items[at] = pixelAt(place);
}
