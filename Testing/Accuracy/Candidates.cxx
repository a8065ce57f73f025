// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/Candidates.h"

#include "Reference/ForEachPoint.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace exabricks
{
namespace accuracy
{
using reference::forEachPoint;

namespace
{
constexpr double none = std::numeric_limits<double>::quiet_NaN();

glm::dvec3 center(const Int3& cell, std::int64_t width)
{
  return (glm::dvec3(cell) + 0.5) * static_cast<double>(width);
}
}

std::size_t Candidates::Level::at(const Int3& cell) const
{
  const Int3 at = cell - this->bounds.lo;
  const Int3 size = this->bounds.size();
  return static_cast<std::size_t>(at.x + size.x * (at.y + size.y * at.z));
}

bool Candidates::Level::isLeaf(const Int3& cell) const
{
  return this->bounds.contains(cell) && !std::isnan(this->values[this->at(cell)]);
}

Candidates::Candidates(
  const Hierarchy& hierarchy, const LeafBoxes& leaves, const reference::CellField& field)
  : Levels(hierarchy.levels())
  , Min(std::numeric_limits<double>::infinity())
  , Max(-std::numeric_limits<double>::infinity())
{
  for (int l = 0; l < hierarchy.levels(); ++l)
  {
    Level& level = this->Levels[l];
    level.width = hierarchy.cellWidth[l];
    for (const LeafBox& leaf : leaves.boxes)
    {
      if (leaf.level == l)
      {
        level.bounds = unite(level.bounds, outwardToCells(leaf.box, level.width));
      }
    }
    if (level.bounds.empty())
    {
      continue;
    }
    level.bounds = { level.bounds.lo - std::int64_t(1), level.bounds.hi + std::int64_t(1) };
    level.values.assign(static_cast<std::size_t>(level.bounds.volume()), none);
    for (const LeafBox& leaf : leaves.boxes)
    {
      if (leaf.level == l)
      {
        forEachPoint(outwardToCells(leaf.box, level.width),
          [&](const Int3& cell)
          {
            const double value = field(l, cell);
            level.values[level.at(cell)] = value;
            this->Min = std::min(this->Min, value);
            this->Max = std::max(this->Max, value);
          });
      }
    }
  }
  for (int l = 0; l < hierarchy.levels(); ++l)
  {
    Level& level = this->Levels[l];
    level.gradients.resize(level.values.size());
    forEachPoint(level.bounds,
      [&](const Int3& cell)
      {
        if (level.isLeaf(cell))
        {
          level.gradients[level.at(cell)] = this->FindGradient(l, cell);
        }
      });
  }
  for (int l = 0; l < hierarchy.levels(); ++l)
  {
    Level& level = this->Levels[l];
    level.completedBeyond = level.completed = level.values;
    forEachPoint(level.bounds,
      [&](const Int3& cell)
      {
        if (!level.isLeaf(cell))
        {
          this->Complete(l, cell);
        }
      });
    // Beyond the bounds the value stays, also that of a cell that is no leaf cell itself.
    forEachPoint(level.bounds,
      [&](const Int3& cell)
      {
        const Int3 inside = glm::clamp(
          cell, leaves.bounds.lo / level.width, leaves.bounds.hi / level.width - std::int64_t(1));
        if (inside != cell)
        {
          level.completed[level.at(cell)] = level.completed[level.at(inside)];
        }
      });
  }
}

// Calls visit(level, cell, share of the face) for the leaf cells that touch a face of the cell.
template <typename Visitor>
void Candidates::ForEachFaceNeighbour(int l, const Int3& cell, const Visitor& visit) const
{
  const std::int64_t width = this->Levels[l].width;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    Int3 beside = cell;
    beside[axis] += face % 2 ? 1 : -1;
    const Box region = scaled({ beside, beside + std::int64_t(1) }, width);
    for (int k = 0; k < static_cast<int>(this->Levels.size()); ++k)
    {
      const Level& level = this->Levels[k];
      Box touching = outwardToCells(region, level.width);
      if (k > l) // finer: those at the face
      {
        (face % 2 ? touching.hi : touching.lo)[axis] =
          face % 2 ? touching.lo[axis] + 1 : touching.hi[axis] - 1;
      }
      const double n = static_cast<double>(std::max<std::int64_t>(1, width / level.width));
      forEachPoint(touching,
        [&](const Int3& c)
        {
          if (level.isLeaf(c))
          {
            visit(k, c, 1.0 / (n * n));
          }
        });
    }
  }
}

// The plane that fits the leaf cells across the faces best, weighted with 1 / distance^2: central
// differences inside a level, and exact for linear fields across levels.
glm::dvec3 Candidates::FindGradient(int l, const Int3& cell) const
{
  const Level& own = this->Levels[l];
  const double value = own.values[own.at(cell)];
  const glm::dvec3 middle = center(cell, own.width);
  glm::dmat3 matrix(0.0);
  glm::dvec3 right(0.0);
  this->ForEachFaceNeighbour(l, cell,
    [&](int k, const Int3& c, double share)
    {
      const Level& level = this->Levels[k];
      const glm::dvec3 off = center(c, level.width) - middle;
      const double weight = share / glm::dot(off, off);
      matrix += glm::outerProduct(off, off) * weight;
      right += off * (weight * (level.values[level.at(c)] - value));
    });
  // Where neighbours do not tell the slope along all axes, none along the rest.
  const double mean = (matrix[0][0] + matrix[1][1] + matrix[2][2]) / 3.0;
  if (glm::determinant(matrix) < 1e-3 * mean * mean * mean || !(mean > 0.0))
  {
    matrix += glm::dmat3(1e-6 * mean + 1e-300);
  }
  return glm::inverse(matrix) * right;
}

// The mean of what the leaf cells say that hold the cell's centre; outside the data, those of its
// level that are nearest. None away from leaf cells of its level, where no tent asks for it.
void Candidates::Complete(int l, const Int3& cell)
{
  Level& own = this->Levels[l];
  std::int64_t nearest = 4;
  const Box around{ cell - std::int64_t(1), cell + std::int64_t(2) };
  const auto distance = [&](const Int3& c)
  {
    const Int3 off = c - cell;
    return off.x * off.x + off.y * off.y + off.z * off.z;
  };
  forEachPoint(around,
    [&](const Int3& c) { nearest = own.isLeaf(c) ? std::min(nearest, distance(c)) : nearest; });
  if (nearest == 4)
  {
    return;
  }
  const glm::dvec3 middle = center(cell, own.width);
  double sum = 0.0;
  double values = 0.0;
  int count = 0;
  const auto add = [&](const Level& level, const Int3& c)
  {
    const std::size_t at = level.at(c);
    values += level.values[at];
    sum += level.values[at] + glm::dot(level.gradients[at], middle - center(c, level.width));
    ++count;
  };
  for (const Level& level : this->Levels)
  {
    Box holding; // in half finest cells, so that the centre is whole
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t x = (2 * cell[axis] + 1) * own.width;
      const std::int64_t w = 2 * level.width;
      holding.hi[axis] = floorDivide(x, w) + 1;
      holding.lo[axis] = -floorDivide(-x, w) - 1; // two cells if it lies on a face
    }
    forEachPoint(holding,
      [&](const Int3& c)
      {
        if (level.isLeaf(c))
        {
          add(level, c);
        }
      });
  }
  const bool outside = count == 0;
  if (outside)
  {
    forEachPoint(around,
      [&](const Int3& c)
      {
        if (own.isLeaf(c) && distance(c) == nearest)
        {
          add(own, c);
        }
      });
  }
  // never out of the data's range, for which transfer functions are made
  const double completed = glm::clamp(sum / count, this->Min, this->Max);
  own.completedBeyond[own.at(cell)] = completed;
  own.completed[own.at(cell)] = outside ? values / count : completed;
}

double Candidates::corrected(const glm::dvec3& p) const
{
  double values = 0.0;
  double weights = 0.0;
  glm::dvec3 centers(0.0);
  glm::dvec3 gradients(0.0);
  for (const Level& level : this->Levels)
  {
    const glm::dvec3 q = p / static_cast<double>(level.width) - 0.5;
    const Int3 base(glm::floor(q));
    const glm::dvec3 f = q - glm::dvec3(base);
    for (int corner = 0; corner < 8; ++corner)
    {
      const Int3 cell = base + Int3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      if (level.isLeaf(cell))
      {
        const double weight = (corner & 1 ? f.x : 1.0 - f.x) * (corner & 2 ? f.y : 1.0 - f.y) *
          (corner & 4 ? f.z : 1.0 - f.z);
        const std::size_t at = level.at(cell);
        values += weight * level.values[at];
        gradients += weight * level.gradients[at];
        centers += weight * center(cell, level.width);
        weights += weight;
      }
    }
  }
  return (values + glm::dot(gradients, p - centers / weights)) / weights;
}

double Candidates::InterpolateLevels(const glm::dvec3& p, std::vector<double> Level::*values) const
{
  double sum = 0.0;
  double weights = 0.0;
  for (const Level& level : this->Levels)
  {
    const glm::dvec3 q = p / static_cast<double>(level.width) - 0.5;
    const Int3 base(glm::floor(q));
    const glm::dvec3 f = q - glm::dvec3(base);
    double interpolated = 0.0;
    double leaves = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Int3 cell = base + Int3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      const double weight = (corner & 1 ? f.x : 1.0 - f.x) * (corner & 2 ? f.y : 1.0 - f.y) *
        (corner & 4 ? f.z : 1.0 - f.z);
      if (level.bounds.contains(cell) && weight > 0.0)
      {
        const std::size_t at = level.at(cell);
        interpolated += weight * (level.*values)[at];
        leaves += std::isnan(level.values[at]) ? 0.0 : weight;
      }
    }
    if (leaves > 0.0)
    {
      sum += leaves * interpolated;
      weights += leaves;
    }
  }
  return sum / weights;
}
}
}
