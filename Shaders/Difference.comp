#version 460
// SPDX-License-Identifier: BSD-3-Clause
// How much two pictures of the same pixels differ, summed by one group in an order that is always
// the same.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference_uvec2 : require
#define DeviceAddress uvec2

#include "Layout.h"

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer Pixels
{
  vec4 items[];
};
layout(buffer_reference, scalar, buffer_reference_align = 8) writeonly buffer Differences
{
  PictureDifference item;
};
layout(push_constant, scalar) uniform Push { Comparison comparison; } push;

shared float squares[gl_WorkGroupSize.x];
shared uint drawn[gl_WorkGroupSize.x];

void main()
{
  Pixels a = Pixels(push.comparison.first);
  Pixels b = Pixels(push.comparison.second);
  const uint lane = gl_LocalInvocationIndex;
  float sum = 0.0;
  uint count = 0;
  for (uint i = lane; i < push.comparison.pixels; i += gl_WorkGroupSize.x)
  {
    const vec4 p = a.items[i];
    const vec4 q = b.items[i];
    if (max(p.a, q.a) >= DRAWN_OPACITY)
    {
      sum += dot(p - q, p - q);
      ++count;
    }
  }
  squares[lane] = sum;
  drawn[lane] = count;
  barrier();
  for (uint reach = gl_WorkGroupSize.x / 2; reach > 0; reach /= 2)
  {
    if (lane < reach)
    {
      squares[lane] += squares[lane + reach];
      drawn[lane] += drawn[lane + reach];
    }
    barrier();
  }
  if (lane == 0)
  {
    Differences(push.comparison.result).item =
      PictureDifference(squares[0], drawn[0]);
  }
}
