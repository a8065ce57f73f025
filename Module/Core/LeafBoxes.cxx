// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeafBoxes.h"

#include "Core/BlockIndex.h"
#include "Core/FirstException.h"
#include "Core/SharedProgress.h"

#include <cstdlib>

namespace exabricks
{
namespace
{
// Finds, among the faces of `cutters` inside `box`, the one that halves its longest axis best.
std::pair<int, std::int64_t> chooseCut(const Box& box, const std::vector<Box>& cutters)
{
  const Int3 size = box.size();
  int axis = -1;
  std::int64_t plane = 0;
  double best = -1.0;
  for (const Box& cutter : cutters)
  {
    for (int a = 0; a < 3; ++a)
    {
      for (const std::int64_t p : { cutter.lo[a], cutter.hi[a] })
      {
        // The shorter side of the cut counts most: it is long for cuts through the middle of a
        // long axis.
        const double score = static_cast<double>(std::min(p - box.lo[a], box.hi[a] - p)) * 16.0 +
          static_cast<double>(size[a]);
        if (p > box.lo[a] && p < box.hi[a] && score > best)
        {
          best = score;
          axis = a;
          plane = p;
        }
      }
    }
  }
  return { axis, plane };
}

std::vector<Box> subtractFromAll(const std::vector<Box>& boxes, const std::vector<Box>& cutters)
{
  std::vector<Box> rest;
  for (const Box& box : boxes)
  {
    subtract(box, cutters, rest);
  }
  return rest;
}

// What is left of one block that finer ones cover: whole cells, and pieces of cells that are
// covered in part.
class VisiblePart
{
public:
  VisiblePart(const Box& box, std::int64_t width)
    : Whole{ box }
    , Width(width)
  {
  }

  void cover(const BoxIndex& finer)
  {
    std::vector<Box> whole;
    std::vector<Box> cutters;
    std::vector<Box> cells; // the cutters grown to whole cells
    for (const Box& box : this->Whole)
    {
      cutters.clear();
      cells.clear();
      bool aligned = true;
      finer.forEachIntersecting(box,
        [&](int i)
        {
          cutters.push_back(intersection(box, finer.box(i)));
          cells.push_back(scaled(outwardToCells(cutters.back(), this->Width), this->Width));
          aligned = aligned && cells.back() == cutters.back();
        });
      const std::size_t before = whole.size();
      subtract(box, cells, whole);
      if (!aligned)
      {
        std::vector<Box> touched;
        subtract(box, { whole.begin() + before, whole.end() }, touched);
        for (const Box& piece : touched)
        {
          subtract(piece, cutters, this->Pieces);
        }
      }
    }
    this->Whole.swap(whole);

    if (!this->Pieces.empty())
    {
      std::vector<Box> pieces;
      for (const Box& piece : this->Pieces)
      {
        cutters.clear();
        finer.forEachIntersecting(piece, [&](int i) { cutters.push_back(finer.box(i)); });
        subtract(piece, cutters, pieces);
      }
      this->Pieces.swap(pieces);
    }
  }

  void giveWayTo(const std::vector<Box>& sameLevel)
  {
    this->Whole = subtractFromAll(this->Whole, sameLevel);
  }

  const std::vector<Box>& whole() const { return this->Whole; }
  const std::vector<Box>& pieces() const { return this->Pieces; }

private:
  std::vector<Box> Whole;
  std::vector<Box> Pieces;
  std::int64_t Width;
};
}

void subtract(const Box& box, const std::vector<Box>& cutters, std::vector<Box>& rest)
{
  std::vector<Box> inside;
  for (const Box& cutter : cutters)
  {
    if (cutter.contains(box))
    {
      return;
    }
    if (cutter.intersects(box))
    {
      inside.push_back(intersection(cutter, box));
    }
  }
  if (inside.empty())
  {
    rest.push_back(box);
    return;
  }
  const auto cut = chooseCut(box, inside);
  const auto parts = split(box, cut.first, cut.second);
  subtract(parts.first, inside, rest);
  subtract(parts.second, inside, rest);
}

namespace
{
// What is left of the blocks from one on, in their order.
class LeafFinder
{
public:
  LeafFinder(const Hierarchy& hierarchy, const BlockIndex& index)
    : Of(hierarchy)
    , Index(index)
  {
  }

  void add(std::size_t b)
  {
    const Block& block = this->Of.blocks[b];
    const Box box = this->Of.logicalBox(block);
    const BoxIndex& sameLevel = this->Index.boxes[block.level];
    VisiblePart part(box, this->Of.cellWidth[block.level]);
    this->Earlier.clear();
    sameLevel.forEachIntersecting(box,
      [&](int i)
      {
        if (this->Index.blocks[block.level][i] < static_cast<int>(b))
        {
          this->Earlier.push_back(sameLevel.box(i));
        }
      });
    if (!this->Earlier.empty())
    {
      part.giveWayTo(this->Earlier);
    }
    for (int finer = block.level + 1; finer < this->Of.levels(); ++finer)
    {
      part.cover(this->Index.boxes[finer]);
    }
    for (const Box& whole : part.whole())
    {
      this->Keep(block.level, whole);
    }
    for (const Box& piece : part.pieces())
    {
      int level = block.level;
      while (!alignedTo(piece, this->Of.cellWidth[level]))
      {
        ++level;
      }
      this->Keep(level, piece);
      ++this->Found.partlyCoveredBoxes;
    }
  }

  const LeafBoxes& found() const { return this->Found; }

private:
  void Keep(int level, const Box& box)
  {
    const Int3 n = box.size() / this->Of.cellWidth[level];
    this->Found.boxes.push_back({ level, box });
    this->Found.bounds = unite(this->Found.bounds, box);
    this->Found.cells += static_cast<std::uint64_t>(n.x) * n.y * n.z;
  }

  const Hierarchy& Of;
  const BlockIndex& Index;
  LeafBoxes Found;
  std::vector<Box> Earlier;
};
}

LeafBoxes findLeafBoxes(const Hierarchy& hierarchy, const Progress& progress)
{
  constexpr std::size_t blocksAtOnce = 256;
  const BlockIndex index(hierarchy);
  const std::size_t blocks = hierarchy.blocks.size();
  const std::size_t count = (blocks + blocksAtOnce - 1) / blocksAtOnce;
  std::vector<LeafFinder> finders(count, LeafFinder(hierarchy, index));
  SharedProgress shared(progress);
  FirstException failure;
#pragma omp parallel for schedule(dynamic, 1) if (count > 1)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i)
  {
    failure.guard(
      [&]
      {
        const std::size_t first = static_cast<std::size_t>(i) * blocksAtOnce;
        const std::size_t last = std::min(first + blocksAtOnce, blocks);
        for (std::size_t b = first; b < last && !shared.aborted(); ++b)
        {
          finders[static_cast<std::size_t>(i)].add(b);
        }
        shared.pass(static_cast<double>(last - first) / static_cast<double>(blocks));
      });
  }
  failure.rethrow();
  LeafBoxes leaves;
  if (shared.aborted())
  {
    return leaves;
  }
  for (const LeafFinder& finder : finders)
  {
    const LeafBoxes& found = finder.found();
    leaves.boxes.insert(leaves.boxes.end(), found.boxes.begin(), found.boxes.end());
    leaves.bounds = unite(leaves.bounds, found.bounds);
    leaves.cells += found.cells;
    leaves.partlyCoveredBoxes += found.partlyCoveredBoxes;
  }
  return leaves;
}
}
