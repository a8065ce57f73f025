// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Coarsening.h"

#include "Core/BoxIndex.h"
#include "Core/Completion.h"
#include "Core/FirstException.h"

#include <glm/ext/matrix_transform.hpp>
#include <omp.h>

namespace exabricks
{
namespace
{
// Takes the bricks for blocks, those of the finest level in cells of the next one.
Hierarchy withoutFinestLevel(const Structure& structure)
{
  const std::vector<std::int64_t>& width = structure.hierarchy.cellWidth;
  const int coarsest = structure.hierarchy.levels() - 2;
  Hierarchy hierarchy;
  for (int level = 0; level <= coarsest; ++level)
  {
    hierarchy.cellWidth.push_back(width[level] / width[coarsest]);
  }
  hierarchy.blocks.reserve(structure.bricks.size());
  for (const Brick& brick : structure.bricks)
  {
    const int level = std::min(brick.level, coarsest);
    hierarchy.blocks.push_back({ level, outwardToCells(structure.box(brick), width[level]) });
  }
  if (const std::optional<Box>& shown = structure.hierarchy.shown)
  {
    hierarchy.shown = Box{ shown->lo / width[coarsest], shown->hi / width[coarsest] };
  }
  return hierarchy;
}

// The values of bricks as means over those of others, which hold the same space in other cells.
class Averager
{
public:
  explicit Averager(const Volume& from)
    : Grid(*from.structure)
    , Given(*from.values)
    , Index(BoxesOf(*from.structure))
  {
  }

  struct Scratch
  {
    std::vector<double> sum;
    std::vector<int> count;
    std::vector<int> bricks;
  };

  /// Averages over the cells, `width` wide, of a brick at `box`. Both are in finest cells of the
  /// volume that is averaged.
  void average(const Box& box, std::int64_t width, Scratch& scratch) const
  {
    const Int3 n = box.size() / width;
    const std::size_t cells = static_cast<std::size_t>(n.x * n.y * n.z);
    scratch.sum.assign(cells, 0.0);
    scratch.count.assign(cells, 0);
    // They are added in a fixed order, as the rounding of sums depends on it.
    scratch.bricks.clear();
    this->Index.forEachIntersecting(box, [&](int i) { scratch.bricks.push_back(i); });
    std::sort(scratch.bricks.begin(), scratch.bricks.end());
    for (const int i : scratch.bricks)
    {
      this->Add(static_cast<std::size_t>(i), box, width, n, scratch);
    }
  }

private:
  static std::vector<Box> BoxesOf(const Structure& structure)
  {
    std::vector<Box> boxes;
    boxes.reserve(structure.bricks.size());
    for (const Brick& brick : structure.bricks)
    {
      boxes.push_back(structure.box(brick));
    }
    return boxes;
  }

  void Add(std::size_t b, const Box& box, std::int64_t width, const Int3& n, Scratch& scratch) const
  {
    const Brick& brick = this->Grid.bricks[b];
    const std::int64_t own = this->Grid.width(brick);
    const int layer = this->Given.layer;
    const Int3 stored(brick.cells + 2 * layer);
    const float* values = this->Given.ofBrick(b);
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

  const Structure& Grid;
  const Values& Given;
  const BoxIndex Index;
};

// `factor`: width of the structure's finest cells in those of the volume.
Values average(const Volume& from, const Structure& structure, std::int64_t factor)
{
  Values values;
  values.range = from.values->range;
  values.firstValue = findFirstValues(structure.bricks, values.layer);
  const std::uint64_t cells = values.firstValue.back();
  values.normalized.resize(cells);
  values.brickHasAbsentCells.assign(structure.bricks.size(), 0);
  const Averager averager(from);
  std::vector<Averager::Scratch> scratches(omp_get_max_threads());
  std::uint64_t absentCells = 0;
  // Returns how many of the brick's cells are absent.
  const auto averageBrick = [&](std::size_t b) -> std::uint64_t
  {
    const Brick& brick = structure.bricks[b];
    Averager::Scratch& scratch = scratches[omp_get_thread_num()];
    averager.average(
      scaled(structure.box(brick), factor), structure.width(brick) * factor, scratch);
    float* to = values.normalized.data() + values.firstValue[b];
    std::uint64_t absent = 0;
    for (std::size_t i = 0; i < scratch.sum.size(); ++i)
    {
      const bool there = scratch.count[i] > 0;
      *to++ = there ? static_cast<float>(scratch.sum[i] / scratch.count[i]) : layout::ABSENT;
      absent += !there;
    }
    values.brickHasAbsentCells[b] = absent > 0;
    return absent;
  };
  FirstException failure;
#pragma omp parallel for schedule(dynamic, 2) reduction(+ : absentCells) if (cells > ParallelCells)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(structure.bricks.size()); ++b)
  {
    failure.guard([&] { absentCells += averageBrick(static_cast<std::size_t>(b)); });
  }
  failure.rethrow();
  values.absentCells = absentCells;
  return values;
}

// Width of the finest cells that are left when the finest level is left out.
std::int64_t factorOf(const Structure& finer)
{
  return finer.hierarchy.cellWidth[finer.hierarchy.cellWidth.size() - 2];
}

// Whether the part that is drawn ends at half cells of those that are left.
bool isShownInHalfCells(const Structure& finer)
{
  const std::optional<Box>& shown = finer.hierarchy.shown;
  const Int3 factor(factorOf(finer));
  return !shown || (shown->lo % factor == Int3(0) && shown->hi % factor == Int3(0));
}
}

std::optional<CoarserStructure> coarsen(const Structure& finer)
{
  if (finer.hierarchy.levels() < 2 || finer.bricks.empty() || !isShownInHalfCells(finer))
  {
    return std::nullopt;
  }
  Structure structure = buildStructure(withoutFinestLevel(finer));
  structure.hierarchy.blocks = {};
  CoarserStructure coarser;
  glm::dmat4& matrix = coarser.fromHalfCells;
  matrix = glm::translate(matrix, -2.0 * glm::dvec3(structure.tree.bounds.lo));
  matrix = glm::scale(matrix, glm::dvec3(1.0 / static_cast<double>(factorOf(finer))));
  matrix = glm::translate(matrix, 2.0 * glm::dvec3(finer.tree.bounds.lo));
  coarser.structure = std::make_shared<const Structure>(std::move(structure));
  return coarser;
}

std::shared_ptr<const Values> coarsen(const Volume& finer, const Structure& coarser)
{
  Values values = average(finer, coarser, factorOf(*finer.structure));
  if (finer.values->layer > 0)
  {
    return complete(coarser, values);
  }
  values.ranges = findValueRanges(coarser, values);
  return std::make_shared<const Values>(std::move(values));
}
}
