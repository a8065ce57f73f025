// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Oracle.h"

#include "Core/BoxIndex.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

template <typename Visitor>
void forEachPoint(const Box& box, const Visitor& visit)
{
  Int3 p;
  for (p.z = box.lo.z; p.z < box.hi.z; ++p.z)
  {
    for (p.y = box.lo.y; p.y < box.hi.y; ++p.y)
    {
      for (p.x = box.lo.x; p.x < box.hi.x; ++p.x)
      {
        visit(p);
      }
    }
  }
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

// The part of the ray begin + t * (end - begin), 0 <= t <= 1, that lies in `box`.
struct Span
{
  double begin = 0.0;
  double end = 1.0;
};

Span clip(const glm::dvec3& begin, const glm::dvec3& direction, const Box& box)
{
  Span span;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lo = static_cast<double>(box.lo[axis]) - begin[axis];
    const double hi = static_cast<double>(box.hi[axis]) - begin[axis];
    if (direction[axis] == 0.0)
    {
      if (lo > 0.0 || hi <= 0.0)
      {
        return { 1.0, 0.0 };
      }
      continue;
    }
    const double a = lo / direction[axis];
    const double b = hi / direction[axis];
    span.begin = std::max(span.begin, std::min(a, b));
    span.end = std::min(span.end, std::max(a, b));
  }
  return span;
}
}

Oracle::Oracle(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source)
{
  this->Load(hierarchy, leaves, source);
  for (const Leaf& leaf : this->Leaves)
  {
    for (const double value : leaf.values)
    {
      if (!std::isnan(value))
      {
        this->ValueRange.add(value);
      }
    }
  }
  this->Normalize();
}

Oracle::Oracle(
  const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source, const Range& range)
  : ValueRange(range)
{
  this->Load(hierarchy, leaves, source);
  this->Normalize();
}

void Oracle::Load(const Hierarchy& hierarchy, const LeafBoxes& leaves, const CellSource& source)
{
  std::vector<Box> boxes;
  for (const LeafBox& box : leaves.boxes)
  {
    boxes.push_back(box.box);
  }
  const BoxIndex index(std::move(boxes));

  constexpr std::size_t groupSize = 16;
  for (const LeafBox& box : leaves.boxes)
  {
    Leaf leaf;
    leaf.level = box.level;
    leaf.box = box.box;
    leaf.cells = outwardToCells(box.box, hierarchy.cellWidth[box.level]);
    std::int64_t finest = hierarchy.cellWidth[box.level];
    const Box around{ box.box.lo - finest, box.box.hi + finest };
    index.forEachIntersecting(around,
      [&](int i)
      {
        const std::int64_t width = hierarchy.cellWidth[leaves.boxes[i].level];
        const Box reach{ box.box.lo - (width + 1) / 2, box.box.hi + (width + 1) / 2 };
        if (width < finest && reach.intersects(index.box(i)))
        {
          finest = width;
        }
      });
    leaf.finestWidth = static_cast<double>(finest);
    if (this->Leaves.size() % groupSize == 0)
    {
      this->Groups.push_back({ {}, this->Leaves.size(), this->Leaves.size() });
    }
    this->Groups.back().box = unite(this->Groups.back().box, leaf.box);
    ++this->Groups.back().end;
    this->Leaves.push_back(std::move(leaf));
  }
#pragma omp parallel for schedule(dynamic, 16) if (this->Leaves.size() > 64)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(this->Leaves.size()); ++i)
  {
    Leaf& leaf = this->Leaves[i];
    leaf.values = readLeaf(hierarchy, source, leaf.level, leaf.cells);
  }
  this->BuildLevels(hierarchy);
}

void Oracle::Normalize()
{
  for (Leaf& leaf : this->Leaves)
  {
    for (double& value : leaf.values)
    {
      value = this->ValueRange.normalize(value); // NaN stays
    }
  }
}

void Oracle::BuildLevels(const Hierarchy& hierarchy)
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
    } while (Box{ Int3(0), level.buckets }.volume() > limit);

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

const double* Oracle::Find(int l, const Int3& cell) const
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

// Evaluates the basis along a way: it keeps, per level, the eight cells around the last point.
class Oracle::Cursor
{
public:
  explicit Cursor(const Oracle& oracle)
    : Source(oracle)
    , Around(oracle.Levels.size())
  {
  }

  /// Weighted mean of the tents that reach p; NaN: none does.
  double basis(const glm::dvec3& p)
  {
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t l = 0; l < this->Around.size(); ++l)
    {
      const glm::dvec3 q = p / static_cast<double>(this->Source.Levels[l].width) - 0.5;
      const glm::dvec3 base = glm::floor(q);
      Eight& eight = this->Around[l];
      if (base != eight.base)
      {
        this->Load(static_cast<int>(l), base, eight);
      }
      if (!eight.any)
      {
        continue;
      }
      const glm::dvec3 f = q - base;
      for (int corner = 0; corner < 8; ++corner)
      {
        if (!std::isnan(eight.values[corner]))
        {
          const double weight = (corner & 1 ? f.x : 1.0 - f.x) * (corner & 2 ? f.y : 1.0 - f.y) *
            (corner & 4 ? f.z : 1.0 - f.z);
          sum += weight * eight.values[corner];
          weights += weight;
        }
      }
    }
    return sum / weights;
  }

private:
  struct Eight
  {
    glm::dvec3 base{ none };
    std::array<double, 8> values{};
    bool any = false;
  };

  void Load(int level, const glm::dvec3& base, Eight& eight)
  {
    eight.base = base;
    eight.any = false;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Int3 step(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      const double* value = this->Source.Find(level, Int3(base) + step);
      eight.values[corner] = value ? *value : none;
      eight.any = eight.any || !std::isnan(eight.values[corner]);
    }
  }

  const Oracle& Source;
  std::vector<Eight> Around; // [level]
};

std::optional<double> Oracle::sample(const glm::dvec3& logical, Reconstruction reconstruction) const
{
  for (std::size_t l = 0; l < this->Levels.size(); ++l)
  {
    const Int3 cell(glm::floor(logical / static_cast<double>(this->Levels[l].width)));
    const double* value = this->Find(static_cast<int>(l), cell);
    if (value && std::isnan(*value))
    {
      return {};
    }
    if (value)
    {
      return reconstruction == Reconstruction::Nearest ? *value : Cursor(*this).basis(logical);
    }
  }
  return {};
}

Image Oracle::render(
  const View& view, const TransferFunction& transfer, const Settings& settings) const
{
  Image image;
  image.width = view.width;
  image.height = view.height;
  image.pixels.assign(static_cast<std::size_t>(view.width) * view.height, glm::dvec4(0.0));
#pragma omp parallel for schedule(dynamic, 1)
  for (int y = 0; y < view.height; ++y)
  {
    for (int x = 0; x < view.width; ++x)
    {
      const std::size_t pixel = x + static_cast<std::size_t>(view.width) * y;
      const glm::dvec2 ndc(2.0 * (x + 0.5) / view.width - 1.0, 2.0 * (y + 0.5) / view.height - 1.0);
      const double depth = view.depth.empty() ? 1.0 : view.depth[pixel];
      const auto unproject = [&](const glm::dmat4& matrix, double z)
      {
        const glm::dvec4 p = matrix * glm::dvec4(ndc, z, 1.0);
        return glm::dvec3(p) / p.w;
      };
      const double length = glm::distance(
        unproject(view.ndcToWorld, -1.0), unproject(view.ndcToWorld, 2.0 * depth - 1.0));
      image.pixels[pixel] = this->March(unproject(view.ndcToLogical, -1.0),
        unproject(view.ndcToLogical, 2.0 * depth - 1.0), length, transfer, settings);
    }
  }
  return image;
}

glm::dvec4 Oracle::March(const glm::dvec3& begin, const glm::dvec3& end, double worldLength,
  const TransferFunction& transfer, const Settings& settings) const
{
  const glm::dvec3 direction = end - begin;
  const double logicalLength = glm::length(direction);
  std::vector<std::pair<Span, const Leaf*>> hits;
  for (const Group& group : this->Groups)
  {
    const Span around = clip(begin, direction, group.box);
    for (std::size_t i = group.begin; i < group.end && around.begin < around.end; ++i)
    {
      const Span span = clip(begin, direction, this->Leaves[i].box);
      if (span.begin < span.end)
      {
        hits.emplace_back(span, &this->Leaves[i]);
      }
    }
  }
  std::sort(hits.begin(), hits.end(),
    [](const auto& a, const auto& b) { return a.first.begin < b.first.begin; });

  glm::dvec4 color(0.0);
  const auto add = [&](double value, double length)
  {
    const glm::dvec4 c = transfer.evaluate(value);
    const double alpha = 1.0 - std::pow(1.0 - c.a, length / settings.opacityUnitDistance);
    color += (1.0 - color.a) * alpha * glm::dvec4(c.r, c.g, c.b, 1.0);
  };

  Cursor cursor(*this);
  std::vector<double> faces; // of cells, along the ray
  for (const auto& hit : hits)
  {
    const Span& span = hit.first;
    const Leaf& leaf = *hit.second;
    const double width = static_cast<double>(this->Levels[leaf.level].width);
    faces.assign({ span.begin, span.end });
    for (int axis = 0; axis < 3; ++axis)
    {
      for (std::int64_t i = leaf.cells.lo[axis] + 1; i < leaf.cells.hi[axis]; ++i)
      {
        const double t = (static_cast<double>(i) * width - begin[axis]) / direction[axis];
        if (t > span.begin && t < span.end)
        {
          faces.push_back(t);
        }
      }
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t f = 0; f + 1 < faces.size(); ++f)
    {
      const double length = faces[f + 1] - faces[f];
      const glm::dvec3 middle = begin + 0.5 * (faces[f] + faces[f + 1]) * direction;
      const Int3 cell = glm::clamp(
        Int3(glm::floor(middle / width)), leaf.cells.lo, leaf.cells.hi - std::int64_t(1));
      const double value = leaf.values[offsetIn(leaf.cells, cell)];
      if (std::isnan(value) || !(length > 0.0))
      {
        continue;
      }
      if (settings.reconstruction == Reconstruction::Nearest)
      {
        add(value, length * worldLength);
        continue;
      }
      const int n = std::max(1,
        static_cast<int>(std::ceil(length * logicalLength / (settings.step * leaf.finestWidth))));
      for (int i = 0; i < n; ++i)
      {
        const double t = faces[f] + length * (i + 0.5) / n;
        add(cursor.basis(begin + t * direction), length / n * worldLength);
      }
    }
  }
  return color;
}

double psnr(const Image& a, const Image& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
  {
    const glm::dvec4 difference = a.pixels[i] - b.pixels[i];
    sum += glm::dot(difference, difference);
  }
  return -10.0 * std::log10(sum / (4.0 * static_cast<double>(a.pixels.size())));
}
}
}
