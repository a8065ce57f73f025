// SPDX-License-Identifier: BSD-3-Clause
// Which pixels have rays to check by how well the others are predicted: host and shaders choose the
// same. Included by C++ and by GLSL.
#ifndef EXABRICKS_CHECKED_PIXELS_H
#define EXABRICKS_CHECKED_PIXELS_H

#ifdef __cplusplus
#include <cstdint>
namespace exabricks
{
namespace layout
{
#define EXABRICKS_FUNCTION constexpr std::uint32_t
using PixelNumber = std::uint32_t;
#else
#define EXABRICKS_FUNCTION uint
#define PixelNumber uint
#endif

// Of a block of side x side pixels of a grid, the number of the one that is checked, x fastest.
// Places are spread as if by chance (a hash), so that nothing in a picture is as regular.
EXABRICKS_FUNCTION checkedPlace(PixelNumber column, PixelNumber row, PixelNumber side)
{
  PixelNumber hash = (column * 0x9e3779b1u) ^ (row * 0x85ebca77u + 0x27d4eb2fu);
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
  hash = (hash ^ (hash >> 12)) * 0x297a2d39u;
  return (hash ^ (hash >> 15)) % (side * side);
}

#ifdef __cplusplus
} // namespace layout
} // namespace exabricks
#endif

#endif
