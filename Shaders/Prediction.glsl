// SPDX-License-Identifier: BSD-3-Clause
// A pixel's colour from pixels around it whose rays are known: those at even places of a grid.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference_uvec2 : require
#define DeviceAddress uvec2

#include "Layout.h"
#include "CheckedPixels.h"

layout(buffer_reference, scalar, buffer_reference_align = 16) buffer Pixels { vec4 items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Depths { float items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Numbers { uint items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) writeonly buffer Checks { RayCheck items[]; };

layout(push_constant, scalar) uniform Push { Refinement refinement; } push;

struct Prediction
{
  vec4 color;
  float estimate; // of its error; UNPREDICTABLE, where it must not stand
};

uint pixelAt(ivec2 place)
{
  return push.refinement.spacing * (uint(place.y) * push.refinement.width + uint(place.x));
}

// Places of a grid along each axis, and of those that are known, the last one.
ivec2 placesOfGrid()
{
  const uvec2 size = uvec2(push.refinement.width, push.refinement.height);
  return ivec2((size - 1u) / push.refinement.spacing + 1u);
}
ivec2 lastKnown() { return (placesOfGrid() - 1) & ~1; }

vec4 knownAt(ivec2 place)
{
  return Pixels(push.refinement.picture).items[pixelAt(clamp(place, ivec2(0), lastKnown()))];
}

// In the middle of four values at equal distances, by the cubic through all of them.
vec4 cubic(vec4 a, vec4 b, vec4 c, vec4 d) { return (9.0 * (b + c) - (a + d)) / 16.0; }

// What lines would err by there, at both sides: in the middle of a step the two have other signs, and
// their mean, by which cubics and lines differ, would tell nothing.
float estimate(vec4 a, vec4 b, vec4 c, vec4 d)
{
  const vec4 off = max(abs(a - 2.0 * b + c), abs(b - 2.0 * c + d)) / 8.0;
  return max(max(off.r, off.g), max(off.b, off.a));
}

Prediction predictAlong(ivec2 place, ivec2 axis)
{
  const vec4 a = knownAt(place - 3 * axis);
  const vec4 b = knownAt(place - axis);
  const vec4 c = knownAt(place + axis);
  const vec4 d = knownAt(place + 3 * axis);
  return Prediction(cubic(a, b, c, d), estimate(a, b, c, d));
}

Prediction predictBetween(ivec2 place)
{
  vec4 all[4][4]; // [column][row]
  vec4 columns[4];
  for (int x = 0; x < 4; ++x)
  {
    for (int y = 0; y < 4; ++y)
    {
      all[x][y] = knownAt(place + 2 * ivec2(x, y) - 3);
    }
    columns[x] = cubic(all[x][0], all[x][1], all[x][2], all[x][3]);
  }
  vec4 rows[4];
  for (int y = 0; y < 4; ++y)
  {
    rows[y] = cubic(all[0][y], all[1][y], all[2][y], all[3][y]);
  }
  return Prediction(cubic(columns[0], columns[1], columns[2], columns[3]),
    max(estimate(columns[0], columns[1], columns[2], columns[3]),
      estimate(rows[0], rows[1], rows[2], rows[3])));
}

float depthAt(ivec2 place) { return Depths(push.refinement.depth).items[pixelAt(place)]; }

// How far the depth at which the pixel's ray ends is from going evenly between those of others, as it
// does on a plane.
float bendOfDepth(ivec2 place, ivec2 off)
{
  return abs(depthAt(place) - 0.5 * (depthAt(place - off) + depthAt(place + off)));
}

// `place`: not even along both axes.
Prediction predict(ivec2 place)
{
  const bvec2 odd = bvec2((place.x & 1) != 0, (place.y & 1) != 0);
  Prediction prediction;
  if (odd.x && odd.y)
  {
    prediction = predictBetween(place);
  }
  else
  {
    prediction = predictAlong(place, ivec2(odd));
  }
  prediction.color = max(prediction.color, vec4(0.0));
  prediction.color.a = min(prediction.color.a, 1.0);
  const bool atEnd = any(greaterThan(place + ivec2(odd), lastKnown()));
  if (!atEnd && push.refinement.hasDepth != 0u)
  {
    const float bend = odd.x && odd.y
      ? max(bendOfDepth(place, ivec2(1, 1)), bendOfDepth(place, ivec2(1, -1)))
      : bendOfDepth(place, ivec2(odd));
    prediction.estimate = bend > push.refinement.greatestBend ? UNPREDICTABLE : prediction.estimate;
  }
  // Also where a colour is no number.
  prediction.estimate = atEnd || !(prediction.estimate >= 0.0) ? UNPREDICTABLE : prediction.estimate;
  return prediction;
}

bool isChecked(ivec2 place)
{
  const uint side = push.refinement.side;
  const uvec2 block = uvec2(place) / side;
  const uvec2 inside = uvec2(place) % side;
  return inside.x + side * inside.y == checkedPlace(block.x, block.y, side);
}
