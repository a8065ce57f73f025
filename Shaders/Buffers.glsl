// SPDX-License-Identifier: BSD-3-Clause
// How the shaders reach the buffers of Layout.h: by device address, so that they may be of any size.
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference_uvec2 : require

#include "Layout.h"

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer FrameBuffer { Frame frame; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Bricks { Brick items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer ActiveBoxes { ActiveBox items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Indices { uint items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer KdNodes { KdNode items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Values { float items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer TransferBins { TransferBin items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer TransferKnots { TransferKnot items[]; };
layout(buffer_reference, scalar, buffer_reference_align = 16) writeonly buffer Picture { vec4 pixels[]; };

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Counter { uint next; };

layout(push_constant, scalar) uniform Push { Band band; } push;
