#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, without opacity correction: every sample is as opaque as if it stood for the width
// of a cell of the finest level. Step scale 1 is right in the finest regions; coarser ones, whose
// samples stand for more, come out too transparent, and finer steps too opaque.
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
#define absorbBetween absorbLength
#include "Absorption.glsl"
#undef absorbBetween

float unitsPerSample; // unit distances

vec4 absorbBetween(
  TransferPoint from, TransferPoint to, vec2 values, TransferPart part, float units)
{
  return absorbLength(from, to, values, part, unitsPerSample);
}

#include "Lighting.glsl"
#include "Blend.glsl"
#include "Cursor.glsl"
#include "MarchCells.glsl"
#define marchInterval marchLength
#include "MarchIntervals.glsl"
#undef marchInterval

void marchInterval(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  unitsPerSample = 2.0 * ray.unitsPerHalfCell;
  marchLength(ray, cursor, gathered);
}

#include "MarchOn.glsl"
#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
