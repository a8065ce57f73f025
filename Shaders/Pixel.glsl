// SPDX-License-Identifier: BSD-3-Clause
// One invocation: the ray of one pixel, from its set-up to the picture.

layout(local_size_x = 8, local_size_y = 8) in;

void main()
{
  FrameBuffer f = FrameBuffer(push.band.frame);
  const uvec2 pixel = gl_GlobalInvocationID.xy + uvec2(0, push.band.firstRow);
  if (pixel.x >= f.frame.width || pixel.y >= f.frame.height)
  {
    return;
  }
  readConstants(f);
  March state;
  state.intervals = 0;
  state.exit = -1.0;
  state.known = false;
  state.last.value = 0.0;
  state.color = vec4(0.0);
  Ray ray;
  if (makeRay(f, pixel, 0.0LF, ray))
  {
    march(f, pixel, ray, state);
  }
  Picture(f.frame.picture).pixels[pixel.y * f.frame.width + pixel.x] = state.color;
}
