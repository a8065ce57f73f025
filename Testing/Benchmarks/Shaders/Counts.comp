#version 460
// SPDX-License-Identifier: BSD-3-Clause
// The march of March.comp, to count: the picture is, per pixel, the number of samples of the field
// (red), of intervals (green), of regions entered (blue) and of steps down the tree (opacity). With
// COUNT_LANES: of halves of intervals that show nothing (red); of times round the loop of intervals
// (blue), and down the tree, that a subgroup of lanes goes, shared among the lanes that are on (green
// and opacity), so that sums over pixels are those of subgroups.
#extension GL_GOOGLE_include_directive : require
#ifdef COUNT_LANES
#extension GL_KHR_shader_subgroup_ballot : require
#endif

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
uint nothings = 0u;
uint rounds = 0u;
float shareOfRounds = 0.0;
float shareOfSteps = 0.0;

// Of what a subgroup does once.
float shareOfLane()
{
#ifdef COUNT_LANES
  return 1.0 / float(subgroupBallotBitCount(subgroupBallot(true)));
#else
  return 1.0;
#endif
}

#define sampleField sampleUncounted
#include "Field.glsl"
#undef sampleField

float sampleField(Brick brick, uint others, Ray ray, float distance)
{
  ++counts.r;
  return sampleUncounted(brick, others, ray, distance);
}

#include "TransferFunction.glsl"
#define absorbBetween absorbUncounted
#include "Absorption.glsl"
#undef absorbBetween

vec4 absorbBetween(
  TransferPoint from, TransferPoint to, vec2 values, TransferPart part, float units)
{
  const vec4 color = absorbUncounted(from, to, values, part, units);
  nothings += color.a > 0.0 ? 0u : 1u;
  return color;
}

#include "Lighting.glsl"
#include "Blend.glsl"
#define enterRegion enterUncounted
#define marchOn marchUncounted
#include "Cursor.glsl"
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
  ++rounds;
  shareOfRounds += shareOfLane();
  const float before = cursor.entry;
  marchUncounted(ray, cursor, gathered);
  counts.g += uint(cursor.entry > before); // not where only a first point was sampled
}

// Each step down asks for the distance of one plane.
float planeDistanceOfStep(Ray ray, int plane, uint axis)
{
  ++counts.a;
  shareOfSteps += shareOfLane();
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
  nothings = 0u;
  rounds = 0u;
  shareOfRounds = 0.0;
  shareOfSteps = 0.0;
  traverseUncounted(f, place, gathered);
#ifdef COUNT_LANES
  gathered.color = vec4(nothings, shareOfRounds, rounds, shareOfSteps);
#else
  gathered.color = vec4(counts);
#endif
}

#include "Pixel.glsl"
