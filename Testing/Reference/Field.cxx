// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Field.h"

#include "Core/BoxIndex.h"
#include "Reference/ForEachPoint.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace exabricks
{
namespace reference
{
namespace
{
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::size_t offsetIn(const Box& box, const Int3& p)
{
  const Int3 at = p - box.lo;
  const Int3 size = box.size();
  return static_cast<std::size_t>(at.x + size.x * (at.y + size.y * at.z));
}

// A leaf cell's value is that of the finest block, not finer than the leaf, that holds it; a real
// cell goes before a duplicate of it.
std::vector<double> readLeaf(
  const Hierarchy& hierarchy, const CellSource& source, int leafLevel, const Box& leafCells)
{
  const std::int64_t width = hierarchy.cellWidth[leafLevel];
  const std::size_t n = static_cast<std::size_t>(leafCells.volume());
  std::vector<double> values(n, none);
  std::vector<int> rank(n, -1); // 2 * level of the block it is from, and 1 if real
  std::vector<double> part;
  std::vector<unsigned char> duplicate;
  for (std::size_t b = 0; b < hierarchy.blocks.size(); ++b)
  {
    const Block& block = hierarchy.blocks[b];
    const Box common = intersection(hierarchy.logicalBox(block), scaled(leafCells, width));
    if (block.level > leafLevel || common.empty())
    {
      continue;
    }
    const std::int64_t blockWidth = hierarchy.cellWidth[block.level];
    const Box cells = outwardToCells(common, blockWidth);
    part.resize(static_cast<std::size_t>(cells.volume()));
    duplicate.assign(part.size(), 0);
    source.read(static_cast<int>(b), cells, part.data());
    if (source.hasDuplicates(static_cast<int>(b)))
    {
      source.readDuplicates(static_cast<int>(b), cells, duplicate.data());
    }
    forEachPoint(outwardToCells(common, width),
      [&](const Int3& cell)
      {
        Int3 from;
        for (int axis = 0; axis < 3; ++axis)
        {
          from[axis] = floorDivide(cell[axis] * width, blockWidth);
        }
        const std::size_t f = offsetIn(cells, from);
        const std::size_t to = offsetIn(leafCells, cell);
        const int r = 2 * block.level + (duplicate[f] ? 0 : 1);
        if (r > rank[to])
        {
          rank[to] = r;
          values[to] = std::isfinite(part[f]) ? part[f] : none;
        }
      });
  }
  return values;
}

}

Field::Field(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source,
  const std::optional<Range>& range)
{
  this->Load(hierarchy, leaves, source);
  this->FindNeighbors(hierarchy);
  this->Normalize(range);
  this->BuildLevels(hierarchy);
}

void Field::Load(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source)
{
  for (const LeafBox& box : leaves.boxes)
  {
    Leaf leaf;
    leaf.level = box.level;
    leaf.box = box.box;
    leaf.cells = outwardToCells(box.box, hierarchy.cellWidth[box.level]);
    this->Leaves.push_back(std::move(leaf));
  }
#pragma omp parallel for schedule(dynamic, 16) if (this->Leaves.size() > 64)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(this->Leaves.size()); ++i)
  {
    Leaf& leaf = this->Leaves[i];
    leaf.values = readLeaf(hierarchy, source, leaf.level, leaf.cells);
    leaf.hasAbsent = std::any_of(
      leaf.values.begin(), leaf.values.end(), [](double value) { return std::isnan(value); });
  }
}

void Field::FindNeighbors(const Hierarchy& hierarchy)
{
  std::vector<Box> boxes;
  std::int64_t coarsest = 1;
  for (const Leaf& leaf : this->Leaves)
  {
    boxes.push_back(leaf.box);
    coarsest = std::max(coarsest, hierarchy.cellWidth[leaf.level]);
  }
  const BoxIndex index(std::move(boxes));
  for (Leaf& leaf : this->Leaves)
  {
    leaf.levels.push_back(leaf.level);
    index.forEachIntersecting({ leaf.box.lo - coarsest, leaf.box.hi + coarsest },
      [&](int i)
      {
        const Leaf& other = this->Leaves[i];
        // Half a cell, rounded up.
        const std::int64_t reach = (hierarchy.cellWidth[other.level] + 1) / 2;
        const Box support{ other.box.lo - reach, other.box.hi + reach };
        if (other.level != leaf.level && support.intersects(leaf.box))
        {
          leaf.otherLevels.push_back(static_cast<std::uint32_t>(i));
          leaf.levels.push_back(other.level);
        }
      });
    std::sort(leaf.levels.begin(), leaf.levels.end());
    leaf.levels.erase(std::unique(leaf.levels.begin(), leaf.levels.end()), leaf.levels.end());
  }
}

void Field::Normalize(const std::optional<Range>& range)
{
  if (range)
  {
    this->ValueRange = *range;
  }
  for (Leaf& leaf : this->Leaves)
  {
    for (const double value : leaf.values)
    {
      if (!range && !std::isnan(value))
      {
        this->ValueRange.add(value);
      }
    }
  }
  for (Leaf& leaf : this->Leaves)
  {
    for (double& value : leaf.values)
    {
      value = this->ValueRange.normalize(value); // NaN stays
    }
  }
}

void Field::BuildLevels(const Hierarchy& hierarchy)
{
  this->Levels.resize(hierarchy.levels());
  std::vector<std::size_t> count(this->Levels.size(), 0);
  for (const Leaf& leaf : this->Leaves)
  {
    this->Levels[leaf.level].bounds = unite(this->Levels[leaf.level].bounds, leaf.cells);
    ++count[leaf.level];
  }
  for (int l = 0; l < hierarchy.levels(); ++l)
  {
    Level& level = this->Levels[l];
    level.width = hierarchy.cellWidth[l];
    if (count[l] == 0)
    {
      continue;
    }
    const std::size_t limit = 4096 + 16 * count[l];
    do
    {
      level.bucketCells *= 2;
      level.buckets = (level.bounds.size() + (level.bucketCells - 1)) / level.bucketCells;
    } while (LatticeVolume(limit) < Box{ Int3(0), level.buckets }.volume());

    // Twice over the leaf boxes: to count, then to fill.
    const Box grid{ Int3(0), level.buckets };
    level.first.assign(static_cast<std::size_t>(grid.volume()) + 1, 0);
    const auto forEachBucket = [&](const Leaf& leaf, const auto& visit)
    {
      const Box touched{ leaf.cells.lo - level.bounds.lo, leaf.cells.hi - level.bounds.lo };
      forEachPoint(outwardToCells(touched, level.bucketCells),
        [&](const Int3& bucket) { visit(offsetIn(grid, bucket)); });
    };
    for (const Leaf& leaf : this->Leaves)
    {
      if (leaf.level == l)
      {
        forEachBucket(leaf, [&](std::size_t bucket) { ++level.first[bucket + 1]; });
      }
    }
    for (std::size_t b = 1; b < level.first.size(); ++b)
    {
      level.first[b] += level.first[b - 1];
    }
    level.leaves.resize(level.first.back());
    std::vector<std::uint32_t> next = level.first;
    for (std::size_t i = 0; i < this->Leaves.size(); ++i)
    {
      if (this->Leaves[i].level == l)
      {
        forEachBucket(this->Leaves[i],
          [&](std::size_t bucket)
          { level.leaves[next[bucket]++] = static_cast<std::uint32_t>(i); });
      }
    }
  }
}

const double* Field::find(int l, const Int3& cell) const
{
  const Level& level = this->Levels[l];
  if (!level.bounds.contains(cell))
  {
    return nullptr;
  }
  const Int3 bucket = (cell - level.bounds.lo) / level.bucketCells;
  const std::size_t b = offsetIn({ Int3(0), level.buckets }, bucket);
  for (std::uint32_t i = level.first[b]; i < level.first[b + 1]; ++i)
  {
    const Leaf& leaf = this->Leaves[level.leaves[i]];
    if (leaf.cells.contains(cell))
    {
      return &leaf.values[offsetIn(leaf.cells, cell)];
    }
  }
  return nullptr;
}

Field::Corners Field::corners(int level, const Int3& base) const
{
  Corners corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double* value =
      this->find(level, base + Int3(corner & 1, corner >> 1 & 1, corner >> 2 & 1));
    if (value && !std::isnan(*value))
    {
      corners.values[corner] = *value;
      corners.there[corner] = 1.0;
      ++corners.count;
    }
  }
  return corners;
}

double Field::Basis(const glm::dvec3& logical, const std::vector<int>& levels) const
{
  double sum = 0.0;
  double weights = 0.0;
  for (const int level : levels)
  {
    const glm::dvec3 q = logical / this->width(level) - 0.5;
    const glm::dvec3 base = glm::floor(q);
    const Corners around = this->corners(level, Int3(base));
    const glm::dvec3 f = q - base;
    for (int corner = 0; corner < 8; ++corner)
    {
      const double weight = around.there[corner] * (corner & 1 ? f.x : 1.0 - f.x) *
        (corner & 2 ? f.y : 1.0 - f.y) * (corner & 4 ? f.z : 1.0 - f.z);
      sum += weight * around.values[corner];
      weights += weight;
    }
  }
  return sum / weights;
}

std::optional<double> Field::sample(const glm::dvec3& logical, Reconstruction reconstruction) const
{
  std::vector<int> all;
  for (std::size_t level = 0; level < this->Levels.size(); ++level)
  {
    all.push_back(static_cast<int>(level));
  }
  for (const int level : all)
  {
    const double* value = this->find(level, Int3(glm::floor(logical / this->width(level))));
    if (value && std::isnan(*value))
    {
      return {};
    }
    if (value)
    {
      return reconstruction == Reconstruction::Nearest ? *value : this->Basis(logical, all);
    }
  }
  return {};
}
}
}
