// SPDX-License-Identifier: BSD-3-Clause
// How the shaders reach the buffers of Layout.h: by device address, so that they may be of any size.
// Compiled twice: with HAS_INT64, 64 bits are read at once, which saves processors some per cent of
// a picture's time; without it, the shaders run on devices that have no integers of 64 bits.
#extension GL_EXT_buffer_reference : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_EXT_scalar_block_layout : require
#ifdef HAS_INT64
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#define DeviceAddress uint64_t
#define Word uint64_t
uvec2 unpackWord(Word word) { return unpackUint2x32(word); }
#else
#extension GL_EXT_buffer_reference_uvec2 : require
#define DeviceAddress uvec2
#define Word uvec2
uvec2 unpackWord(Word word) { return word; }
#endif

#include "Layout.h"

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer FrameBuffer { Frame frame; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Bricks { Word words[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer ActiveBoxes { ActiveBox items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer ShadowedBricks { ShadowedBrick items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Indices { uint items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer KdNodes { KdNode items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Addresses { Word words[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Values { float items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer TransferBins { Word words[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer TransferKnots { TransferKnot items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Colors { vec4 items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 16) writeonly buffer Picture { vec4 pixels[]; };

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Counter { uint next; };

layout(push_constant, scalar) uniform Push { Band band; } push;
