// SPDX-License-Identifier: BSD-3-Clause
#include "Variants.h"

#include "CellLocation/BrickTree.h"

#include "CellLocationInt64Spirv.h"
#include "CellLocationSpirv.h"
#include "CountsInt64Spirv.h"
#include "CountsSpirv.h"
#include "FinestStepsInt64Spirv.h"
#include "FinestStepsSpirv.h"
#include "LanesInt64Spirv.h"
#include "LanesSpirv.h"
#include "LatticeInt64Spirv.h"
#include "LatticeSpirv.h"
#include "LeftEndInt64Spirv.h"
#include "LeftEndSpirv.h"
#include "MidpointInt64Spirv.h"
#include "MidpointSpirv.h"
#include "NaiveWalkInt64Spirv.h"
#include "NaiveWalkSpirv.h"
#include "UncorrectedInt64Spirv.h"
#include "UncorrectedSpirv.h"

#include <cstring>
#include <stdexcept>

namespace exabricks
{
namespace benchmarks
{
namespace
{
using Program = std::shared_ptr<const MarchProgram>;

template <std::size_t N, std::size_t M>
MarchProgram makeProgram(const std::uint32_t (&spirv)[N], const std::uint32_t (&int64Spirv)[M])
{
  MarchProgram program;
  program.shader.spirv.assign(std::begin(spirv), std::end(spirv));
  program.shader.int64Spirv.assign(std::begin(int64Spirv), std::end(int64Spirv));
  return program;
}

/// Of a method that needs no data of its own, and may be our own shader.
auto makePlain(MarchProgram program, bool skipsSpace = true)
{
  program.skipsSpace = skipsSpace;
  return [shared = std::make_shared<const MarchProgram>(std::move(program))](const Volume&)
  { return shared; };
}

template <typename T>
void append(std::vector<std::uint32_t>& words, const std::vector<T>& items)
{
  static_assert(sizeof(T) % sizeof(std::uint32_t) == 0, "whole words");
  const std::size_t first = words.size();
  words.resize(first + items.size() * sizeof(T) / sizeof(std::uint32_t));
  std::memcpy(words.data() + first, items.data(), items.size() * sizeof(T));
}

Program makeCellLocation(const Volume& volume)
{
  MarchProgram program = makeProgram(CellLocationSpirv, CellLocationInt64Spirv);
  append(program.data,
    buildBrickTree(volume.structure->bricks, volume.structure->hierarchy.cellWidth,
      volume.structure->tree.bounds.lo, BrickExtent::Support));
  return std::make_shared<const MarchProgram>(std::move(program));
}

/// Cells of a width lie at its multiples. Those that may have a tent in the bounds begin a cell
/// before them.
std::vector<layout::LevelLattice> makeLattices(const Volume& volume)
{
  std::vector<layout::LevelLattice> lattices;
  const Int3& corner = volume.structure->tree.bounds.lo;
  for (const std::int64_t width : volume.structure->hierarchy.cellWidth)
  {
    layout::LevelLattice lattice{};
    for (int axis = 0; axis < 3; ++axis)
    {
      lattice.origin[axis] =
        static_cast<int>(2 * ((floorDivide(corner[axis], width) - 1) * width - corner[axis]));
    }
    lattice.width = static_cast<int>(width);
    lattices.push_back(lattice);
  }
  return lattices;
}

Program makeNaiveWalk(const Volume& volume)
{
  MarchProgram program = makeProgram(NaiveWalkSpirv, NaiveWalkInt64Spirv);
  program.skipsSpace = false;
  const std::vector<layout::LevelLattice> lattices = makeLattices(volume);
  program.data.push_back(static_cast<std::uint32_t>(lattices.size()));
  append(program.data, lattices);
  append(program.data,
    buildBrickTree(volume.structure->bricks, volume.structure->hierarchy.cellWidth,
      volume.structure->tree.bounds.lo, BrickExtent::Cells));
  return std::make_shared<const MarchProgram>(std::move(program));
}
}

const std::vector<Variant>& variants()
{
  static const std::vector<Variant> all{
    { "ours", "active brick regions", [](const Volume&) { return Program(); } },
    { "cell location", "each sample finds its bricks by a tree over them", makeCellLocation },
    { "naive walk",
      "each sample finds eight cells of each level by a tree; finest steps, no skipping",
      makeNaiveWalk },
    { "no opacity correction", "samples as opaque as a finest cell, however long they stand for",
      makePlain(makeProgram(UncorrectedSpirv, UncorrectedInt64Spirv)) },
    { "midpoint", "the value in the interval's middle, not the mean over values",
      makePlain(makeProgram(MidpointSpirv, MidpointInt64Spirv)) },
    { "left end", "the value where the interval begins",
      makePlain(makeProgram(LeftEndSpirv, LeftEndInt64Spirv)) },
    { "unfitted steps", "intervals on one lattice along the ray, cut at regions",
      makePlain(makeProgram(LatticeSpirv, LatticeInt64Spirv)) },
    { "no skipping", "regions that show nothing are marched too", makePlain({}, false) },
    { "finest steps", "those of the finest cells everywhere",
      makePlain(makeProgram(FinestStepsSpirv, FinestStepsInt64Spirv)) },
  };
  return all;
}

const Variant& countingVariant()
{
  static const Variant counting{ "counts", "samples, intervals, regions, tree steps",
    makePlain(makeProgram(CountsSpirv, CountsInt64Spirv)) };
  return counting;
}

const Variant& laneCountingVariant()
{
  static const Variant counting{ "lanes", "halves that show nothing, rounds, lanes on",
    makePlain(makeProgram(LanesSpirv, LanesInt64Spirv)) };
  return counting;
}

const Variant& findVariant(const std::string& name)
{
  for (const Variant& variant : variants())
  {
    if (variant.name == name)
    {
      return variant;
    }
  }
  throw std::out_of_range("there is no variant \"" + name + "\"");
}
}
}
