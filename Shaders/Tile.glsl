// SPDX-License-Identifier: BSD-3-Clause
// Places of a tile of 8 x 8 along a Z-order curve: those of a subgroup, of whatever size, lie close
// together, and take about as long.
uvec2 placeInTile(uint i)
{
  return uvec2((i & 1u) | (i >> 1u & 2u) | (i >> 2u & 4u), (i >> 1u & 1u) | (i >> 2u & 2u) | (i >> 3u & 4u));
}
