// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bricks.h"

#include <cmath>
#include <limits>

namespace exabricks
{
namespace
{
struct Plane
{
  int axis = -1;
  std::int64_t position = 0;
};

class Builder
{
public:
  Builder(const LeafBoxes& leaves, const std::vector<std::int64_t>& cellWidth, int maximumCells,
    const Progress& progress)
    : Leaves(leaves)
    , CellWidth(cellWidth)
    , MaximumCells(std::clamp(maximumCells, 1, MaximumBrickCells))
    , Report(progress)
    , Area(cellWidth.size())
    , Straddling(cellWidth.size())
  {
  }

  std::vector<Brick> build()
  {
    std::vector<int> all(this->Leaves.boxes.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      all[i] = static_cast<int>(i);
    }
    this->BuildNode(this->Leaves.bounds, all);
    if (this->Aborted)
    {
      this->Bricks.clear();
    }
    return std::move(this->Bricks);
  }

private:
  void BuildNode(const Box& box, const std::vector<int>& leaves)
  {
    if (leaves.empty() || this->Aborted)
    {
      return;
    }
    LatticeVolume volume;
    const int level = this->Leaves.boxes[leaves.front()].level;
    bool oneLevel = true;
    for (const int leaf : leaves)
    {
      oneLevel = oneLevel && this->Leaves.boxes[leaf].level == level;
      volume += intersection(this->Leaves.boxes[leaf].box, box).volume();
    }
    if (oneLevel && volume == box.volume())
    {
      this->AddBricks(box, level);
      return;
    }

    const Plane plane = this->ChoosePlane(box, leaves);
    const auto parts = split(box, plane.axis, plane.position);
    std::vector<int> lower, upper;
    for (const int leaf : leaves)
    {
      const Box& part = this->Leaves.boxes[leaf].box;
      if (part.lo[plane.axis] < plane.position)
      {
        lower.push_back(leaf);
      }
      if (part.hi[plane.axis] > plane.position)
      {
        upper.push_back(leaf);
      }
    }
    this->BuildNode(parts.first, lower);
    this->BuildNode(parts.second, upper);
  }

  // A box of one level is cut into equal bricks, along each axis as many as the limit asks for.
  void AddBricks(const Box& box, int level)
  {
    const std::int64_t width = this->CellWidth[level];
    const Int3 cells = box.size() / width;
    const Int3 count =
      (cells + std::int64_t(this->MaximumCells - 1)) / std::int64_t(this->MaximumCells);
    Int3 i;
    for (i.z = 0; i.z < count.z; ++i.z)
    {
      for (i.y = 0; i.y < count.y; ++i.y)
      {
        for (i.x = 0; i.x < count.x; ++i.x)
        {
          const Int3 first = cells * i / count;
          const Int3 last = cells * (i + std::int64_t(1)) / count;
          Brick brick;
          brick.lo = box.lo + first * width;
          brick.cells = glm::ivec3(last - first);
          brick.level = level;
          this->Cells += brick.numberOfCells();
          this->Bricks.push_back(brick);
        }
      }
    }
    if (this->Report && this->Bricks.size() >= this->NextReport)
    {
      this->NextReport = this->Bricks.size() + 1024;
      this->Aborted = !this->Report(static_cast<double>(this->Cells) / this->Leaves.cells);
    }
  }

  // A face of a leaf box, across one axis: there leaf cells of a level begin or end.
  struct Face
  {
    std::int64_t position;
    int level;
    bool begins;
    double area; // as a fraction of the node's cross section
  };

  // Finds a plane that cuts no cell, where levels change or data end: on the longest axis that has
  // one, the plane where most changes, and the one nearer to the middle when in doubt. A node that
  // holds a coarse cell and anything else always has such a plane, since widths divide one another.
  Plane ChoosePlane(const Box& box, const std::vector<int>& leaves)
  {
    const Int3 size = box.size();
    int axes[3] = { 0, 1, 2 };
    std::sort(axes, axes + 3, [&](int a, int b) { return size[a] > size[b]; });
    Plane fallback;
    for (const int axis : axes)
    {
      this->CollectFaces(box, leaves, axis);
      const Plane plane = this->ChooseOnAxis(box, axis, fallback);
      if (plane.axis >= 0)
      {
        return plane;
      }
    }
    return fallback;
  }

  void CollectFaces(const Box& box, const std::vector<int>& leaves, int axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const Int3 size = box.size();
    const double section = static_cast<double>(size[u]) * static_cast<double>(size[v]);
    this->Faces.clear();
    for (const int leaf : leaves)
    {
      const Box part = intersection(this->Leaves.boxes[leaf].box, box);
      const Int3 extent = part.size();
      const double area = static_cast<double>(extent[u]) * static_cast<double>(extent[v]) / section;
      const int level = this->Leaves.boxes[leaf].level;
      this->Faces.push_back({ part.lo[axis], level, true, area });
      this->Faces.push_back({ part.hi[axis], level, false, area });
    }
    std::sort(this->Faces.begin(), this->Faces.end(),
      [](const Face& a, const Face& b) { return a.position < b.position; });
  }

  Plane ChooseOnAxis(const Box& box, int axis, Plane& fallback)
  {
    std::fill(this->Straddling.begin(), this->Straddling.end(), 0);
    const double length = static_cast<double>(box.size()[axis]);
    Plane best;
    double bestScore = -1.0;
    for (std::size_t i = 0; i < this->Faces.size();)
    {
      const std::int64_t position = this->Faces[i].position;
      std::fill(this->Area.begin(), this->Area.end(), 0.0);
      const std::size_t first = i;
      for (; i < this->Faces.size() && this->Faces[i].position == position; ++i)
      {
        const Face& face = this->Faces[i];
        this->Area[face.level] += face.begins ? face.area : -face.area;
        if (!face.begins)
        {
          --this->Straddling[face.level];
        }
      }
      if (position > box.lo[axis] && position < box.hi[axis] && this->CutsNoCell(position))
      {
        double change = 0.0;
        for (const double area : this->Area)
        {
          change += std::abs(area);
        }
        const double toMiddle =
          std::abs(2.0 * static_cast<double>(position - box.lo[axis]) / length - 1.0);
        if (change > 1e-9 && change - 0.25 * toMiddle > bestScore)
        {
          bestScore = change - 0.25 * toMiddle;
          best = { axis, position };
        }
        if (fallback.axis < 0)
        {
          fallback = { axis, position };
        }
      }
      for (std::size_t k = first; k < i; ++k)
      {
        if (this->Faces[k].begins)
        {
          ++this->Straddling[this->Faces[k].level];
        }
      }
    }
    return best;
  }

  // As widths divide one another, a plane that does not cut the coarsest cells there cuts none.
  bool CutsNoCell(std::int64_t position) const
  {
    for (std::size_t level = 0; level < this->Straddling.size(); ++level)
    {
      if (this->Straddling[level] > 0)
      {
        return position % this->CellWidth[level] == 0;
      }
    }
    return true;
  }

  const LeafBoxes& Leaves;
  const std::vector<std::int64_t>& CellWidth;
  const int MaximumCells;
  const Progress& Report;
  std::vector<Brick> Bricks;
  std::uint64_t Cells = 0; // of the bricks so far
  std::size_t NextReport = 1024;
  bool Aborted = false;
  // Scratch of ChoosePlane.
  std::vector<Face> Faces;
  std::vector<double> Area;
  std::vector<int> Straddling; // [level], leaf boxes on both sides of the plane
};
}

std::vector<Brick> buildBricks(const LeafBoxes& leaves, const std::vector<std::int64_t>& cellWidth,
  int maximumCells, const Progress& progress)
{
  return Builder(leaves, cellWidth, maximumCells, progress).build();
}
}
