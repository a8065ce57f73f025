#version 460
// SPDX-License-Identifier: BSD-3-Clause
// As March.comp, with steps that do not adapt: the finest cells' everywhere.
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
#include "Absorption.glsl"
#include "Lighting.glsl"
#include "Blend.glsl"
#define enterRegion enterRegionByItsCells
#include "Cursor.glsl"
#undef enterRegion
#include "FinestSteps.glsl"
#include "MarchCells.glsl"
#include "MarchIntervals.glsl"
#include "MarchOn.glsl"
#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
