// SPDX-License-Identifier: BSD-3-Clause
#include "Variants.h"

#include "CellLocation/BrickTree.h"

#include "CellLocationSpirv.h"
#include "CountsSpirv.h"
#include "FinestStepsSpirv.h"
#include "LatticeSpirv.h"
#include "LeftEndSpirv.h"
#include "MidpointSpirv.h"
#include "NaiveWalkSpirv.h"
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

template <std::size_t N>
std::vector<std::uint32_t> toWords(const std::uint32_t (&spirv)[N])
{
  return { std::begin(spirv), std::end(spirv) };
}

/// Of a method that needs no data of its own. `spirv`: an array; none: our own shader.
template <typename... Words>
auto makePlain(bool skipsSpace, const Words&... spirv)
{
  MarchProgram program;
  ((program.spirv = toWords(spirv)), ...);
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
  MarchProgram program;
  program.spirv = toWords(CellLocationSpirv);
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
  MarchProgram program;
  program.spirv = toWords(NaiveWalkSpirv);
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
      makePlain(true, UncorrectedSpirv) },
    { "midpoint", "the value in the interval's middle, not the mean over values",
      makePlain(true, MidpointSpirv) },
    { "left end", "the value where the interval begins", makePlain(true, LeftEndSpirv) },
    { "unfitted steps", "intervals on one lattice along the ray, cut at regions",
      makePlain(true, LatticeSpirv) },
    { "no skipping", "regions that show nothing are marched too", makePlain(false) },
    { "finest steps", "those of the finest cells everywhere", makePlain(true, FinestStepsSpirv) },
  };
  return all;
}

const Variant& countingVariant()
{
  static const Variant counting{ "counts", "samples, intervals, regions, tree steps",
    makePlain(true, CountsSpirv) };
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
