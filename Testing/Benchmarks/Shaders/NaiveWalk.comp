#version 460
// SPDX-License-Identifier: BSD-3-Clause
// The walk through the hierarchy that ExaBricks starts from: each sample asks, for each level, for
// each of the eight cells of the level around it, which leaf cell holds that cell's centre, by a
// descent from the root of a k-d tree over the bricks; if it is the cell itself, its tent counts.
// Steps are those of the finest cells everywhere. Rays still end intervals at regions, so that the
// picture is that of FinestSteps.comp.
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
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Lattices { LevelLattice items[]; };

uint levelCount;
Lattices lattices;
BrickTree brickTree; // without overlaps

// The address so many bytes on.
#ifdef HAS_INT64
DeviceAddress offsetBy(DeviceAddress address, uint bytes) { return address + bytes; }
#else
DeviceAddress offsetBy(DeviceAddress address, uint bytes)
{
  uint carry;
  const uint low = uaddCarry(address.x, bytes, carry);
  return uvec2(low, address.y + carry);
}
#endif

// The method's own data lie where other traversals than by the k-d tree have their boxes.
void readConstants(FrameBuffer f)
{
  readCommonConstants(f);
  levelCount = Indices(f.frame.activeBoxes).items[0];
  lattices = Lattices(offsetBy(f.frame.activeBoxes, 4u));
  brickTree = BrickTree(offsetBy(f.frame.activeBoxes, 4u + 16u * levelCount));
}

// The value of the cell of this width with this centre (half cells). False: it is no leaf cell.
bool findLeafCell(ivec3 center, int width, out float value)
{
  BrickTreeNode node = brickTree.items[0];
  while ((node.link & 3u) != BRICK_TREE_LEAF)
  {
    const uint axis = node.link & 3u;
    const int at = axis == 0 ? center.x : axis == 1 ? center.y : center.z;
    node = brickTree.items[(node.link >> 2) + uint(at >= node.lowerEnd)];
  }
  const Brick brick = readBrick(node.link >> 2);
  const ivec3 inside = center - brick.lo;
  const ivec3 cell = inside / (2 * brick.width);
  const bool holds =
    all(greaterThanEqual(inside, ivec3(0))) && all(lessThan(cell, ivec3(cellsOf(brick))));
  if (!holds || brick.width != width)
  {
    return false;
  }
  value = valueAt(brick, cellsOf(brick), uvec3(cell), 0u);
  return value >= 0.0; // absent ones are not there
}

float sampleField(Brick brick, uint others, Ray ray, float distance)
{
  const vec3 local = ray.fraction + distance * ray.direction;
  float sum = 0.0;
  float weight = 0.0;
  for (uint level = 0; level < levelCount; ++level)
  {
    const LevelLattice lattice = lattices.items[level];
    const int size = 2 * lattice.width; // half cells
    // In cells from the first one's centre; whole ones apart, so that the rest has all its digits.
    const ivec3 fromFirst = ray.base - lattice.origin - lattice.width;
    ivec3 i = fromFirst / size;
    vec3 f = (vec3(fromFirst - i * size) + local) / float(size);
    i += ivec3(floor(f));
    f -= floor(f);
    for (int corner = 0; corner < 8; ++corner)
    {
      const ivec3 upper = ivec3(corner, corner >> 1, corner >> 2) & 1;
      const vec3 h = mix(1.0 - f, f, vec3(upper));
      float value;
      if (findLeafCell(lattice.origin + (i + upper) * size + lattice.width, lattice.width, value))
      {
        sum += h.x * h.y * h.z * value;
        weight += h.x * h.y * h.z;
      }
    }
  }
  return clamp(sum / weight, 0.0, 1.0);
}

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
