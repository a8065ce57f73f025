#version 460
// SPDX-License-Identifier: BSD-3-Clause
// Marches the ray of each pixel region by region, front to back. Compiled once for each traversal:
// TRAVERSAL_KDTREE walks the k-d tree over the regions; TRAVERSAL_RAYQUERY asks an acceleration
// structure of the active regions for the next few.
#extension GL_GOOGLE_include_directive : require
#ifdef TRAVERSAL_RAYQUERY
#extension GL_EXT_ray_query : require
#endif

layout(constant_id = 0) const bool nearest = false;
layout(constant_id = 1) const bool completed = false; // neither: basis

#include "Buffers.glsl"
#include "Constants.glsl"
#include "Ray.glsl"
#include "Reconstruction.glsl"
#include "TransferFunction.glsl"
#include "Integration.glsl"
#ifdef TRAVERSAL_KDTREE
#include "TraverseKdTree.glsl"
#else
#include "TraverseRayQuery.glsl"
#endif
#include "Pixel.glsl"
