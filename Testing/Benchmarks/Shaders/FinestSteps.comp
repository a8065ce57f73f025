#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, with steps that do not adapt: the finest cells' everywhere.
#extension GL_GOOGLE_include_directive : require

layout(constant_id = 0) const bool nearest = false;
layout(constant_id = 1) const bool completed = false;

#include "Buffers.glsl"
#include "Constants.glsl"
#include "Ray.glsl"
#include "Reconstruction.glsl"
#include "TransferFunction.glsl"
#define enterRegion enterRegionByItsCells
#include "Integration.glsl"
#undef enterRegion
#include "FinestSteps.glsl"
#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
