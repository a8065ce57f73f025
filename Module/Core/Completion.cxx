// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Completion.h"

#include "Core/FirstException.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace exabricks
{
namespace
{
// A leaf cell. All positions in this file are in half cells from the lower corner of the bounds, as
// in the tree.
struct Cell
{
  int brick = -1;     // -1: there is no cell
  glm::ivec3 at{ 0 }; // in the brick

  bool operator==(const Cell& other) const
  {
    return this->brick == other.brick && this->at == other.at;
  }
};

// Solves for a slope. Where the neighbours do not tell it along all axes, it is 0 along the rest.
glm::dvec3 solve(glm::dmat3 matrix, const glm::dvec3& right)
{
  const double mean = (matrix[0][0] + matrix[1][1] + matrix[2][2]) / 3.0;
  if (glm::determinant(matrix) < 1e-3 * mean * mean * mean || !(mean > 0.0))
  {
    matrix += glm::dmat3(1e-6 * mean + 1e-300);
  }
  return glm::inverse(matrix) * right;
}

class Completer
{
public:
  Completer(
    const Structure& structure, const Values& values, const std::vector<glm::ivec3>& origins)
    : Grid(structure)
    , Tree(structure.tree)
    , Bricks(structure.bricks)
    , Given(values)
    , Origins(origins)
  {
  }

  // Writes the values of a brick and its layer. Returns whether any of them is absent.
  bool complete(int b, float* to)
  {
    const glm::ivec3 n = this->Bricks[b].cells;
    const float* from = this->Given.ofBrick(b);
    bool absent = false;
    glm::ivec3 c;
    for (c.z = -1; c.z <= n.z; ++c.z)
    {
      for (c.y = -1; c.y <= n.y; ++c.y)
      {
        const bool inside = c.z >= 0 && c.z < n.z && c.y >= 0 && c.y < n.y;
        for (c.x = -1; c.x <= n.x; ++c.x)
        {
          const bool own = inside && c.x >= 0 && c.x < n.x;
          *to = own ? *from++ : this->ValueBeside(b, this->Center({ b, c }));
          absent = absent || *to < 0.0f;
          ++to;
        }
      }
    }
    return absent;
  }

private:
  int Width(int b) const { return static_cast<int>(this->Grid.width(this->Bricks[b])); }

  glm::ivec3 Center(const Cell& cell) const
  {
    return this->Origins[cell.brick] + (2 * cell.at + 1) * this->Width(cell.brick);
  }

  float Value(const Cell& cell) const
  {
    const Brick& brick = this->Bricks[cell.brick];
    return this->Given.ofBrick(cell.brick)[cell.at.x +
      brick.cells.x * (cell.at.y + static_cast<std::size_t>(brick.cells.y) * cell.at.z)];
  }

  // Finds the brick's cell that holds the point. On a face between two cells, `above` tells for
  // each axis whether the upper one is meant (1) or the lower one (0).
  bool CellOf(int b, const glm::ivec3& p, const glm::ivec3& above, Cell& cell) const
  {
    // Points and faces lie at whole numbers of half cells: one less is inside the cell below.
    const glm::ivec3 off = p - this->Origins[b] + above - 1;
    const int width = 2 * this->Width(b);
    const glm::ivec3 n = this->Bricks[b].cells;
    if (off.x < 0 || off.y < 0 || off.z < 0)
    {
      return false;
    }
    const glm::ivec3 at = off / width;
    if (at.x >= n.x || at.y >= n.y || at.z >= n.z)
    {
      return false;
    }
    cell = { b, at };
    return true;
  }

  Cell Find(const glm::ivec3& p, const glm::ivec3& above)
  {
    Cell cell;
    if (this->Last >= 0 && this->CellOf(this->Last, p, above, cell))
    {
      return cell;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      if (p[axis] + above[axis] <= 0 || p[axis] + above[axis] > this->Tree.size[axis])
      {
        return cell;
      }
    }
    const layout::KdNode* node = this->Tree.nodes.data();
    while ((node->link & 3u) != layout::KD_LEAF)
    {
      const int axis = static_cast<int>(node->link & 3u);
      node = &this->Tree.nodes[(node->link >> 2) + (p[axis] + above[axis] > node->plane)];
    }
    const layout::Region& region = this->Tree.regions[node->link >> 2];
    for (std::uint32_t k = 0; k < region.brickCount; ++k)
    {
      const int b = static_cast<int>(this->Tree.brickLists[region.firstBrick + k]);
      if (this->CellOf(b, p, above, cell))
      {
        this->Last = b;
        return cell;
      }
    }
    return cell;
  }

  // Calls visit(neighbour, fraction) for the leaf cells with a value that touch a face of the cell,
  // with the fraction of the face that they touch.
  template <typename Visitor>
  void ForEachFaceNeighbour(const Cell& cell, const Visitor& visit)
  {
    const glm::ivec3 n = this->Bricks[cell.brick].cells;
    for (int face = 0; face < 6; ++face)
    {
      const int axis = face / 2;
      Cell beside = cell;
      beside.at[axis] += face % 2 ? 1 : -1;
      if (beside.at[axis] < 0 || beside.at[axis] >= n[axis])
      {
        const int width = this->Width(cell.brick);
        glm::ivec3 corner = this->Origins[cell.brick] + 2 * width * cell.at;
        corner[axis] += face % 2 ? 2 * width : 0;
        this->VisitSquare(corner, face, this->Bricks[cell.brick].level, 1.0, visit);
      }
      else if (this->Value(beside) >= 0.0f)
      {
        visit(beside, 1.0);
      }
    }
  }

  // The same for one square, as wide as the level's cells, on one of the cell's faces.
  template <typename Visitor>
  void VisitSquare(
    const glm::ivec3& corner, int face, int level, double fraction, const Visitor& visit)
  {
    glm::ivec3 above(1);
    above[face / 2] = face % 2;
    const Cell cell = this->Find(corner, above);
    if (cell.brick < 0)
    {
      return;
    }
    if (this->Bricks[cell.brick].level <= level)
    {
      if (this->Value(cell) >= 0.0f)
      {
        visit(cell, fraction);
      }
      return;
    }
    const std::vector<std::int64_t>& cellWidth = this->Grid.hierarchy.cellWidth;
    const int width = static_cast<int>(cellWidth[level + 1]);
    const int n = static_cast<int>(cellWidth[level]) / width;
    for (int i = 0; i < n * n; ++i)
    {
      glm::ivec3 part = corner;
      part[(face / 2 + 1) % 3] += 2 * width * (i % n);
      part[(face / 2 + 2) % 3] += 2 * width * (i / n);
      this->VisitSquare(part, face, level + 1, fraction / (n * n), visit);
    }
  }

  // The value at a point as the cell extends to it: by the plane that fits the cells across its
  // faces best, weighted with 1 / distance^2. Inside a level that means central differences.
  double Extend(const Cell& cell, const glm::ivec3& p)
  {
    if (!(cell == this->Fitted))
    {
      const double value = this->Value(cell);
      const glm::ivec3 middle = this->Center(cell);
      glm::dmat3 matrix(0.0);
      glm::dvec3 right(0.0);
      this->ForEachFaceNeighbour(cell,
        [&](const Cell& neighbour, double fraction)
        {
          const glm::dvec3 off(this->Center(neighbour) - middle);
          const double difference = this->Value(neighbour) - value;
          const double weight = fraction / glm::dot(off, off);
          matrix += glm::outerProduct(off, off) * weight;
          right += off * (weight * difference);
        });
      this->Fitted = cell;
      this->Slope = solve(matrix, right);
    }
    return this->Value(cell) + glm::dot(this->Slope, glm::dvec3(p - this->Center(cell)));
  }

  // The value of a cell outside the brick, of its level, with this centre.
  float ValueBeside(int b, const glm::ivec3& p)
  {
    const int level = this->Bricks[b].level;
    Cell holding[8];
    int count = 0;
    for (int octant = 0; octant < 8; ++octant)
    {
      const Cell cell = this->Find(p, glm::ivec3(octant & 1, octant >> 1 & 1, octant >> 2 & 1));
      if (cell.brick >= 0 && std::find(holding, holding + count, cell) == holding + count)
      {
        if (this->Bricks[cell.brick].level == level)
        {
          return this->Value(cell);
        }
        holding[count++] = cell;
        if (this->Bricks[cell.brick].level < level) // the centre is inside it, in no other cell
        {
          break;
        }
      }
    }
    if (count == 0)
    {
      const glm::ivec3 inside =
        glm::clamp(p, glm::ivec3(this->Width(b)), this->Tree.size - this->Width(b));
      return inside == p ? this->ValueInHole(b, p) : this->ValueBeside(b, inside);
    }
    double sum = 0.0;
    int there = 0;
    for (int i = 0; i < count; ++i)
    {
      if (this->Value(holding[i]) >= 0.0f)
      {
        sum += this->Extend(holding[i], p);
        ++there;
      }
    }
    if (there == 0)
    {
      return layout::ABSENT;
    }
    return static_cast<float>(glm::clamp(sum / there, 0.0, 1.0));
  }

  // The mean of the nearest of the 26 cells of the level around a centre that no leaf cell holds.
  float ValueInHole(int b, const glm::ivec3& p)
  {
    double sum = 0.0;
    int count = 0;
    int nearest = 4;
    for (int i = 0; i < 27; ++i)
    {
      const glm::ivec3 off = glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
      const int distance = off.x * off.x + off.y * off.y + off.z * off.z;
      if (distance > nearest)
      {
        continue;
      }
      const Cell cell = this->Find(p + 2 * this->Width(b) * off, glm::ivec3(1));
      if (cell.brick >= 0 && this->Bricks[cell.brick].level == this->Bricks[b].level &&
        this->Value(cell) >= 0.0f)
      {
        sum = distance < nearest ? 0.0 : sum;
        count = distance < nearest ? 0 : count;
        nearest = distance;
        sum += this->Value(cell);
        ++count;
      }
    }
    return count > 0 ? static_cast<float>(sum / count) : layout::ABSENT;
  }

  const Structure& Grid;
  const RegionTree& Tree;
  const std::vector<Brick>& Bricks;
  const Values& Given;
  const std::vector<glm::ivec3>& Origins;
  int Last = -1; // the brick of the last cell that was found, which often has the next one too
  Cell Fitted;   // the cell that Extend() has fitted a plane to last, and the plane's slope
  glm::dvec3 Slope{ 0.0 };
};
}

std::shared_ptr<const Values> complete(const Structure& structure, const Values& values)
{
  const std::vector<Brick>& bricks = structure.bricks;
  auto completed = std::make_shared<Values>();
  completed->layer = 1;
  completed->range = values.range;
  completed->absentCells = values.absentCells;
  completed->firstValue = findFirstValues(bricks, completed->layer);
  completed->normalized.resize(completed->firstValue.back());
  completed->brickHasAbsentCells.resize(bricks.size());
  completed->brickHasUndefinedCells = values.brickHasUndefinedCells;
  std::vector<glm::ivec3> origins;
  origins.reserve(bricks.size());
  for (const Brick& brick : bricks)
  {
    origins.emplace_back((brick.lo - structure.tree.bounds.lo) * std::int64_t(2));
  }
  FirstException failure;
#pragma omp parallel if (completed->normalized.size() > ParallelCells)
  {
    Completer completer(structure, values, origins);
#pragma omp for schedule(dynamic, 2)
    for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(bricks.size()); ++b)
    {
      failure.guard(
        [&]
        {
          completed->brickHasAbsentCells[b] = completer.complete(
            static_cast<int>(b), completed->normalized.data() + completed->firstValue[b]);
        });
    }
  }
  failure.rethrow();
  completed->ranges = findValueRanges(structure, *completed);
  return completed;
}
}
