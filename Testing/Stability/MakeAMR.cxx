// SPDX-License-Identifier: BSD-3-Clause
#include "MakeAMR.h"

#include "Cxx/AMR.h"
#include "Reference/ForEachPoint.h"

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace exabricks
{
namespace stability
{
using reference::forEachPoint;

namespace
{
// The lattice in VTK's way: from the coarsest level on.
test::Lattice latticeOf(const Hierarchy& hierarchy)
{
  test::Lattice lattice;
  for (int axis = 0; axis < 3; ++axis)
  {
    lattice.origin[axis] = hierarchy.origin[axis];
    lattice.spacing[axis] =
      hierarchy.spacing[axis] * static_cast<double>(hierarchy.cellWidth.front());
  }
  for (int level = 1; level < hierarchy.levels(); ++level)
  {
    lattice.ratios.push_back(
      static_cast<int>(hierarchy.cellWidth[level - 1] / hierarchy.cellWidth[level]));
  }
  return lattice;
}

test::Block toVTK(const Block& block)
{
  test::Block result{ static_cast<unsigned int>(block.level), {}, {} };
  for (int axis = 0; axis < 3; ++axis)
  {
    result.first[axis] = static_cast<int>(block.cells.lo[axis]);
    result.cells[axis] = static_cast<int>(block.cells.size()[axis]);
  }
  return result;
}

// Marks the cells that finer blocks hold all of.
void markCovered(
  const Hierarchy& hierarchy, const Block& block, const Box& grid, unsigned char* marks)
{
  const Int3 size = grid.size();
  for (const Block& finer : hierarchy.blocks)
  {
    const std::int64_t ratio = hierarchy.cellWidth[block.level] / hierarchy.cellWidth[finer.level];
    if (finer.level <= block.level)
    {
      continue;
    }
    Box covered;
    for (int axis = 0; axis < 3; ++axis)
    {
      covered.lo[axis] = -floorDivide(-finer.cells.lo[axis], ratio);
      covered.hi[axis] = floorDivide(finer.cells.hi[axis], ratio);
    }
    forEachPoint(intersection(covered, block.cells),
      [&](const Int3& c)
      {
        const Int3 at = c - grid.lo;
        marks[at.x + size.x * (at.y + size.y * at.z)] |= vtkDataSetAttributes::REFINEDCELL;
      });
  }
}
}

FieldSource::FieldSource(const Hierarchy& hierarchy, reference::CellField field)
  : Field(std::move(field))
{
  for (const Block& block : hierarchy.blocks)
  {
    this->Levels.push_back(block.level);
  }
}

void FieldSource::read(int block, const Box& cells, double* values) const
{
  forEachPoint(
    cells, [&](const Int3& cell) { *values++ = this->Field(this->Levels[block], cell); });
}

vtkSmartPointer<vtkOverlappingAMR> makeAMR(
  const Hierarchy& hierarchy, const reference::CellField& field, const AMROptions& options)
{
  const test::Lattice lattice = latticeOf(hierarchy);
  std::vector<test::Block> blocks;
  for (const Block& block : hierarchy.blocks)
  {
    blocks.push_back(toVTK(block));
  }
  auto amr = test::makeNullBlocks(blocks, lattice);
  std::vector<unsigned int> next(amr->GetNumberOfLevels(), 0);
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const unsigned int index = next[blocks[b].level]++;
    if (static_cast<int>(b) == options.nullBlock)
    {
      continue;
    }
    const Block& block = hierarchy.blocks[b];
    const std::int64_t layers = options.ghosts;
    const Box cells{ block.cells.lo - layers, block.cells.hi + layers };
    auto grid = test::makeGrid(blocks[b], lattice, options.ghosts);
    vtkSmartPointer<vtkDataArray> values;
    values.TakeReference(options.like ? options.like->NewInstance() : vtkDoubleArray::New());
    values->SetName("value");
    values->SetNumberOfTuples(grid->GetNumberOfCells());
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfTuples(grid->GetNumberOfCells());
    vtkIdType i = 0;
    forEachPoint(cells,
      [&](const Int3& cell)
      {
        const bool ghost = !block.cells.contains(cell);
        const unsigned char mark = vtkDataSetAttributes::DUPLICATECELL;
        values->SetTuple1(i, ghost ? options.ghostValue : field(block.level, cell));
        marks->SetValue(i++, ghost && options.ghostsMarked ? mark : 0);
      });
    markCovered(hierarchy, block, cells, marks->GetPointer(0));
    grid->GetCellData()->SetScalars(values);
    grid->GetCellData()->AddArray(marks);
    amr->SetDataSet(blocks[b].level, index, grid);
  }
  return amr;
}

reference::CellField shellField(const Hierarchy& hierarchy)
{
  return [bounds = reference::boundsOf(hierarchy), widths = hierarchy.cellWidth](
           int level, const Int3& cell)
  {
    return reference::shellAndBlobs(
      bounds, (glm::dvec3(cell) + 0.5) * static_cast<double>(widths[level]));
  };
}

std::vector<Node> layers(double lo, double hi)
{
  std::vector<Node> nodes;
  const TransferFunction transfer = reference::layeredTransfer();
  for (const TransferFunction::Point& point : transfer.points())
  {
    nodes.push_back({ (1.0 - point.value) * lo + point.value * hi, point.color });
  }
  return nodes;
}

std::vector<Node> constantNodes(double opacity, const glm::dvec3& color)
{
  return { { 0.0, glm::dvec4(color, opacity) } };
}

TransferFunction normalize(const std::vector<Node>& nodes, const Range& range)
{
  const auto share = [&](double value)
  {
    const long double min = range.min;
    const long double width = range.max - min;
    return static_cast<double>(width > 0.0L ? (value - min) / width : value - min);
  };
  std::vector<TransferFunction::Point> points;
  for (const Node& node : nodes)
  {
    points.push_back({ share(node.value), node.color });
  }
  return TransferFunction(std::move(points));
}

Hierarchy oneBlock(const Int3& cells)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  hierarchy.blocks = { { 0, { Int3(0), cells } } };
  return hierarchy;
}

Hierarchy twoLevels()
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 2, 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(16) } }, { 1, { Int3(4, 4, 2), Int3(28, 28, 12) } },
    { 1, { Int3(4, 4, 12), Int3(16, 28, 28) } }, { 1, { Int3(16, 16, 12), Int3(28, 28, 28) } } };
  return hierarchy;
}

void look(Setting& setting, const glm::dvec3& direction, double viewAngle)
{
  Hierarchy world = setting.hierarchy;
  world.spacing *= setting.scale;
  setting.camera = reference::frame(world, reference::boundsOf(world), direction, viewAngle,
    static_cast<double>(setting.width) / setting.height);
}

Setting fieldSetting(const Hierarchy& hierarchy, const reference::CellField& field,
  double viewAngle, const AMROptions& options)
{
  Setting setting;
  setting.hierarchy = hierarchy;
  setting.amr = makeAMR(hierarchy, field, options);
  setting.field = field;
  setting.transfer = layers();
  look(setting, { -0.6, 0.5, -0.4 }, viewAngle);
  return setting;
}

Setting shellSetting(const Hierarchy& hierarchy, double viewAngle)
{
  return fieldSetting(hierarchy, shellField(hierarchy), viewAngle);
}
}
}
