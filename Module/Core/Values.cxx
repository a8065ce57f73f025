// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Values.h"

#include "Core/BlockIndex.h"
#include "Core/FirstException.h"

#include <atomic>
#include <cmath>
#include <omp.h>

namespace exabricks
{
namespace
{
// Reads bricks: each cell from the finest block, not finer than the brick, that holds it. (Coarser
// than the brick where a brick fills the rest of partly covered coarse cells.)
class BrickReader
{
public:
  BrickReader(const Hierarchy& hierarchy, const CellSource& source)
    : Grid(hierarchy)
    , Source(source)
    , Index(hierarchy)
  {
  }

  struct Scratch
  {
    std::vector<double> values;
    std::vector<double> part;
    std::vector<unsigned char> duplicate;
    /// [cell of the brick]: 0 as long as it has no value, else greater for a finer level that the
    /// value is from, and odd for a duplicate.
    std::vector<unsigned char> rank;
    std::vector<unsigned char> owned; // [cell of the brick]: a block holds it, and no duplicate
    std::vector<int> blocks;
  };

  /// The brick's values, x fastest, into scratch.values.
  void read(const Brick& brick, Scratch& scratch) const
  {
    const std::size_t n = brick.numberOfCells();
    scratch.values.assign(n, HiddenValue);
    scratch.rank.assign(n, 0);
    scratch.owned.assign(n, 0);
    const Box box = brick.box(this->Grid.cellWidth[brick.level]);
    std::size_t missing = n;
    for (int level = brick.level; level >= 0 && missing > 0; --level)
    {
      // In the order of the blocks, so that of blocks that overlap the same one wins in all bricks.
      scratch.blocks.clear();
      this->Index.boxes[level].forEachIntersecting(
        box, [&](int i) { scratch.blocks.push_back(i); });
      std::sort(scratch.blocks.begin(), scratch.blocks.end());
      for (const int i : scratch.blocks)
      {
        missing -= this->ReadPart(brick, box, level, i, scratch);
      }
    }
    // What there are but duplicates of is another process's to draw.
    for (std::size_t t = 0; t < n && missing > 0; ++t)
    {
      scratch.values[t] = scratch.owned[t] ? scratch.values[t] : HiddenValue;
    }
  }

private:
  // Returns how many of the brick's cells were not owned before.
  std::size_t ReadPart(const Brick& brick, const Box& box, int level, int i, Scratch& scratch) const
  {
    const int block = this->Index.blocks[level][i];
    const std::int64_t fine = this->Grid.cellWidth[brick.level];
    const std::int64_t coarse = this->Grid.cellWidth[level];
    const Box common = intersection(box, this->Index.boxes[level].box(i));
    const Box target = outwardToCells(common, fine);  // cells of the brick
    const Box cells = outwardToCells(common, coarse); // cells of the block
    const Int3 size = cells.size();
    const std::size_t n = static_cast<std::size_t>(cells.volume());
    const Int3 first = box.lo / fine;
    const unsigned char real = static_cast<unsigned char>(2 * level + 2);

    if (level == brick.level && n == scratch.values.size() && !this->Source.hasDuplicates(block) &&
      std::all_of(scratch.rank.begin(), scratch.rank.end(), [](unsigned char r) { return r == 0; }))
    {
      this->Source.read(block, cells, scratch.values.data());
      std::fill(scratch.rank.begin(), scratch.rank.end(), real);
      std::fill(scratch.owned.begin(), scratch.owned.end(), static_cast<unsigned char>(1));
      return n;
    }
    scratch.part.resize(n);
    this->Source.read(block, cells, scratch.part.data());
    scratch.duplicate.assign(n, 0);
    if (this->Source.hasDuplicates(block))
    {
      this->Source.readDuplicates(block, cells, scratch.duplicate.data());
    }
    std::size_t added = 0;
    Int3 c;
    for (c.z = target.lo.z; c.z < target.hi.z; ++c.z)
    {
      for (c.y = target.lo.y; c.y < target.hi.y; ++c.y)
      {
        for (c.x = target.lo.x; c.x < target.hi.x; ++c.x)
        {
          const Int3 to = c - first;
          const std::size_t t = to.x + brick.cells.x * (to.y + std::size_t(brick.cells.y) * to.z);
          Int3 from;
          for (int axis = 0; axis < 3; ++axis)
          {
            from[axis] = floorDivide(c[axis] * fine, coarse) - cells.lo[axis];
          }
          const std::size_t f = from.x + size.x * (from.y + size.y * from.z);
          // The finest level wins, and within a level the real cell.
          const unsigned char rank = scratch.duplicate[f] ? real - 1 : real;
          if (!scratch.duplicate[f] && !scratch.owned[t])
          {
            scratch.owned[t] = 1;
            ++added;
          }
          if (rank > scratch.rank[t])
          {
            scratch.rank[t] = rank;
            scratch.values[t] = scratch.part[f];
          }
        }
      }
    }
    return added;
  }

  const Hierarchy& Grid;
  const CellSource& Source;
  const BlockIndex Index;
};

// Runs `work(brick, scratch)` for all bricks on all threads. This is one of two passes, and reports
// half of the progress; `before` is the fraction that was done before it. False if it is aborted.
template <typename Work>
bool forEachBrick(
  const Structure& structure, double before, const Progress& progress, const Work& work)
{
  const std::size_t count = structure.bricks.size();
  if (progress && !progress(before))
  {
    return false;
  }
  std::atomic<bool> aborted{ false };
  std::atomic<std::size_t> done{ 0 };
  FirstException failure;
#pragma omp parallel if (structure.leafCells > ParallelCells)
  {
    BrickReader::Scratch scratch;
    std::size_t own = 0;
#pragma omp for schedule(dynamic, 2)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i)
    {
      if (aborted)
      {
        continue;
      }
      failure.guard(
        [&]
        {
          work(static_cast<std::size_t>(i), scratch);
          const std::size_t n = ++done;
          if (progress && omp_get_thread_num() == 0 && ++own % 16 == 0)
          {
            aborted = !progress(before + 0.5 * static_cast<double>(n) / static_cast<double>(count));
          }
        });
    }
  }
  failure.rethrow();
  return !aborted && (!progress || progress(before + 0.5));
}
}

std::vector<std::uint64_t> findFirstValues(const std::vector<Brick>& bricks, int layer)
{
  std::vector<std::uint64_t> first;
  first.reserve(bricks.size() + 1);
  first.push_back(0);
  for (const Brick& brick : bricks)
  {
    first.push_back(first.back() + brick.numberOfValues(layer));
  }
  return first;
}

Values gatherValues(const Structure& structure, const CellSource& source, const Progress& progress)
{
  Values values;
  const std::vector<Brick>& bricks = structure.bricks;
  const BrickReader reader(structure.hierarchy, source);
  const std::optional<Range> whole = source.wholeRange();
  std::vector<Range> ranges(whole ? 0 : bricks.size());
  const bool ranged = whole ||
    forEachBrick(structure, 0.0, progress,
      [&](std::size_t b, BrickReader::Scratch& scratch)
      {
        reader.read(bricks[b], scratch);
        for (const double value : scratch.values)
        {
          if (std::isfinite(value))
          {
            ranges[b].add(value);
          }
        }
      });
  for (const Range& range : ranges)
  {
    values.range.add(range);
  }
  std::vector<Range>().swap(ranges);
  values.range = whole.value_or(values.range);
  if (!ranged)
  {
    return values;
  }

  values.firstValue = findFirstValues(bricks, values.layer);
  values.normalized.resize(values.firstValue.back());
  values.brickHasAbsentCells.assign(bricks.size(), 0);
  values.brickHasUndefinedCells.assign(bricks.size(), 0);
  std::atomic<std::uint64_t> absentCells{ 0 };
  const bool gathered = forEachBrick(structure, 0.5, progress,
    [&](std::size_t b, BrickReader::Scratch& scratch)
    {
      reader.read(bricks[b], scratch);
      float* to = values.normalized.data() + values.firstValue[b];
      std::uint64_t absent = 0;
      std::uint64_t undefined = 0;
      for (const double value : scratch.values)
      {
        const bool there = std::isfinite(value);
        const bool hidden = value == HiddenValue;
        *to++ = there ? static_cast<float>(std::clamp(values.range.normalize(value), 0.0, 1.0))
          : hidden    ? layout::ABSENT
                      : layout::UNDEFINED;
        absent += !there;
        undefined += !there && !hidden;
      }
      values.brickHasAbsentCells[b] = absent > 0;
      values.brickHasUndefinedCells[b] = undefined > 0;
      absentCells += absent;
    });
  values.absentCells = absentCells;
  if (!gathered)
  {
    values.normalized.clear();
  }
  return values;
}

std::shared_ptr<const Values> makeValues(
  const Structure& structure, const CellSource& source, const Progress& progress)
{
  // Finding the ranges takes about a tenth of the time, and does not report.
  const Progress gathering =
    !progress ? Progress() : [&progress](double done) { return progress(0.9 * done); };
  auto values = std::make_shared<Values>(gatherValues(structure, source, gathering));
  if (values->normalized.empty())
  {
    return nullptr;
  }
  values->ranges = findValueRanges(structure, *values);
  return !progress || progress(1.0) ? values : nullptr;
}
}
