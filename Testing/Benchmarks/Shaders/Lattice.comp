#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, with intervals that are not fitted to the region: they end at whole multiples of
// their length along the ray, and where regions end.
#extension GL_GOOGLE_include_directive : require

layout(constant_id = 0) const bool nearest = false;
layout(constant_id = 1) const bool completed = false;

#include "Buffers.glsl"
#include "Constants.glsl"
#include "Ray.glsl"
#include "Reconstruction.glsl"
#include "TransferFunction.glsl"
#define enterRegion enterRegionAndFit
#define marchOn marchFitted
#include "Integration.glsl"
#undef enterRegion
#undef marchOn

float latticeStep; // of the region that the ray is in

void enterRegion(uint firstBrick, float step, float entry, float exit, inout March march)
{
  enterRegionAndFit(firstBrick, step, entry, exit, march);
  latticeStep = 2.0 * stepScale * abs(step);
  march.halved = true;
  march.intervals = 1;
}

// The interval up to the next multiple is marched as if the region ended there.
void marchOn(Ray ray, inout March march)
{
  const float exit = march.exit;
  float next = (floor(march.entry / latticeStep) + 1.0) * latticeStep;
  next = next > march.entry ? next : march.entry + latticeStep; // rounding
  march.exit = min(exit, next);
  marchFitted(ray, march);
  march.exit = exit;
  march.intervals = march.entry < exit ? 1 : 0;
}

#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
