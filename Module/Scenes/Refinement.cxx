// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/Refinement.h"

#include "Core/FirstException.h"
#include "Scenes/MergeCells.h"
#include "Scenes/Noise.h"

#include <glm/exponential.hpp>
#include <limits>

namespace exabricks
{
namespace
{
// Longest side of a block, of level 0 and of what is merged of finer levels: long enough for few
// blocks, short enough for threads to divide the work between them.
constexpr std::int64_t TileCells = 32;

Hierarchy coarseGrid(const Int3& cells, std::int64_t tile, int levels)
{
  Hierarchy hierarchy;
  for (int level = levels; level-- > 0;)
  {
    hierarchy.cellWidth.push_back(std::int64_t(1) << level);
  }
  Int3 lo;
  for (lo.z = 0; lo.z < cells.z; lo.z += tile)
  {
    for (lo.y = 0; lo.y < cells.y; lo.y += tile)
    {
      for (lo.x = 0; lo.x < cells.x; lo.x += tile)
      {
        hierarchy.blocks.push_back({ 0, { lo, glm::min(lo + tile, cells) } });
      }
    }
  }
  return hierarchy;
}

// Makes blocks of the next level of the cells of a block that are refined.
std::vector<Block> refineBlock(const Recipe& recipe, const Block& block, double cellSize)
{
  const std::int64_t blockingFactor = recipe.blockingFactor;
  const glm::dvec3 shift(19.1 * recipe.seed + 7.7 * block.level);
  const Box groups = outwardToCells(block.cells, blockingFactor);
  std::vector<unsigned char> marks;
  marks.reserve(static_cast<std::size_t>(groups.volume()));
  bool any = false;
  Int3 p;
  for (p.z = groups.lo.z; p.z < groups.hi.z; ++p.z)
  {
    for (p.y = groups.lo.y; p.y < groups.hi.y; ++p.y)
    {
      for (p.x = groups.lo.x; p.x < groups.hi.x; ++p.x)
      {
        const glm::dvec3 center = glm::dvec3(p) + 0.5;
        const double size = cellSize * static_cast<double>(blockingFactor);
        const double criterion = recipe.criterion(center * size, block.level);
        const bool refined = criterion > 0.0 &&
          criterion > smoothNoise(center / recipe.noiseLength + shift,
                        recipe.seed + 1000u * static_cast<std::uint32_t>(block.level));
        any = any || refined;
        marks.push_back(refined);
      }
    }
  }
  std::vector<Block> children;
  if (any)
  {
    for (const Box& merged : mergeCells(groups, marks, TileCells / blockingFactor))
    {
      // The domain's sides need not consist of whole groups.
      const Box cells = intersection(scaled(merged, blockingFactor), block.cells);
      children.push_back({ block.level + 1, scaled(cells, 2) });
    }
  }
  return children;
}

Hierarchy refineOnGrid(const Recipe& recipe, double coarseCellsPerUnit)
{
  const Int3 cells = glm::max(Int3(glm::round(recipe.size * coarseCellsPerUnit)), Int3(1));
  Hierarchy hierarchy =
    coarseGrid(cells, TileCells / recipe.blockingFactor * recipe.blockingFactor, recipe.levels);
  const double finest = 1.0 / (coarseCellsPerUnit * static_cast<double>(hierarchy.cellWidth[0]));
  hierarchy.spacing = glm::dvec3(finest);
  std::size_t begin = 0;
  for (int level = 0; level + 1 < recipe.levels; ++level)
  {
    const double cellSize = finest * static_cast<double>(hierarchy.cellWidth[level]);
    const std::int64_t count = static_cast<std::int64_t>(hierarchy.blocks.size() - begin);
    std::vector<std::vector<Block>> children(static_cast<std::size_t>(count));
    FirstException failure;
#pragma omp parallel for schedule(dynamic, 16)
    for (std::int64_t b = 0; b < count; ++b)
    {
      failure.guard(
        [&] { children[b] = refineBlock(recipe, hierarchy.blocks[begin + b], cellSize); });
    }
    failure.rethrow();
    begin = hierarchy.blocks.size();
    for (const std::vector<Block>& some : children)
    {
      hierarchy.blocks.insert(hierarchy.blocks.end(), some.begin(), some.end());
    }
  }
  return hierarchy;
}

// The grid of coarse blocks that comes nearest to `count` blocks with about the scene's shape.
Int3 chooseGrid(const glm::dvec3& size, double count)
{
  const glm::dvec3 ideal = size * std::cbrt(count / (size.x * size.y * size.z));
  Int3 best(1);
  double least = std::numeric_limits<double>::infinity();
  const Int3 lo = glm::max(Int3(glm::floor(ideal * 0.8)), Int3(1));
  const Int3 hi = glm::max(Int3(glm::ceil(ideal * 1.25)), Int3(1));
  Int3 n;
  for (n.z = lo.z; n.z <= hi.z; ++n.z)
  {
    for (n.y = lo.y; n.y <= hi.y; ++n.y)
    {
      for (n.x = lo.x; n.x <= hi.x; ++n.x)
      {
        const glm::dvec3 stretch = glm::log(glm::dvec3(n) / ideal);
        const double error =
          std::abs(stretch.x + stretch.y + stretch.z) * 4.0 + glm::length(stretch);
        if (error < least)
        {
          least = error;
          best = n;
        }
      }
    }
  }
  return best;
}

double leavesPerCoarseBlock(const std::vector<double>& refined, double factor)
{
  double leaves = 1.0;
  double ofLevel = 1.0;
  for (const double fraction : refined)
  {
    leaves += 7.0 * ofLevel * factor * fraction;
    ofLevel *= 8.0 * factor * fraction;
  }
  return leaves;
}

// Adds the blocks as few boxes. `unit`: cells along each side of a block.
void addMerged(const std::vector<Int3>& blocks, int level, std::int64_t unit, Hierarchy& hierarchy)
{
  Box bounds;
  for (const Int3& b : blocks)
  {
    bounds = unite(bounds, { b, b + std::int64_t(1) });
  }
  const Int3 size = bounds.size();
  std::vector<unsigned char> marks(static_cast<std::size_t>(bounds.volume()), 0);
  for (const Int3& b : blocks)
  {
    const Int3 at = b - bounds.lo;
    marks[at.x + size.x * (at.y + size.y * at.z)] = 1;
  }
  for (const Box& box : mergeCells(bounds, marks, 4))
  {
    hierarchy.blocks.push_back({ level, scaled(box, unit) });
  }
}
}

std::uint64_t countLeafCells(const Hierarchy& hierarchy)
{
  std::uint64_t cells = 0;
  for (const Block& block : hierarchy.blocks)
  {
    const std::int64_t ratio =
      block.level > 0 ? hierarchy.cellWidth[block.level - 1] / hierarchy.cellWidth[block.level] : 1;
    const std::uint64_t own = static_cast<std::uint64_t>(block.cells.volume());
    cells += own;
    cells -= block.level > 0 ? own / static_cast<std::uint64_t>(ratio * ratio * ratio) : 0;
  }
  return cells;
}

Hierarchy refineCells(const Recipe& recipe, double leavesPerCoarseCell, std::uint64_t leafCells)
{
  const double requested = static_cast<double>(leafCells);
  const double volume = recipe.size.x * recipe.size.y * recipe.size.z;
  double cellsPerUnit = std::cbrt(requested / (leavesPerCoarseCell * volume));
  Hierarchy best;
  double least = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 6 && least > 0.08; ++attempt)
  {
    Hierarchy hierarchy = refineOnGrid(recipe, cellsPerUnit);
    const double found = static_cast<double>(countLeafCells(hierarchy));
    const double error = std::abs(found / requested - 1.0);
    if (error < least)
    {
      least = error;
      best = std::move(hierarchy);
    }
    cellsPerUnit *= std::cbrt(requested / found);
  }
  return best;
}

Hierarchy refineBlocks(const Recipe& recipe, int blockCells, const std::vector<double>& refined,
  double noise, std::uint64_t leafCells)
{
  const double cellsPerBlock = std::pow(static_cast<double>(blockCells), 3.0);
  const double requested = static_cast<double>(leafCells) / cellsPerBlock;
  const Int3 grid = chooseGrid(recipe.size, requested / leavesPerCoarseBlock(refined, 1.0));
  // A grid of few blocks misses the number: more or less is refined, alike on all levels.
  const double coarseBlocks = static_cast<double>(grid.x * grid.y * grid.z);
  double lower = 0.7;
  double upper = 1.3;
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (lower + upper);
    (leavesPerCoarseBlock(refined, middle) * coarseBlocks < requested ? lower : upper) = middle;
  }

  Hierarchy hierarchy = coarseGrid(grid * std::int64_t(blockCells), 4 * blockCells, recipe.levels);
  // The grid's shape is not quite the scene's: it is laid around all of it.
  const glm::dvec3 perBlock = recipe.size / glm::dvec3(grid);
  const double coarseBlock = std::max({ perBlock.x, perBlock.y, perBlock.z });
  hierarchy.origin = 0.5 * (recipe.size - coarseBlock * glm::dvec3(grid));
  hierarchy.spacing =
    glm::dvec3(coarseBlock / static_cast<double>(blockCells * hierarchy.cellWidth[0]));

  std::vector<Int3> blocks;
  Int3 p;
  for (p.z = 0; p.z < grid.z; ++p.z)
  {
    for (p.y = 0; p.y < grid.y; ++p.y)
    {
      for (p.x = 0; p.x < grid.x; ++p.x)
      {
        blocks.push_back(p);
      }
    }
  }
  double leaves = coarseBlocks;
  for (int level = 0; level + 1 < recipe.levels; ++level)
  {
    const double blockSize = std::ldexp(coarseBlock, -level);
    std::vector<std::pair<double, std::size_t>> order; // the first ones are refined
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      const glm::dvec3 center = glm::dvec3(blocks[b]) + 0.5;
      const double random =
        smoothNoise(center / recipe.noiseLength, recipe.seed + static_cast<std::uint32_t>(level));
      order.emplace_back(
        noise * random - recipe.criterion(hierarchy.origin + center * blockSize, level), b);
    }
    std::sort(order.begin(), order.end());
    // The last level makes up for what was rounded on the others.
    const double count = level + 2 < recipe.levels
      ? lower * refined[level] * static_cast<double>(order.size())
      : (requested - leaves) / 7.0;
    order.resize(static_cast<std::size_t>(
      std::clamp(std::round(count), 1.0, static_cast<double>(order.size()))));
    leaves += 7.0 * static_cast<double>(order.size());
    // In the order of space, for the merging.
    std::sort(
      order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    std::vector<Int3> chosen;
    std::vector<Int3> children;
    for (const auto& entry : order)
    {
      const Int3 block = blocks[entry.second];
      chosen.push_back(block);
      for (int child = 0; child < 8; ++child)
      {
        children.push_back(
          block * std::int64_t(2) + Int3(child & 1, (child >> 1) & 1, (child >> 2) & 1));
      }
    }
    addMerged(chosen, level + 1, 2 * blockCells, hierarchy);
    blocks.swap(children);
  }
  return hierarchy;
}
}
