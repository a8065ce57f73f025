#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, with the value at one point for the whole interval, instead of the mean over all
// values that it takes: MIDDLE or LEFT_END. As many samples for a step scale as ours.
#extension GL_GOOGLE_include_directive : require

#include "Buffers.glsl"
#include "Constants.glsl"
#include "Variant.glsl"
#include "ToIndex.glsl"
#include "Camera.glsl"
#include "Ray.glsl"
#include "Bricks.glsl"
#include "PixelWay.glsl"
#include "Segments.glsl"
#include "Advance.glsl"
#include "LeafCell.glsl"
#include "Trilinear.glsl"
#include "Basis.glsl"
#include "Completed.glsl"
#include "Gradient.glsl"
#include "Field.glsl"
#include "TransferFunction.glsl"
#include "Absorption.glsl"
#include "Lighting.glsl"
#include "Blend.glsl"
#define enterRegion enterRegionForMeans
#include "Cursor.glsl"
#undef enterRegion
#include "MarchIntervals.glsl"

void enterRegion(Ray ray, uint firstBrick, float step, float growth, float entry, float exit,
  inout Cursor cursor)
{
  enterRegionForMeans(ray, firstBrick, step, growth, entry, exit, cursor);
  const float interval = stepScale * abs(step);
  const float count = max(ceil((exit - entry) / interval), 1.0);
  cursor.interval = cursor.cut ? interval : (exit - entry) / count;
  cursor.intervals = cursor.cut ? 1 : uint(count);
}

void marchOn(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  float end;
  if (findEnd(ray, cursor, end))
  {
#ifdef MIDDLE
    const float at = 0.5 * (cursor.entry + end);
#else
    const float at = cursor.entry;
#endif
    addConstant(sampleField(cursor.brick, cursor.others, ray, at),
      (end - cursor.entry) * ray.unitsPerHalfCell, spotAt(ray, cursor.brick, cursor.others, at, vec2(0.0), vec3(0.0)), gathered);
  }
  cursor.entry = end;
  cursor.intervals = cursor.cut ? (end < cursor.exit ? 1 : 0) : cursor.intervals - 1;
}

#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
