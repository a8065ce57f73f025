#version 460
// SPDX-License-Identifier: BSD-3-Clause
// Marches the ray of each pixel region by region, front to back, or with MARCH_SHADOWS that of each cell
// to a light. Compiled once for each traversal:
// TRAVERSAL_KDTREE walks the k-d tree over the regions; TRAVERSAL_RAYQUERY asks an acceleration
// structure of the active regions for the next few.
#extension GL_GOOGLE_include_directive : require
#ifdef TRAVERSAL_RAYQUERY
#extension GL_EXT_ray_query : require
#endif

#include "Buffers.glsl"
#include "Constants.glsl"
#include "Variant.glsl"
#include "ToIndex.glsl"

// The ray of a pixel, or of a cell.
#include "Camera.glsl"
#include "Ray.glsl"
#include "Bricks.glsl"
#ifdef MARCH_SHADOWS
#include "LightWay.glsl"
#else
#include "PixelWay.glsl"
#endif
#include "Segments.glsl"
#include "Advance.glsl"

// The field along it.
#include "LeafCell.glsl"
#include "Trilinear.glsl"
#include "Basis.glsl"
#include "Completed.glsl"
#include "Field.glsl"
#include "Gradient.glsl"
#include "Shadows.glsl"

// What it looks like.
#include "TransferFunction.glsl"
#if defined(FAMILY_COMPONENTS) || defined(FAMILY_SURFACE)
#include "Planar.glsl"
#endif
#include "Absorption.glsl"
#include "Lighting.glsl"
#include "Blend.glsl"

// The march.
#include "Cursor.glsl"
#include "MarchCells.glsl"
#include "MarchIntervals.glsl"
#if defined(FAMILY_COMPONENTS)
#include "Components.glsl"
#include "AbsorbComponents.glsl"
#include "AbsorbPlanar.glsl"
#include "ProjectComponents.glsl"
#include "MarchComponents.glsl"
#elif defined(FAMILY_SURFACE)
#include "Isosurface.glsl"
#include "MarchSurfaces.glsl"
#include "Slice.glsl"
#endif
#include "MarchOn.glsl"
#ifdef TRAVERSAL_KDTREE
#include "TraverseKdTree.glsl"
#else
#include "TraverseRayQuery.glsl"
#endif
#ifdef MARCH_SHADOWS
#include "ShadowCells.glsl"
#else
#include "Pixel.glsl"
#endif
