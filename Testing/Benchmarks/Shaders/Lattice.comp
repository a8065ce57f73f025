#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, with intervals that are not fitted to the region: they end at whole multiples of
// their length along the ray, and where regions end.
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
#define enterRegion enterRegionAndFit
#define marchOn marchFitted
#include "Cursor.glsl"
#include "MarchCells.glsl"
#include "MarchIntervals.glsl"
#include "MarchOn.glsl"
#undef enterRegion
#undef marchOn

float latticeStep; // of the region that the ray is in

void enterRegion(Ray ray, uint firstBrick, float step, float growth, float entry, float exit,
  inout Cursor cursor)
{
  enterRegionAndFit(ray, firstBrick, step, growth, entry, exit, cursor);
  latticeStep = 2.0 * stepScale * abs(step);
  cursor.halved = true;
  cursor.intervals = 1;
}

// The interval up to the next multiple is marched as if the region ended there.
void marchOn(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  const float exit = cursor.exit;
  float next = (floor(cursor.entry / latticeStep) + 1.0) * latticeStep;
  next = next > cursor.entry ? next : cursor.entry + latticeStep; // rounding
  cursor.exit = min(exit, next);
  marchFitted(ray, cursor, gathered);
  cursor.exit = exit;
  cursor.intervals = cursor.entry < exit ? 1 : 0;
}

#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
