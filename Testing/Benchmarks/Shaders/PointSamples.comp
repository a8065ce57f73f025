#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, with the value at one point for the whole interval, instead of the mean over all
// values that it takes: MIDDLE or LEFT_END. As many samples for a step scale as ours.
#extension GL_GOOGLE_include_directive : require

layout(constant_id = 0) const bool nearest = false;
layout(constant_id = 1) const bool completed = false;

#include "Buffers.glsl"
#include "Constants.glsl"
#include "Ray.glsl"
#include "Reconstruction.glsl"
#include "TransferFunction.glsl"
#define enterRegion enterRegionForMeans
#define marchOn marchOnByMeans
#include "Integration.glsl"
#undef enterRegion
#undef marchOn

void enterRegion(uint firstBrick, float step, float entry, float exit, inout March march)
{
  enterRegionForMeans(firstBrick, step, entry, exit, march);
  const float interval = stepScale * abs(step);
  const float count = max(ceil((exit - entry) / interval), 1.0);
  march.interval = march.cut ? interval : (exit - entry) / count;
  march.intervals = march.cut ? 1 : uint(count);
}

void marchOn(Ray ray, inout March march)
{
  float end;
  if (findEnd(ray, march, end))
  {
#ifdef MIDDLE
    const float at = 0.5 * (march.entry + end);
#else
    const float at = march.entry;
#endif
    const float value = sampleBasis(march.brick, march.list, ray, at);
    const TransferPart part = findPart(transferBins, transferKnots, value);
    march.color += (1.0 - march.color.a) *
      absorb(mix(part.lower, part.upper, part.share),
        (end - march.entry) * ray.dataPerHalfCell * inverseUnit);
  }
  march.entry = end;
  march.intervals = march.cut ? (end < march.exit ? 1 : 0) : march.intervals - 1;
}

#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
