#version 460
// SPDX-License-Identifier: BSD-3-Clause
// The march of March.comp, to count: the picture is, per pixel, the number of samples of the field
// (red), of intervals (green), of regions entered (blue) and of steps down the tree (opacity).
#extension GL_GOOGLE_include_directive : require

layout(constant_id = 0) const bool nearest = false;
layout(constant_id = 1) const bool completed = false;

#include "Buffers.glsl"
#include "Constants.glsl"
#include "Ray.glsl"

uvec4 counts = uvec4(0);

#define sampleBasis sampleUncounted
#include "Reconstruction.glsl"
#undef sampleBasis

float sampleBasis(Brick brick, uint others, Ray ray, float distance)
{
  ++counts.r;
  return sampleUncounted(brick, others, ray, distance);
}

#include "TransferFunction.glsl"
#define enterRegion enterUncounted
#define marchOn marchUncounted
#include "Integration.glsl"
#undef enterRegion
#undef marchOn

void enterRegion(uint firstBrick, float step, float entry, float exit, inout March march)
{
  ++counts.b;
  enterUncounted(firstBrick, step, entry, exit, march);
}

void marchOn(Ray ray, inout March march)
{
  const float before = march.entry;
  marchUncounted(ray, march);
  counts.g += uint(march.entry > before); // not where only a first point was sampled
}

// Each step down asks for the distance of one plane.
float planeDistanceOfStep(Ray ray, int plane, uint axis)
{
  ++counts.a;
  return planeDistance(ray, plane, axis);
}

#define march marchAlong
#define planeDistance planeDistanceOfStep
#include "TraverseKdTree.glsl"
#undef march
#undef planeDistance

void march(FrameBuffer f, uvec2 pixel, Ray ray, inout March state)
{
  marchAlong(f, pixel, ray, state);
  state.color = vec4(counts);
}

#include "Pixel.glsl"
