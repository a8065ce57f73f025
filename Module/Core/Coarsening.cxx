// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Coarsening.h"

#include "Core/BoxIndex.h"
#include "Core/Completion.h"
#include "Core/FirstException.h"
#include "Core/Structure.h"

#include <glm/ext/matrix_transform.hpp>
#include <omp.h>

namespace exabricks
{
namespace
{
// The bricks are the blocks: those of the finest level in cells of the next one.
Hierarchy withoutFinestLevel(const Volume& volume)
{
  const std::vector<std::int64_t>& width = *volume.cellWidth;
  const int coarsest = static_cast<int>(width.size()) - 2;
  Hierarchy hierarchy;
  for (int level = 0; level <= coarsest; ++level)
  {
    hierarchy.cellWidth.push_back(width[level] / width[coarsest]);
  }
  hierarchy.blocks.reserve(volume.bricks->size());
  for (const Brick& brick : *volume.bricks)
  {
    const int level = std::min(brick.level, coarsest);
    hierarchy.blocks.push_back(
      { level, outwardToCells(brick.box(width[brick.level]), width[level]) });
  }
  return hierarchy;
}

// The values of bricks as means over those of others, which hold the same space in other cells.
class Averager
{
public:
  explicit Averager(const Volume& from)
    : From(from)
    , Index(BoxesOf(from))
  {
  }

  struct Scratch
  {
    std::vector<double> sum;
    std::vector<int> count;
    std::vector<int> bricks;
  };

  /// Of a brick at `box`, in cells `width` wide. All in finest cells of the volume averaged.
  void average(const Box& box, std::int64_t width, Scratch& scratch) const
  {
    const Int3 n = box.size() / width;
    const std::size_t cells = static_cast<std::size_t>(n.x * n.y * n.z);
    scratch.sum.assign(cells, 0.0);
    scratch.count.assign(cells, 0);
    // In a fixed order, as sums depend on it.
    scratch.bricks.clear();
    this->Index.forEachIntersecting(box, [&](int i) { scratch.bricks.push_back(i); });
    std::sort(scratch.bricks.begin(), scratch.bricks.end());
    for (const int i : scratch.bricks)
    {
      this->Add((*this->From.bricks)[i], box, width, n, scratch);
    }
  }

private:
  static std::vector<Box> BoxesOf(const Volume& volume)
  {
    std::vector<Box> boxes;
    boxes.reserve(volume.bricks->size());
    for (const Brick& brick : *volume.bricks)
    {
      boxes.push_back(brick.box((*volume.cellWidth)[brick.level]));
    }
    return boxes;
  }

  void Add(
    const Brick& brick, const Box& box, std::int64_t width, const Int3& n, Scratch& scratch) const
  {
    const std::int64_t own = (*this->From.cellWidth)[brick.level];
    const int layer = this->From.scalars->layer;
    const Int3 stored(brick.cells + 2 * layer);
    const float* values = this->From.scalars->values.data() + brick.firstValue;
    // Cells of one are whole ones of the other; all that lie in a cell are of one level, as leaf
    // boxes that would end in it are cut into the finest cells.
    const std::int64_t step = std::min(own, width);
    const Box common = outwardToCells(intersection(box, brick.box(own)), step);
    Int3 c;
    for (c.z = common.lo.z; c.z < common.hi.z; ++c.z)
    {
      for (c.y = common.lo.y; c.y < common.hi.y; ++c.y)
      {
        for (c.x = common.lo.x; c.x < common.hi.x; ++c.x)
        {
          const Int3 from = (c * step - brick.lo) / own + std::int64_t(layer);
          const float value = values[from.x + stored.x * (from.y + stored.y * from.z)];
          if (value >= 0.0f)
          {
            const Int3 to = (c * step - box.lo) / width;
            const std::size_t i = to.x + n.x * (to.y + n.y * to.z);
            scratch.sum[i] += value;
            ++scratch.count[i];
          }
        }
      }
    }
  }

  const Volume From;
  const BoxIndex Index;
};

Scalars average(const Volume& from, const std::vector<Brick>& bricks,
  const std::vector<std::int64_t>& cellWidth, std::int64_t factor)
{
  Scalars scalars;
  scalars.range = from.scalars->range;
  const std::uint64_t cells = bricks.back().firstValue + bricks.back().numberOfCells();
  scalars.values.resize(cells);
  scalars.brickHasAbsentCells.assign(bricks.size(), 0);
  const Averager averager(from);
  std::vector<Averager::Scratch> scratches(omp_get_max_threads());
  std::uint64_t absentCells = 0;
  // Returns how many of the brick's cells are absent.
  const auto averageBrick = [&](std::size_t b) -> std::uint64_t
  {
    const Brick& brick = bricks[b];
    const std::int64_t width = cellWidth[brick.level];
    Averager::Scratch& scratch = scratches[omp_get_thread_num()];
    averager.average(scaled(brick.box(width), factor), width * factor, scratch);
    float* to = scalars.values.data() + brick.firstValue;
    std::uint64_t absent = 0;
    for (std::size_t i = 0; i < scratch.sum.size(); ++i)
    {
      const bool there = scratch.count[i] > 0;
      *to++ = there ? static_cast<float>(scratch.sum[i] / scratch.count[i]) : layout::ABSENT;
      absent += !there;
    }
    scalars.brickHasAbsentCells[b] = absent > 0;
    return absent;
  };
  FirstException failure;
#pragma omp parallel for schedule(dynamic, 2) reduction(+ : absentCells) if (cells > ParallelCells)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(bricks.size()); ++b)
  {
    failure.guard([&] { absentCells += averageBrick(static_cast<std::size_t>(b)); });
  }
  failure.rethrow();
  scalars.absentCells = absentCells;
  return scalars;
}
}

std::unique_ptr<const CoarserVolume> coarsen(const Volume& volume)
{
  const std::size_t levels = volume.cellWidth->size();
  if (levels < 2 || volume.bricks->empty())
  {
    return nullptr;
  }
  const std::int64_t factor = (*volume.cellWidth)[levels - 2];
  Structure structure = buildStructure(withoutFinestLevel(volume));
  auto coarser = std::make_unique<CoarserVolume>();
  coarser->cellWidth = std::move(structure.hierarchy.cellWidth);
  coarser->bricks = std::move(structure.bricks);
  coarser->tree = std::move(structure.tree);
  coarser->scalars = average(volume, coarser->bricks, coarser->cellWidth, factor);
  if (volume.scalars->layer > 0)
  {
    Completion completion =
      complete(coarser->tree, coarser->bricks, coarser->cellWidth, coarser->scalars);
    coarser->bricks = std::move(completion.bricks);
    coarser->scalars = std::move(completion.scalars);
  }
  coarser->ranges =
    findValueRanges(coarser->tree, coarser->bricks, coarser->cellWidth, coarser->scalars);

  glm::dmat4& matrix = coarser->fromHalfCells;
  matrix = glm::translate(matrix, -2.0 * glm::dvec3(coarser->tree.bounds.lo));
  matrix = glm::scale(matrix, glm::dvec3(1.0 / static_cast<double>(factor)));
  matrix = glm::translate(matrix, 2.0 * glm::dvec3(volume.tree->bounds.lo));
  return coarser;
}
}
