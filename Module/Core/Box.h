// SPDX-License-Identifier: BSD-3-Clause
// Half-open integer boxes on the lattice of cells.
#ifndef ExaBricksCoreBox_h
#define ExaBricksCoreBox_h

#include "Core/LatticeVolume.h"

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/ext/vector_int3_sized.hpp>
#include <glm/ext/vector_uint3_sized.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace exabricks
{
using Int3 = glm::i64vec3;

struct Box
{
  Int3 lo{ 0 };
  Int3 hi{ 0 }; // first lattice point outside

  Int3 size() const { return this->hi - this->lo; }
  bool empty() const
  {
    return this->lo.x >= this->hi.x || this->lo.y >= this->hi.y || this->lo.z >= this->hi.z;
  }
  /// For boxes with no side longer than 2^31.
  LatticeVolume volume() const
  {
    const glm::u64vec3 s(this->size());
    return this->empty() ? LatticeVolume() : LatticeVolume(s.x, s.y, s.z);
  }
  bool contains(const Box& other) const
  {
    return glm::all(glm::lessThanEqual(this->lo, other.lo)) &&
      glm::all(glm::lessThanEqual(other.hi, this->hi));
  }
  bool contains(const Int3& p) const
  {
    return glm::all(glm::lessThanEqual(this->lo, p)) && glm::all(glm::lessThan(p, this->hi));
  }
  bool intersects(const Box& other) const
  {
    return glm::all(glm::lessThan(this->lo, other.hi)) &&
      glm::all(glm::lessThan(other.lo, this->hi));
  }
  bool operator==(const Box& other) const { return this->lo == other.lo && this->hi == other.hi; }
  bool operator!=(const Box& other) const { return !(*this == other); }
};

inline Box intersection(const Box& a, const Box& b)
{
  return { glm::max(a.lo, b.lo), glm::min(a.hi, b.hi) };
}

/// Smallest box around both; an empty box adds nothing.
inline Box unite(const Box& a, const Box& b)
{
  return a.empty() ? b : b.empty() ? a : Box{ glm::min(a.lo, b.lo), glm::max(a.hi, b.hi) };
}

inline std::int64_t floorDivide(std::int64_t a, std::int64_t b)
{
  return a / b - (a % b < 0 ? 1 : 0);
}

/// The smallest box of whole cells of `width` around `box`, counted in these cells.
inline Box outwardToCells(const Box& box, std::int64_t width)
{
  Box cells;
  for (int axis = 0; axis < 3; ++axis)
  {
    cells.lo[axis] = floorDivide(box.lo[axis], width);
    cells.hi[axis] = -floorDivide(-box.hi[axis], width);
  }
  return cells;
}

inline Box scaled(const Box& box, std::int64_t factor)
{
  return { box.lo * factor, box.hi * factor };
}

/// Whether `box` consists of whole cells of `width`.
inline bool alignedTo(const Box& box, std::int64_t width)
{
  return scaled(outwardToCells(box, width), width) == box;
}

/// The parts of `box` below and above `plane` along `axis`.
inline std::pair<Box, Box> split(const Box& box, int axis, std::int64_t plane)
{
  std::pair<Box, Box> parts{ box, box };
  parts.first.hi[axis] = plane;
  parts.second.lo[axis] = plane;
  return parts;
}

/// The axis along which a size is largest; the first one where several are equal.
template <typename Size>
int longestAxis(const Size& size)
{
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}
}

#endif
