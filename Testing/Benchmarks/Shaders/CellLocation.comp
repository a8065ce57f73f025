#version 460
// SPDX-License-Identifier: BSD-3-Clause
// Cell location: as March.comp, but each sample finds its bricks by a walk down a tree over all
// bricks. Regions only skip space and give the length of intervals.
#extension GL_GOOGLE_include_directive : require

#include "Buffers.glsl"
#define readConstants readCommonConstants
#include "Constants.glsl"
#undef readConstants
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

#include "BrickTreeNode.h"

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer BrickTree { BrickTreeNode items[]; };

BrickTree brickTree;

// The method's own data lie where other traversals than by the k-d tree have their boxes.
void readConstants(FrameBuffer f)
{
  readCommonConstants(f);
  brickTree = BrickTree(f.frame.activeBoxes);
}

float sampleField(Brick brick, uint others, Ray ray, float distance)
{
  const vec3 local = ray.fraction + distance * ray.direction; // from the ray's base
  float sum = 0.0;
  float weight = 0.0;
  uint pending[BRICK_TREE_DEPTH];
  int pendingCount = 0;
  uint index = 0;
  while (true)
  {
    BrickTreeNode node = brickTree.items[index];
    uint axis = node.link & 3u;
    while (axis != BRICK_TREE_LEAF)
    {
      const float at = axis == 0 ? local.x : axis == 1 ? local.y : local.z;
      const int base = axis == 0 ? ray.base.x : axis == 1 ? ray.base.y : ray.base.z;
      const bool inLower = at < float(node.lowerEnd - base);
      const bool inUpper = at > float(node.upperBegin - base);
      if (!inLower && !inUpper)
      {
        break;
      }
      const uint lower = node.link >> 2;
      if (inLower && inUpper)
      {
        pending[pendingCount++] = lower + 1u;
      }
      node = brickTree.items[inLower ? lower : lower + 1u];
      axis = node.link & 3u;
    }
    if (axis == BRICK_TREE_LEAF)
    {
      const Brick found = readBrick(node.link >> 2);
      addBasis(found, toCells(found, ray, distance), 0u, sum, weight);
    }
    if (pendingCount == 0)
    {
      break;
    }
    index = pending[--pendingCount];
  }
  return clamp(sum / weight, 0.0, 1.0); // which rounding may pass
}

#include "TransferFunction.glsl"
#include "Absorption.glsl"
#include "Lighting.glsl"
#include "Blend.glsl"
#include "Cursor.glsl"
#include "MarchCells.glsl"
#include "MarchIntervals.glsl"
#include "MarchOn.glsl"
#include "TraverseKdTree.glsl"
#include "Pixel.glsl"
