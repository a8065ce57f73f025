// SPDX-License-Identifier: BSD-3-Clause
// The buffers that host and shaders share: included by C++ (GLM types) and by GLSL (scalar block
// layout), so that both see the same bytes. Nothing else defines a buffer layout.
//
// Units: a *half cell* is half the width of a cell of the finest level. Positions in half cells are
// counted from the lower corner of the data's bounds, so that brick supports (a brick grown by half
// its own cell) have integer corners.
#ifndef EXABRICKS_LAYOUT_H
#define EXABRICKS_LAYOUT_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
namespace exabricks
{
namespace layout
{
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
using DeviceAddress = std::uint64_t;
#define EXABRICKS_CONST static constexpr
#else
// Buffers.glsl says what a DeviceAddress is: two words of 32 bits, which GLSL places at any 4
// bytes, on devices without integers of 64 bits. So that all agree, they lie at multiples of 8
// bytes.
#define EXABRICKS_CONST const
#endif

// A number as the sum of two floats, see FloatPair.glsl.
struct Pair
{
  float high;
  float low;
};
struct Pair4
{
  vec4 high;
  vec4 low;
};

// How the field is reconstructed between cell centres: a specialization constant.
EXABRICKS_CONST uint RECONSTRUCTION_BASIS = 0u;
EXABRICKS_CONST uint RECONSTRUCTION_NEAREST = 1u;
EXABRICKS_CONST uint RECONSTRUCTION_COMPLETED = 2u;

// How what lies along a ray becomes a colour: a specialization constant (Core/Blending.h).
EXABRICKS_CONST uint BLENDING_COMPOSITE = 0u;
EXABRICKS_CONST uint BLENDING_MAXIMUM = 1u;
EXABRICKS_CONST uint BLENDING_MINIMUM = 2u;
EXABRICKS_CONST uint BLENDING_AVERAGE = 3u;
EXABRICKS_CONST uint BLENDING_ADDITIVE = 4u;
EXABRICKS_CONST uint BLENDING_ISOSURFACE = 5u;
EXABRICKS_CONST uint BLENDING_SLICE = 6u;
EXABRICKS_CONST uint MOST_ISO_VALUES = 16u;

// How several components of a cell's values make one medium: a specialization constant
// (Core/Medium.h).
EXABRICKS_CONST uint MIXING_INDEPENDENT = 0u;
EXABRICKS_CONST uint MIXING_COLOR_AND_OPACITY = 1u;
EXABRICKS_CONST uint MIXING_RGBA = 2u;
EXABRICKS_CONST uint MIXING_PLANAR = 3u;
EXABRICKS_CONST uint MOST_COMPONENTS = 4u;

// A box of cells of one level. 32 bytes, which shaders read as BRICK_WORDS words of 64 bits.
struct Brick
{
  ivec3 lo;             // lower corner, half cells
  int width;            // of a cell, in finest cells
  uint dimensions;      // cells along x, y, z in 8 bits each, and BRICK_HAS_ABSENT_CELLS
  uint number;          // its own, from 0
  DeviceAddress values; // of the first one; x runs fastest, and within a cell its components
};
EXABRICKS_CONST uint BRICK_WORDS = 4u;
EXABRICKS_CONST uint BRICK_HAS_ABSENT_CELLS = 1u << 24;

// Cells of a level are there for one of several processes as far beyond its part, in cells.
EXABRICKS_CONST int PART_REACH = 2;

// Stands for the value of a cell that is absent (hidden). Values lie in [0, 1].
EXABRICKS_CONST float ABSENT = -1.0f;
// The same of one whose value is undefined (NaN, infinite), which may have a colour.
EXABRICKS_CONST float UNDEFINED = -2.0f;

// A box with a fixed list of bricks: no other brick's support reaches into it. 32 bytes.
struct Region
{
  ivec3 lo;        // half cells
  uint firstBrick; // position of its list in the brick lists
  ivec3 hi;
  uint brickCount; // 0: no data here
};

// A region, or a part of one, in which the transfer function shows something. 32 bytes.
struct ActiveBox
{
  ivec3 lo;        // half cells
  uint firstBrick; // as the region's
  ivec3 hi;
  float step; // at a step scale of 1, half cells; below 0: some cells are absent
};

// On the device the last brick of a list is marked.
EXABRICKS_CONST uint LAST_BRICK = 1u << 31;

// A node of a k-d tree. 8 bytes. link = 4 * index + axis for a split: the index is that of the
// lower child, the upper one follows it. A leaf of the tree over the regions: 4 * region + KD_LEAF,
// and `plane` is the width of the region's finest cells.
// One of the tree over the active boxes: 4 * firstBrick + KD_LEAF, and `plane` holds the bits of
// `step`.
struct KdNode
{
  int plane; // half cells
  uint link;
};
EXABRICKS_CONST uint KD_LEAF = 3u;
EXABRICKS_CONST uint KD_NO_REGION = (1u << 30) - 1u; // a leaf with nothing to draw

// The transfer function as an amount times red, green, blue, 1: extinction, -ln(1 - opacity of the
// unit distance), or opacity, where blending is not by absorption. Piecewise linear on [0, 1], in
// TRANSFER_BINS bins of equal width. A bin that is not the line between its ends (there are control
// points inside, or amounts bend) has lower.a = -1, and knots: integral.x is the first one's index,
// which stands at its lower end, integral.y how many there are up to that at its upper end.
//
// Beside them the integral over values, from 0 to the bin's lower end or to the knot, in units of
// Frame.integralUnit: as integers, so that differences of close ones are exact. And of the part
// from there on: 2 * (number of parts of opacity 1 before it) + (1 if it is one).
EXABRICKS_CONST int TRANSFER_BINS = 1024;
EXABRICKS_CONST float DENSEST = 16.635532f; // extinction of an opacity of 1 - 2^-24: taken for 1
struct TransferBin
{
  vec4 lower;
  vec4 upper;
  ivec4 integral;
  int opaque;
  int unused; // shaders read it as TRANSFER_BIN_WORDS words of 64 bits
};
EXABRICKS_CONST uint TRANSFER_BIN_WORDS = 7u;
struct TransferKnot
{
  vec4 lower; // at its value, and at that of the next knot: they differ at jumps
  vec4 upper;
  ivec4 integral;
  int opaque;
  float value;
};

// Core/Lighting.h has the words for these.
struct Light
{
  vec3 direction;
  vec3 diffuse;
  vec3 specular;
  vec3 position;
  vec3 attenuation;
  float cosineOfCone; // below 0: it shines in all directions
  float exponent;
  uint positional;
  vec3 inHalfCells; // its place, or the direction towards it, of length 1 there
};
EXABRICKS_CONST uint MOST_LIGHTS = 8u;
struct Material
{
  float ambient;
  float diffuse;
  float specular;
  float specularPower;
};

// Opacity by the gradient's magnitude: the change of the normalised value over the mean width of a
// finest cell.
EXABRICKS_CONST uint GRADIENT_OPACITIES = 1024u; // entries of the table
EXABRICKS_CONST float GREATEST_GRADIENT = 0.25f; // of the last one

// A brick whose cells' shares of light are found (ShadowCells.glsl), and how many cells the ones
// before it have together. 8 bytes.
struct ShadowedBrick
{
  uint brick;
  uint firstCell;
};

// A picture may have at most so many.
EXABRICKS_CONST uint MOST_CLIPPING_PLANES = 32u;

// One picture.
struct Frame
{
  // Homogeneous half cells of the picture's middle at two depths that bracket the bounds, and what
  // a pixel to the right and one up add to both.
  Pair4 first;
  Pair4 second;
  Pair4 perColumn;
  Pair4 perRow;
  Pair firstDepth;        // in normalised device coordinates
  Pair inverseDepths;     // 1 / (second - first)
  vec3 halfCellsToUnitsX; // columns of the linear map from half cells to opacity unit distances
  vec3 halfCellsToUnitsY;
  vec3 halfCellsToUnitsZ;
  ivec3 size; // of the bounds, half cells
  uint width; // pixels
  uint height;
  float stepScale;             // of the boxes' steps
  float transmittanceExponent; // steps grow with transmittance to the power of minus this
  float terminationOpacity;    // a ray ends at this opacity
  float integralUnit;          // of the transfer function's integrals
  uint hasDepth;               // 0: rays go to the far plane, the depth buffer is not read
  float fixedStep;             // in opacity unit distances; 0: the boxes' steps count
  DeviceAddress bricks;        // Brick[], uint[], KdNode[], ...
  DeviceAddress brickLists;
  DeviceAddress nodes;
  DeviceAddress activeBoxes; // ActiveBox[]: of the acceleration structure
  DeviceAddress transferBins;
  DeviceAddress transferKnots;
  DeviceAddress depth;     // float[height][width], window depth in [0, 1] at which rays end
  DeviceAddress nearDepth; // the same, at which they begin
  DeviceAddress picture;   // vec4[height][width], premultiplied, row 0 at the bottom
  DeviceAddress scene;     // acceleration structure

  // For variants that are shaded, or have opacity by gradients
  // float[GRADIENT_OPACITIES] of each component, by which extinction is multiplied
  DeviceAddress gradientOpacity;
  vec3 gradientToMagnitude; // for derivatives along x, y, z by half cells
  uint twoSided;
  vec3 halfCellsToWorldX; // columns of the linear map
  vec3 halfCellsToWorldY;
  vec3 halfCellsToWorldZ;
  vec3 gradientToWorldX; // columns of a map to the direction of the gradient in the world
  vec3 gradientToWorldY;
  vec3 gradientToWorldZ;
  uint lightCount;
  Light lights[MOST_LIGHTS];
  Material materials[MOST_COMPONENTS]; // of each component

  float isoValues[MOST_ISO_VALUES]; // normalised, ascending
  uint isoValueCount;

  // A place in half cells is left where its product with each plane, (x, y, z, 1) . plane, is not
  // below 0. xyz are of length 1.
  Pair4 clippingPlanes[MOST_CLIPPING_PLANES];
  // The two planes of each axis, half cells; w: 0. Which of their 27 regions are shown: bit x + 3 y
  // + 9 z, with x = 0 below the lower plane, 1 between the two, 2 from the upper one on.
  Pair4 croppingLower;
  Pair4 croppingUpper;
  uint clippingPlaneCount;
  uint shownRegions;

  vec4 leastToAverage; // normalised values of each component that count for BLENDING_AVERAGE
  vec4 mostToAverage;

  // For variants of several components. Their functions lie one after the other in transferBins.
  vec4 integralUnits;    // as integralUnit, of each function
  vec4 componentWeights; // by which extinctions are multiplied
  vec4 colorScale;       // of MIXING_RGBA: from normalised values to red, green, blue in [0, 1]
  vec4 colorOffset;

  Pair4 slicePlane; // of BLENDING_SLICE: as clippingPlanes

  // float[], of each node, or of each active box: the greatest value below it, for
  // BLENDING_MAXIMUM, or the least, for BLENDING_MINIMUM
  DeviceAddress extremes;

  DeviceAddress planar; // vec4[planarSize.y][planarSize.x], for MIXING_PLANAR
  ivec2 planarSize;

  vec4 undefined; // extinction of cells whose value is undefined, times red, green, blue, 1

  ivec3 partLower; // of the box that is drawn, where that is a part of the bounds; half cells
  ivec3 partUpper;

  // For variants that scatter: how the medium is lit (Core/Lighting.h)
  // Of [light / components of a cell][brick]: where the brick's shares of these lights begin, which
  // lie as its values do
  DeviceAddress shares;
  DeviceAddress shadowedBricks; // ShadowedBrick[]
  uint shadowedBrickCount;
  uint brickCount;
  float shadowReach; // along an axis as a multiple of the bounds' size along it; 0: nothing casts
                     // shadows
  float scatteringBlending;
  float scatteringAnisotropy;
};

// What one dispatch marches: some rows of a picture, or of a grid of its pixels, spaced evenly
// along each axis; or some pixels of a list.
struct Band
{
  DeviceAddress frame; // device address of the Frame
  DeviceAddress
    counter; // of a uint: the next pixel, in the order of tiles, where they are taken by it
  DeviceAddress pixels; // of the list: uint[], x + width * y
  uint firstRow;        // of the grid; of a list: its first pixel
  uint spacing;         // of the grid, pixels; 0: a list
  uint count;           // of the list's pixels that are marched
  uint light;           // of shadows: whose shares are found, in `count` cells from firstRow on
};

// What is done to predict the pixels of a grid from those at its even places (Prediction.glsl).
struct Refinement
{
  DeviceAddress picture; // vec4[height][width]
  DeviceAddress depth;   // float[height][width], if hasDepth is not 0
  DeviceAddress pixels;  // uint[]: list of those that are checked, or that are to be marched
  DeviceAddress results; // RayCheck[], of each checked one; or a uint, how many are to be marched
  uint width;            // pixels
  uint height;
  uint spacing; // of the grid, pixels
  uint side;    // of the blocks in which one place each is checked (CheckedPixels.h)
  uint checks;  // number of pixels that are checked
  uint hasDepth;
  // From window depths to distances along a ray, as fractions of what brackets the bounds (Frame)
  float firstDepth;
  float inverseDepths;
  float firstW;
  float secondW;
  float threshold; // predictions stand whose estimate is below; at most UNPREDICTABLE
};
EXABRICKS_CONST float UNPREDICTABLE = 1e30f; // estimate of what must not stand

// How well a pixel that has been marched would have been predicted.
struct RayCheck
{
  float estimate; // of the prediction's error
  float squares;  // its error, summed over the channels
  uint drawn;     // not 0: the pixel is, see DRAWN_OPACITY
};

// How much two pictures differ: what one dispatch of Difference.comp finds out.
struct Comparison
{
  DeviceAddress first; // device addresses of vec4[pixels]
  DeviceAddress second;
  DeviceAddress result; // of a PictureDifference
  uint pixels;
};
struct PictureDifference
{
  float squares; // summed over the channels of the drawn pixels
  uint drawn;    // pixels that are, in either picture
};
EXABRICKS_CONST float DRAWN_OPACITY = 1.0f / 255.0f; // that a drawn pixel has at least

#ifdef __cplusplus
static_assert(sizeof(Brick) == 8 * BRICK_WORDS, "as shaders read it");
static_assert(offsetof(Brick, values) == 24, "as in GLSL's scalar layout");
static_assert(sizeof(Region) == 32, "as in GLSL's scalar layout");
static_assert(sizeof(ActiveBox) == 32, "as in GLSL's scalar layout");
static_assert(sizeof(KdNode) == 8, "as in GLSL's scalar layout");
static_assert(sizeof(TransferBin) == 8 * TRANSFER_BIN_WORDS, "as shaders read it");
static_assert(sizeof(TransferKnot) == 56, "as in GLSL's scalar layout");
static_assert(sizeof(Band) == 40 && sizeof(Refinement) == 80 && sizeof(RayCheck) == 12,
  "as in GLSL's scalar layout");
static_assert(
  sizeof(Frame) == 2536 && offsetof(Frame, bricks) == 224, "as in GLSL's scalar layout");
static_assert(offsetof(Frame, lights) == 404 && offsetof(Frame, extremes) == 2432 &&
    offsetof(Frame, shares) == 2496,
  "as in GLSL's scalar layout");
} // namespace layout
} // namespace exabricks
#endif

#endif
