// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bricks.h"

#include "Core/FirstException.h"
#include "Core/SharedProgress.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace exabricks
{
namespace
{
struct Plane
{
  int axis = -1;
  std::int64_t position = 0;
};

// The bricks of one node, by one thread.
class Builder
{
public:
  Builder(const LeafBoxes& leaves, const std::vector<std::int64_t>& cellWidth, int maximumCells,
    SharedProgress& progress)
    : Leaves(leaves)
    , CellWidth(cellWidth)
    , MaximumCells(maximumCells)
    , Watched(progress)
    , Area(cellWidth.size())
    , Straddling(cellWidth.size())
  {
  }

  /// What a node is cut into, with the leaf boxes that reach into each half.
  struct Halves
  {
    std::pair<Box, Box> boxes;
    std::vector<int> lower;
    std::vector<int> upper;
  };

  /// Nothing, if the node is of one level and has become bricks.
  std::optional<Halves> divide(const Box& box, const std::vector<int>& leaves)
  {
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
      return {};
    }
    const Plane plane = this->ChoosePlane(box, leaves);
    Halves halves{ split(box, plane.axis, plane.position), {}, {} };
    for (const int leaf : leaves)
    {
      const Box& part = this->Leaves.boxes[leaf].box;
      if (part.lo[plane.axis] < plane.position)
      {
        halves.lower.push_back(leaf);
      }
      if (part.hi[plane.axis] > plane.position)
      {
        halves.upper.push_back(leaf);
      }
    }
    return halves;
  }

  void buildNode(const Box& box, const std::vector<int>& leaves)
  {
    if (leaves.empty() || this->Watched.aborted())
    {
      return;
    }
    if (const std::optional<Halves> halves = this->divide(box, leaves))
    {
      this->buildNode(halves->boxes.first, halves->lower);
      this->buildNode(halves->boxes.second, halves->upper);
    }
  }

  std::vector<Brick> take() { return std::move(this->Bricks); }

private:
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
          this->Bricks.push_back(brick);
          this->Watched.pass(static_cast<double>(brick.numberOfCells()) / this->Leaves.cells);
        }
      }
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
  SharedProgress& Watched;
  std::vector<Brick> Bricks;
  // Scratch of ChoosePlane.
  std::vector<Face> Faces;
  std::vector<double> Area;
  std::vector<int> Straddling; // [level], leaf boxes on both sides of the plane
};

// The halves of large nodes are built at once. What comes of it does not depend on the number of
// threads: bricks are in the order of the halves.
class ParallelBuilder
{
public:
  ParallelBuilder(const LeafBoxes& leaves, const std::vector<std::int64_t>& cellWidth,
    int maximumCells, const Progress& progress)
    : Leaves(leaves)
    , CellWidth(cellWidth)
    , MaximumCells(std::clamp(maximumCells, 1, MaximumBrickCells))
    , Watched(progress)
  {
  }

  std::vector<Brick> build()
  {
    std::vector<int> all(this->Leaves.boxes.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<Brick> bricks;
    // Other threads take tasks where the region ends.
#pragma omp parallel if (all.size() > WorthIt)
#pragma omp master
    this->Build(this->Leaves.bounds, all, bricks);
    this->Failure.rethrow();
    if (this->Watched.aborted())
    {
      bricks.clear();
    }
    return bricks;
  }

private:
  // Nodes of fewer leaf boxes are built by one thread.
  static constexpr std::size_t WorthIt = 1024;

  void Build(const Box& box, const std::vector<int>& leaves, std::vector<Brick>& bricks)
  {
    std::optional<Builder::Halves> halves;
    this->Failure.guard(
      [&]
      {
        Builder builder(this->Leaves, this->CellWidth, this->MaximumCells, this->Watched);
        if (leaves.size() > WorthIt && !this->Watched.aborted())
        {
          halves = builder.divide(box, leaves);
        }
        else
        {
          builder.buildNode(box, leaves);
        }
        bricks = builder.take();
      });
    if (!halves)
    {
      return;
    }
    std::vector<Brick> upper;
#pragma omp task shared(upper, halves)
    this->Build(halves->boxes.second, halves->upper, upper);
    this->Build(halves->boxes.first, halves->lower, bricks);
#pragma omp taskwait
    this->Failure.guard([&] { bricks.insert(bricks.end(), upper.begin(), upper.end()); });
  }

  const LeafBoxes& Leaves;
  const std::vector<std::int64_t>& CellWidth;
  const int MaximumCells;
  SharedProgress Watched;
  FirstException Failure;
};
}

std::vector<Brick> buildBricks(const LeafBoxes& leaves, const std::vector<std::int64_t>& cellWidth,
  int maximumCells, const Progress& progress)
{
  return ParallelBuilder(leaves, cellWidth, maximumCells, progress).build();
}
}
