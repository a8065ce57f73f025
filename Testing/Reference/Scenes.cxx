// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Scenes.h"

#include "Reference/ForEachPoint.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace exabricks
{
namespace reference
{
namespace
{
template <typename T>
void copyCells(const std::vector<T>& from, const Box& all, const Box& cells, T* to)
{
  const Int3 size = all.size();
  forEachPoint(cells,
    [&](const Int3& c)
    {
      const Int3 at = c - all.lo;
      *to++ = from[at.x + size.x * (at.y + size.y * at.z)];
    });
}

// In shares of the bounds: centre of the shell, and its wrinkled radius in a direction.
const glm::dvec3 shellCenter(0.5, 0.48, 0.53);

double shellRadius(const glm::dvec3& direction)
{
  return 0.34 + 0.03 * std::sin(7.0 * direction.x) * std::sin(5.0 * direction.y + 1.0) +
    0.02 * std::sin(9.0 * direction.z);
}

double distanceToShell(const glm::dvec3& share)
{
  const glm::dvec3 off = share - shellCenter;
  const double r = glm::length(off);
  return r < 1e-9 ? shellRadius(glm::dvec3(0.0)) : std::abs(r - shellRadius(off / r));
}

glm::dvec3 shareOf(const Box& bounds, const glm::dvec3& logical)
{
  return (logical - glm::dvec3(bounds.lo)) / glm::dvec3(bounds.size());
}

std::vector<std::int64_t> widthsOf(const std::vector<int>& ratios)
{
  std::vector<std::int64_t> widths{ 1 };
  for (auto ratio = ratios.rbegin(); ratio != ratios.rend(); ++ratio)
  {
    widths.insert(widths.begin(), widths.front() * *ratio);
  }
  return widths;
}

// Equal on every machine, unlike the standard distributions.
class Random
{
public:
  explicit Random(std::uint32_t seed)
    : Engine(seed)
  {
  }
  int pick(int least, int most)
  {
    return least + static_cast<int>(this->Engine() % static_cast<unsigned>(most - least + 1));
  }
  bool chance(int percent) { return this->pick(0, 99) < percent; }

private:
  std::mt19937 Engine;
};

// A random part of `box` that consists of whole cells of `width`.
Box pickPart(Random& random, const Box& box, std::int64_t width)
{
  Box part = outwardToCells(box, width);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int n = static_cast<int>(part.size()[axis]);
    const int first = random.pick(0, n - 1);
    part.hi[axis] = part.lo[axis] + random.pick(first + 1, n);
    part.lo[axis] += first;
  }
  return scaled(part, width);
}

void splitAtRandom(Random& random, const Box& box, int depth, std::vector<Box>& parts)
{
  const int axis = random.pick(0, 2);
  const int n = static_cast<int>(box.size()[axis]);
  if (depth == 0 || n < 2)
  {
    parts.push_back(box);
    return;
  }
  const auto halves = split(box, axis, box.lo[axis] + random.pick(1, n - 1));
  splitAtRandom(random, halves.first, depth - 1, parts);
  splitAtRandom(random, halves.second, depth - 1, parts);
}
}

void ArraySource::read(int block, const Box& cells, double* to) const
{
  copyCells(this->values[block], this->blocks[block], cells, to);
}

bool ArraySource::hasDuplicates(int block) const { return !this->duplicates[block].empty(); }

void ArraySource::readDuplicates(int block, const Box& cells, unsigned char* duplicate) const
{
  copyCells(this->duplicates[block], this->blocks[block], cells, duplicate);
}

ArraySource fillCells(const Hierarchy& hierarchy, const CellField& field)
{
  ArraySource source;
  for (const Block& block : hierarchy.blocks)
  {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(block.cells.volume()));
    forEachPoint(
      block.cells, [&](const Int3& cell) { values.push_back(field(block.level, cell)); });
    source.blocks.push_back(block.cells);
    source.values.push_back(std::move(values));
  }
  source.duplicates.resize(source.blocks.size());
  return source;
}

void markDuplicates(const Hierarchy& hierarchy, bool firstIsReal, ArraySource& cells)
{
  const int count = static_cast<int>(hierarchy.blocks.size());
  for (int b = 0; b < count; ++b)
  {
    const Block& block = hierarchy.blocks[b];
    std::vector<unsigned char> duplicate;
    forEachPoint(block.cells,
      [&](const Int3& cell)
      {
        bool better = false;
        for (int other = firstIsReal ? 0 : b + 1; other < (firstIsReal ? b : count); ++other)
        {
          better = better ||
            (hierarchy.blocks[other].level == block.level &&
              hierarchy.blocks[other].cells.contains(cell));
        }
        cells.values[b][duplicate.size()] += better ? 1000.0 : 0.0;
        duplicate.push_back(better);
      });
    if (std::count(duplicate.begin(), duplicate.end(), 1) > 0)
    {
      cells.duplicates[b] = std::move(duplicate);
    }
  }
}

double shellAndBlobs(const Box& bounds, const glm::dvec3& logical)
{
  const glm::dvec3 share = shareOf(bounds, logical);
  const auto bell = [](double distance, double width)
  { return std::exp(-distance * distance / (width * width)); };
  return 0.6 * bell(distanceToShell(share), 0.08) +
    0.9 * bell(glm::distance(share, glm::dvec3(0.4, 0.45, 0.6)), 0.12) +
    0.7 * bell(glm::distance(share, glm::dvec3(0.62, 0.55, 0.42)), 0.09);
}

TransferFunction layeredTransfer()
{
  return TransferFunction({ { 0.0, { 0.1, 0.1, 0.4, 0.0 } }, { 0.15, { 0.1, 0.2, 0.8, 0.0 } },
    { 0.3, { 0.1, 0.7, 0.9, 0.08 } }, { 0.45, { 0.2, 0.8, 0.3, 0.02 } },
    { 0.7, { 0.9, 0.8, 0.2, 0.1 } }, { 0.85, { 1.0, 0.4, 0.1, 0.5 } },
    { 1.0, { 1.0, 1.0, 0.9, 0.3 } } });
}

double noise(int level, const Int3& cell, std::uint32_t seed)
{
  std::uint64_t h = seed + 1;
  for (const std::int64_t n : { std::int64_t(level), cell.x, cell.y, cell.z })
  {
    // splitmix64
    h += static_cast<std::uint64_t>(n) + 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    h ^= h >> 31;
  }
  return static_cast<double>(h >> 11) / 9007199254740992.0;
}

Hierarchy refinedAtShell(const std::vector<int>& ratios, int coarseCells, int blockCells)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = widthsOf(ratios);
  const Box bounds{ Int3(0), Int3(coarseCells * hierarchy.cellWidth[0]) };
  const Int3 coarseBlocks(coarseCells / blockCells);
  forEachPoint({ Int3(0), coarseBlocks },
    [&](const Int3& b)
    {
      const Int3 lo = b * std::int64_t(blockCells);
      hierarchy.blocks.push_back({ 0, { lo, lo + std::int64_t(blockCells) } });
    });
  std::size_t begin = 0;
  for (int level = 1; level < hierarchy.levels(); ++level)
  {
    const std::size_t end = hierarchy.blocks.size();
    const int ratio = ratios[level - 1];
    for (std::size_t b = begin; b < end; ++b)
    {
      const Int3 corner = hierarchy.blocks[b].cells.lo * std::int64_t(ratio);
      forEachPoint({ Int3(0), Int3(ratio) },
        [&](const Int3& child)
        {
          const Int3 lo = corner + child * std::int64_t(blockCells);
          const Block block{ level, { lo, lo + std::int64_t(blockCells) } };
          const Box box = hierarchy.logicalBox(block);
          const double reach =
            0.5 * glm::length(glm::dvec3(box.size()) / glm::dvec3(bounds.size()));
          const glm::dvec3 center = 0.5 * glm::dvec3(box.lo + box.hi);
          if (distanceToShell(shareOf(bounds, center)) < reach)
          {
            hierarchy.blocks.push_back(block);
          }
        });
    }
    begin = end;
  }
  return hierarchy;
}

Box boundsOf(const Hierarchy& hierarchy)
{
  Box bounds;
  for (const Block& block : hierarchy.blocks)
  {
    bounds = unite(bounds, hierarchy.logicalBox(block));
  }
  return bounds;
}

Scene makeShellScene(const std::string& name, const Hierarchy& hierarchy)
{
  const Box bounds = boundsOf(hierarchy);
  return { name, hierarchy,
    fillCells(hierarchy,
      [&](int level, const Int3& cell)
      {
        const double width = static_cast<double>(hierarchy.cellWidth[level]);
        return shellAndBlobs(bounds, (glm::dvec3(cell) + 0.5) * width);
      }) };
}

Scene uniform() { return makeShellScene("uniform", refinedAtShell({}, 24, 12)); }

Scene twoLevels() { return makeShellScene("twoLevels", refinedAtShell({ 2 }, 16, 4)); }

Scene ratio4() { return makeShellScene("ratio4", refinedAtShell({ 4 }, 8, 4)); }

Scene mixedRatios() { return makeShellScene("mixedRatios", refinedAtShell({ 3, 2 }, 12, 6)); }

Scene anisotropic()
{
  Hierarchy hierarchy = refinedAtShell({ 2 }, 16, 4);
  hierarchy.origin = glm::dvec3(-3.0, 10.0, 0.5);
  hierarchy.spacing = glm::dvec3(1.0, 1.0, 2.0);
  return makeShellScene("anisotropic", hierarchy);
}

Scene holes()
{
  Hierarchy hierarchy = refinedAtShell({ 2, 2 }, 8, 4);
  const Box bounds = boundsOf(hierarchy);
  // A coarse block, and some fine ones that leave the coarser cells under them to be seen.
  std::vector<Block> there;
  for (std::size_t b = 1; b < hierarchy.blocks.size(); ++b)
  {
    if (b < 8 || b % 7 != 0)
    {
      there.push_back(hierarchy.blocks[b]);
    }
  }
  hierarchy.blocks.swap(there);
  return { "holes", hierarchy,
    fillCells(hierarchy,
      [&](int level, const Int3& cell)
      {
        const double width = static_cast<double>(hierarchy.cellWidth[level]);
        const glm::dvec3 center = (glm::dvec3(cell) + 0.5) * width;
        const bool hidden =
          glm::distance(shareOf(bounds, center), glm::dvec3(0.5, 0.2, 0.5)) < 0.15;
        return hidden || noise(level, cell, 0) < 0.02 ? std::numeric_limits<double>::quiet_NaN()
                                                      : shellAndBlobs(bounds, center);
      }) };
}

Scene partlyCovered()
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 4, 2, 1 };
  hierarchy.blocks = { { 0, { Int3(-4), Int3(4) } }, { 1, { Int3(-5, -3, -6), Int3(3, 4, 5) } },
    { 1, { Int3(3, -3, -1), Int3(6, 5, 5) } }, { 2, { Int3(-7, -5, -3), Int3(2, 6, 9) } } };
  return makeShellScene("partlyCovered", hierarchy);
}

std::vector<Scene> allScenes()
{
  std::vector<Scene> scenes;
  for (const auto make :
    { uniform, twoLevels, ratio4, mixedRatios, anisotropic, holes, partlyCovered })
  {
    scenes.push_back(make());
  }
  return scenes;
}

Scene repeatFarAway(const Scene& scene, std::int64_t distance)
{
  Scene pair = scene;
  pair.name = scene.name + " and its copy far away";
  for (std::size_t b = 0; b < scene.hierarchy.blocks.size(); ++b)
  {
    Block block = scene.hierarchy.blocks[b];
    const Int3 shift(distance / scene.hierarchy.cellWidth[block.level]);
    block.cells.lo += shift;
    block.cells.hi += shift;
    pair.hierarchy.blocks.push_back(block);
    pair.cells.blocks.push_back(block.cells);
    pair.cells.values.push_back(scene.cells.values[b]);
    pair.cells.duplicates.push_back(
      b < scene.cells.duplicates.size() ? scene.cells.duplicates[b] : std::vector<unsigned char>());
  }
  return pair;
}

Hierarchy randomHierarchy(std::uint32_t seed)
{
  Random random(seed);
  std::vector<int> ratios;
  int coarse = 1;
  for (int levels = random.pick(1, 4); levels > 1; --levels)
  {
    const int ratio = random.pick(2, 4);
    if (coarse * ratio <= 24)
    {
      ratios.push_back(ratio);
      coarse *= ratio;
    }
  }
  Hierarchy hierarchy;
  hierarchy.cellWidth = widthsOf(ratios);

  const int most = std::clamp(36 / coarse, 2, 9);
  Box domain;
  for (int axis = 0; axis < 3; ++axis)
  {
    domain.lo[axis] = random.pick(-most - 2, 2);
    domain.hi[axis] = domain.lo[axis] + random.pick(1, most);
  }
  std::vector<Box> parts;
  splitAtRandom(random, domain, random.pick(0, 3), parts);
  for (const Box& part : parts)
  {
    if (&part == &parts.front() || !random.chance(15))
    {
      hierarchy.blocks.push_back({ 0, part });
    }
  }
  for (int level = 1; level < hierarchy.levels(); ++level)
  {
    const std::int64_t width = hierarchy.cellWidth[level];
    const int coarser = static_cast<int>(hierarchy.blocks.size());
    for (int n = random.pick(0, 4); n > 0; --n)
    {
      const Block parent = hierarchy.blocks[random.pick(0, coarser - 1)];
      const bool aligned = random.chance(60);
      Box box = pickPart(
        random, hierarchy.logicalBox(parent), aligned ? hierarchy.cellWidth[parent.level] : width);
      if (random.chance(10)) // beyond its parent
      {
        box.hi += width * random.pick(1, 3);
      }
      std::vector<Box> pieces;
      splitAtRandom(random, outwardToCells(box, width), random.pick(0, 2), pieces);
      for (const Box& piece : pieces)
      {
        if (!random.chance(10))
        {
          hierarchy.blocks.push_back({ level, piece });
        }
      }
    }
  }
  if (random.chance(25)) // overlaps a block of its level
  {
    Block block = hierarchy.blocks[random.pick(0, static_cast<int>(hierarchy.blocks.size()) - 1)];
    const std::int64_t shift = random.pick(0, 2);
    block.cells.lo += shift;
    block.cells.hi += shift;
    hierarchy.blocks.push_back(block);
  }
  return hierarchy;
}

Scene randomScene(std::uint32_t seed)
{
  Scene scene;
  scene.name = "random " + std::to_string(seed);
  scene.hierarchy = randomHierarchy(seed);
  scene.cells = fillCells(scene.hierarchy,
    [&](int level, const Int3& cell)
    {
      const double luck = noise(level, cell, seed + 1);
      if (seed % 3 != 0 && luck < 0.04)
      {
        const double infinity = std::numeric_limits<double>::infinity();
        return luck < 0.01 ? infinity
          : luck < 0.02    ? -infinity
                           : std::numeric_limits<double>::quiet_NaN();
      }
      return 10.0 * noise(level, cell, seed) - 5.0;
    });
  if (seed % 2 == 0)
  {
    markDuplicates(scene.hierarchy, seed % 4 == 0, scene.cells);
  }
  return scene;
}
}
}
