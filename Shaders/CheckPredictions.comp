#version 460
// SPDX-License-Identifier: BSD-3-Clause
// What pixels that have been marched would have been predicted to be.
#extension GL_GOOGLE_include_directive : require
#include "Prediction.glsl"

layout(local_size_x = 64) in;

void main()
{
  const uint i = gl_GlobalInvocationID.x;
  if (i >= push.refinement.checks)
  {
    return;
  }
  const uint pixel = Numbers(push.refinement.pixels).items[i];
  const uint width = push.refinement.width;
  const ivec2 place = ivec2(pixel % width, pixel / width) / int(push.refinement.spacing);
  const Quad quad = predictQuad(place & ~1);
  Prediction prediction = quad.aslant;
  if ((place.y & 1) == 0)
  {
    prediction = quad.right;
  }
  else if ((place.x & 1) == 0)
  {
    prediction = quad.above;
  }
  const vec4 color = Pixels(push.refinement.picture).items[pixel];
  const vec4 off = color - prediction.color;
  Checks(push.refinement.results).items[i] = RayCheck(prediction.estimate, dot(off, off),
    max(color.a, prediction.color.a) >= DRAWN_OPACITY ? 1u : 0u);
}
