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

// Where a ray ends as far from where those of its neighbours do, geometry has an edge.
const float BEND_OF_EDGE = 1.0 / 256.0;

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

Prediction predictBetween(vec4 a, vec4 b, vec4 c, vec4 d)
{
  return Prediction(cubic(a, b, c, d), estimate(a, b, c, d));
}

// Cubics pass what they interpolate. Colours are premultiplied, and above opacity where they are lit.
vec4 limit(vec4 color, vec4 most)
{
  color = max(color, vec4(0.0));
  color.a = min(color.a, 1.0);
  color.rgb = min(color.rgb, max(vec3(color.a), most.rgb));
  return color;
}

// The places between a known one and the next ones.
struct Quad
{
  Prediction right;
  Prediction above;
  Prediction aslant;
};

Quad predictFromColors(ivec2 corner)
{
  vec4 all[4][4]; // [column][row] of what is known around them
  const Prediction nothing = Prediction(vec4(0.0), 0.0);
  vec4 most = vec4(0.0);
  float sum = 0.0;
  for (int x = 0; x < 4; ++x)
  {
    for (int y = 0; y < 4; ++y)
    {
      all[x][y] = knownAt(corner + 2 * ivec2(x, y) - 2);
      most = max(most, all[x][y]);
      sum += dot(all[x][y], vec4(1.0));
    }
  }
  if (isnan(sum) || isinf(sum))
  {
    const Prediction never = Prediction(vec4(0.0), UNPREDICTABLE);
    return Quad(never, never, never);
  }
  if (most == vec4(0.0)) // as in the background, of which pictures have much
  {
    return Quad(nothing, nothing, nothing);
  }
  vec4 rows[4];
  vec4 columns[4];
  for (int k = 0; k < 4; ++k)
  {
    rows[k] = cubic(all[0][k], all[1][k], all[2][k], all[3][k]);
    columns[k] = cubic(all[k][0], all[k][1], all[k][2], all[k][3]);
  }
  Quad quad;
  quad.right = predictBetween(all[0][1], all[1][1], all[2][1], all[3][1]);
  quad.above = predictBetween(all[1][0], all[1][1], all[1][2], all[1][3]);
  quad.aslant = predictBetween(columns[0], columns[1], columns[2], columns[3]);
  quad.aslant.estimate =
    max(quad.aslant.estimate, estimate(rows[0], rows[1], rows[2], rows[3]));
  quad.right.color = limit(quad.right.color, most);
  quad.above.color = limit(quad.above.color, most);
  quad.aslant.color = limit(quad.aslant.color, most);
  return quad;
}

// The distance at which the pixel's ray ends, a fraction of that between the two depths that bracket
// the bounds: before and behind these geometry hides all, or nothing.
float endOfRay(ivec2 place)
{
  const float depth = Depths(push.refinement.depth).items[pixelAt(place)];
  const float fraction = clamp(
    (2.0 * depth - 1.0 - push.refinement.firstDepth) * push.refinement.inverseDepths, 0.0, 1.0);
  const float seen = fraction * push.refinement.secondW;
  return seen / ((1.0 - fraction) * push.refinement.firstW + seen);
}

// How far that is from going evenly between those of others, as it nearly does on a plane.
float bendOfEnds(ivec2 place, ivec2 off)
{
  return abs(endOfRay(place) - 0.5 * (endOfRay(place - off) + endOfRay(place + off)));
}

// Whether the prediction must not stand, whatever the colours are: there is nothing known behind the
// place, or geometry has an edge. `off`: to the known ones around it.
bool isUnpredictable(ivec2 place, ivec2 off)
{
  if (any(greaterThan(place + off, lastKnown())))
  {
    return true;
  }
  if (push.refinement.hasDepth == 0u)
  {
    return false;
  }
  float bend = bendOfEnds(place, off);
  if (off == ivec2(1, 1))
  {
    bend = max(bend, bendOfEnds(place, ivec2(1, -1)));
  }
  return bend > BEND_OF_EDGE;
}

void finish(inout Prediction prediction, ivec2 place, ivec2 off)
{
  if (isUnpredictable(place, off))
  {
    prediction.estimate = UNPREDICTABLE;
  }
}

// `corner`: even along both axes.
Quad predictQuad(ivec2 corner)
{
  Quad quad = predictFromColors(corner);
  finish(quad.right, corner + ivec2(1, 0), ivec2(1, 0));
  finish(quad.above, corner + ivec2(0, 1), ivec2(0, 1));
  finish(quad.aslant, corner + ivec2(1, 1), ivec2(1, 1));
  return quad;
}

bool isChecked(ivec2 place)
{
  const uint side = push.refinement.side;
  const uvec2 block = uvec2(place) / side;
  const uvec2 inside = uvec2(place) % side;
  return inside.x + side * inside.y == checkedPlace(block.x, block.y, side);
}
