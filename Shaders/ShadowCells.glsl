// SPDX-License-Identifier: BSD-3-Clause
// One invocation: the share of a light that comes through the medium to the centre of a cell.

#include "Invocation.glsl"

layout(buffer_reference, scalar, buffer_reference_align = 4) writeonly buffer Shares { float items[]; };

void main()
{
  FrameBuffer f = FrameBuffer(push.band.frame);
  const uint i = takeNumber();
  if (i >= push.band.count)
  {
    return;
  }
  readConstants(f);
  const uint number = push.band.firstRow + i;
  const uint light = push.band.light;
  Brick brick;
  ivec3 cell;
  const uint at = findShadowedCell(f, number, brick, cell);
  float share = ABSENT;
  if (readValue(Values(brick.values), at, 0u) >= 0.0)
  {
    Accumulator gathered = startAccumulator();
    traverse(f, uvec2(number, light), gathered);
    share = 1.0 - gathered.color.a;
  }
  Shares(sharesOf(brick, light)).items[componentCount * at + light % componentCount] = share;
}
