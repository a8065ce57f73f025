// SPDX-License-Identifier: BSD-3-Clause
// Which pixel, or which cell, of those of a dispatch an invocation has.

layout(local_size_x = 8, local_size_y = 8) in;

// Called once.
uint takeNumber()
{
  return takesPixels ? atomicAdd(Counter(push.band.counter).next, 1u)
                     : gl_LocalInvocationIndex +
      64u * (gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_WorkGroupID.y);
}
