// SPDX-License-Identifier: BSD-3-Clause
// Scenes made by code, of any size.
#include "SceneTable.h"
#include "StoredSource.h"

#include "Reference/ForEachPoint.h"
#include "Reference/Scenes.h"

#include <cmath>

namespace exabricks
{
namespace benchmarks
{
namespace
{
class ShellSource : public CellSource
{
public:
  explicit ShellSource(const Hierarchy& hierarchy)
    : Subject(hierarchy)
    , Bounds(reference::boundsOf(hierarchy))
  {
  }

  void read(int block, const Box& cells, double* values) const override
  {
    const double width =
      static_cast<double>(this->Subject.cellWidth[this->Subject.blocks[block].level]);
    reference::forEachPoint(cells,
      [&](const Int3& cell)
      { *values++ = reference::shellAndBlobs(this->Bounds, (glm::dvec3(cell) + 0.5) * width); });
  }

private:
  const Hierarchy& Subject;
  const Box Bounds;
};

// A wrinkled shell in four levels, in so many coarsest blocks along each axis.
Model makeShell(const std::string& name, int coarseBlocks, int blockCells)
{
  Model model;
  model.name = name;
  model.hierarchy = reference::refinedAtShell({ 2, 2, 2 }, coarseBlocks * blockCells, blockCells);
  const Box bounds = reference::boundsOf(model.hierarchy);
  model.cells = std::make_shared<StoredSource>(model.hierarchy, ShellSource(model.hierarchy));
  model.transfer = [](const Range&) { return reference::layeredTransfer(); };
  model.opacityUnitDistance = static_cast<double>(bounds.size().x) / 64.0;
  model.camera = reference::frame(model.hierarchy, bounds, { -0.6, 0.5, -0.4 }, 30.0, 1.0);
  return model;
}

// Blocks of one size, as solvers make them: there are more of them along the shell, and it gets
// thinner. 100 000 cells to a coarsest block on a face of the whole.
Model makeGrowingShell(const std::string& name, double leafCells)
{
  const double onFace = std::max(leafCells, 1e5) / 1e5;
  return makeShell(name, static_cast<int>(std::lround(std::sqrt(onFace))), 8);
}
}

std::vector<SceneKind> listMadeScenes()
{
  const std::string names[] = { "small shell", "shell", "shell in blocks of 8" };
  return {
    { names[0], "made", true, false, [=](double) { return makeShell(names[0], 2, 6); } },
    { names[1], "made", false, true, [=](double) { return makeShell(names[1], 2, 16); }, false,
      false },
    { names[2], "made", false, false,
      [=](double cells) { return makeGrowingShell(names[2], cells > 0.0 ? cells : 1e6); }, true },
  };
}
}
}
