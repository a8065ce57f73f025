#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, without opacity correction: every sample is as opaque as if it stood for the width
// of a cell of the finest level. Step scale 1 is right in the finest regions; coarser ones, whose
// samples stand for more, come out too transparent, and finer steps too opaque.
#extension GL_GOOGLE_include_directive : require

layout(constant_id = 0) const bool nearest = false;
layout(constant_id = 1) const bool completed = false;

#include "Buffers.glsl"
#include "Constants.glsl"
#define makeRay makeRayAlone
#include "Ray.glsl"
#undef makeRay
#include "Reconstruction.glsl"
#define absorbBetween absorbLength
#include "TransferFunction.glsl"
#undef absorbBetween

float unitsPerSample; // unit distances

bool makeRay(FrameBuffer f, uvec2 pixel, double skip, out Ray ray)
{
  const bool hits = makeRayAlone(f, pixel, skip, ray);
  unitsPerSample = 2.0 * ray.dataPerHalfCell * inverseUnit;
  return hits;
}

vec4 absorbBetween(TransferBins bins, TransferKnots knots, TransferPoint from, TransferPoint to,
  TransferPart part, float integralUnit, float units)
{
  return absorbLength(bins, knots, from, to, part, integralUnit, unitsPerSample);
}

#include "Integration.glsl"
#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
