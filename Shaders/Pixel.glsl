// SPDX-License-Identifier: BSD-3-Clause
// One invocation: the ray of one pixel, from its set-up to the picture.

#include "Invocation.glsl"
#include "Tile.glsl"

vec4 marchPixel(FrameBuffer f, uvec2 pixel)
{
  Accumulator gathered = startAccumulator();
  traverse(f, pixel, gathered);
#ifdef FAMILY_COMPONENTS
  return toPixelOfComponents(gathered);
#else
  return toPixel(gathered);
#endif
}

// The pixel of this invocation, of the rows or of the list that is marched. Tiles of 8 x 8 pixels come
// row by row. Beyond the picture: there is none.
uvec2 findPixel(uint width)
{
  const uint spacing = max(push.band.spacing, 1u);
  const uint gridWidth = (width + spacing - 1u) / spacing;
  const uint columns = (gridWidth + 7u) / 8u; // of tiles
  const uint i = takeNumber();
  if (push.band.spacing == 0u)
  {
    if (i >= push.band.count)
    {
      return uvec2(width);
    }
    const uint pixel = Indices(push.band.pixels).items[push.band.firstRow + i];
    return uvec2(pixel % width, pixel / width);
  }
  const uint tile = i / 64u;
  const uvec2 corner = 8u * uvec2(tile % columns, tile / columns);
  return spacing * (corner + placeInTile(i) + uvec2(0u, push.band.firstRow));
}

// Noise that is spread evenly among neighbours (interleaved gradient noise: Jimenez, "Next Generation
// Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014).
float findJitter(uvec2 pixel)
{
  const float noise = fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715))));
  return clamp(noise, 0.01, 0.99);
}

void main()
{
  FrameBuffer f = FrameBuffer(push.band.frame);
  const uvec2 pixel = findPixel(f.frame.width);
  if (pixel.x >= f.frame.width || pixel.y >= f.frame.height)
  {
    return;
  }
  readConstants(f);
  if (jittered)
  {
    jitterOfPixel = findJitter(pixel);
  }
  Picture(f.frame.picture).pixels[pixel.y * f.frame.width + pixel.x] = marchPixel(f, pixel);
}
