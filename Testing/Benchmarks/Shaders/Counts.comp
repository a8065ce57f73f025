#version 460
// SPDX-License-Identifier: BSD-3-Clause
// The march of March.comp, to count: the picture is, per pixel, the number of samples of the field
// (red), of intervals (green), of regions entered (blue) and of steps down the tree (opacity).
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

uvec4 counts = uvec4(0);

#define sampleField sampleUncounted
#include "Field.glsl"
#undef sampleField

float sampleField(Brick brick, uint others, Ray ray, float distance)
{
  ++counts.r;
  return sampleUncounted(brick, others, ray, distance);
}

#include "TransferFunction.glsl"
#include "Absorption.glsl"
#include "Lighting.glsl"
#include "Blend.glsl"
#define enterRegion enterUncounted
#define marchOn marchUncounted
#include "Cursor.glsl"
#include "Isosurface.glsl"
#include "MarchCells.glsl"
#include "MarchIntervals.glsl"
#include "MarchOn.glsl"
#undef enterRegion
#undef marchOn

void enterRegion(
  Ray ray, uint firstBrick, float step, float growth, float entry, float exit, inout Cursor cursor)
{
  ++counts.b;
  enterUncounted(ray, firstBrick, step, growth, entry, exit, cursor);
}

void marchOn(Ray ray, inout Cursor cursor, inout Accumulator gathered)
{
  const float before = cursor.entry;
  marchUncounted(ray, cursor, gathered);
  counts.g += uint(cursor.entry > before); // not where only a first point was sampled
}

// Each step down asks for the distance of one plane.
float planeDistanceOfStep(Ray ray, int plane, uint axis)
{
  ++counts.a;
  return planeDistance(ray, plane, axis);
}

#define traverse traverseUncounted
#define planeDistance planeDistanceOfStep
#include "TraverseKdTree.glsl"
#undef traverse
#undef planeDistance

void traverse(FrameBuffer f, uvec2 place, inout Accumulator gathered)
{
  counts = uvec4(0);
  traverseUncounted(f, place, gathered);
  gathered.color = vec4(counts);
}

#include "Pixel.glsl"
