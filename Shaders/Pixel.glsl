// SPDX-License-Identifier: BSD-3-Clause
// One invocation: the ray of one pixel, from its set-up to the picture.

layout(local_size_x = 8, local_size_y = 8) in;

vec4 marchPixel(FrameBuffer f, uvec2 pixel)
{
  Accumulator gathered = startAccumulator();
  traverse(f, pixel, gathered);
  return toPixel(gathered);
}

void main()
{
  FrameBuffer f = FrameBuffer(push.band.frame);
  const uvec2 pixel = gl_GlobalInvocationID.xy + uvec2(0, push.band.firstRow);
  if (pixel.x >= f.frame.width || pixel.y >= f.frame.height)
  {
    return;
  }
  readConstants(f);
  Picture(f.frame.picture).pixels[pixel.y * f.frame.width + pixel.x] = marchPixel(f, pixel);
}
