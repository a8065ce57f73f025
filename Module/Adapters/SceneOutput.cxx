// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/SceneOutput.h"

#include "Adapters/AMRCompatibility.h"
#include "Core/BlockIndex.h"
#include "Core/FirstException.h"

#include "vtkAMRBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <new>

namespace exabricks
{
namespace
{
// Throws std::bad_alloc if there is too little memory for the blocks. All of it is asked for before
// the first block is made, as VTK ends the process where it has no memory for an object of its own.
void expectMemory(const Hierarchy& hierarchy)
{
  constexpr std::size_t bytesOfGrid = 8192; // with its attributes and arrays; VTK 9.1 takes 5100
  constexpr std::size_t bytesOfCell = sizeof(float) + sizeof(unsigned char);
  std::size_t bytes = 0;
  for (const Block& block : hierarchy.blocks)
  {
    bytes += bytesOfGrid + bytesOfCell * static_cast<std::size_t>(block.cells.volume());
  }
  ::operator delete(::operator new(bytes));
}

void initialize(const Hierarchy& hierarchy, vtkOverlappingAMR* amr)
{
  std::vector<int> blocksPerLevel(hierarchy.levels(), 0);
  for (const Block& block : hierarchy.blocks)
  {
    ++blocksPerLevel[block.level];
  }
  exabricks::initialize(amr, blocksPerLevel);
  amr->SetOrigin(&hierarchy.origin.x);
  for (int level = 0; level < hierarchy.levels(); ++level)
  {
    const glm::dvec3 spacing = hierarchy.spacing * static_cast<double>(hierarchy.cellWidth[level]);
    amr->SetSpacing(static_cast<unsigned int>(level), &spacing.x);
  }
}

// Marks the cells of the block that blocks of the next level cover; blocks of further levels lie
// inside those.
void markRefined(
  const Hierarchy& hierarchy, const BlockIndex& index, const Block& block, unsigned char* marks)
{
  const int finer = block.level + 1;
  if (finer == hierarchy.levels())
  {
    return;
  }
  const Box logical = hierarchy.logicalBox(block);
  const Int3 size = block.cells.size();
  index.boxes[finer].forEachIntersecting(logical,
    [&](int i)
    {
      const Box covered = outwardToCells(
        intersection(index.boxes[finer].box(i), logical), hierarchy.cellWidth[block.level]);
      for (std::int64_t z = covered.lo.z; z < covered.hi.z; ++z)
      {
        for (std::int64_t y = covered.lo.y; y < covered.hi.y; ++y)
        {
          const Int3 at = Int3(covered.lo.x, y, z) - block.cells.lo;
          std::fill_n(marks + at.x + size.x * (at.y + size.y * at.z), covered.size().x,
            static_cast<unsigned char>(vtkDataSetAttributes::REFINEDCELL));
        }
      }
    });
}

vtkSmartPointer<vtkUniformGrid> makeGrid(const Hierarchy& hierarchy, const Block& block)
{
  const glm::dvec3 spacing =
    hierarchy.spacing * static_cast<double>(hierarchy.cellWidth[block.level]);
  const glm::dvec3 corner = hierarchy.origin + spacing * glm::dvec3(block.cells.lo);
  const glm::ivec3 points(block.cells.size() + std::int64_t(1));
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->SetOrigin(&corner.x);
  grid->SetSpacing(&spacing.x);
  grid->SetDimensions(points.x, points.y, points.z);
  return grid;
}

// Writes the values of a block, row by row, as it may be large.
void fill(const CellSource& cells, int block, const Box& box, float* to)
{
  std::vector<double> row(static_cast<std::size_t>(box.size().x));
  for (std::int64_t z = box.lo.z; z < box.hi.z; ++z)
  {
    for (std::int64_t y = box.lo.y; y < box.hi.y; ++y)
    {
      cells.read(block, { { box.lo.x, y, z }, { box.hi.x, y + 1, z + 1 } }, row.data());
      to = std::transform(
        row.begin(), row.end(), to, [](double value) { return static_cast<float>(value); });
    }
  }
}
}

bool writeAMR(const Hierarchy& hierarchy, const CellSource& cells, const char* name,
  vtkOverlappingAMR* amr, const Progress& progress, const Piece& piece)
{
  expectMemory(hierarchy);
  initialize(hierarchy, amr);
  const BlockIndex index(hierarchy);
  const int count = static_cast<int>(hierarchy.blocks.size());
  std::vector<vtkSmartPointer<vtkFloatArray>> arrays;
  std::vector<unsigned int> next(hierarchy.levels(), 0);
  for (const Block& block : hierarchy.blocks)
  {
    const unsigned int level = static_cast<unsigned int>(block.level);
    const unsigned int number = next[level]++;
    const glm::ivec3 first(block.cells.lo);
    const glm::ivec3 last(block.cells.hi - std::int64_t(1));
    amr->SetAMRBox(level, number, vtkAMRBox(&first.x, &last.x));
    if (!piece.has(number))
    {
      arrays.emplace_back(nullptr);
      continue;
    }
    const vtkIdType size = static_cast<vtkIdType>(block.cells.volume());
    auto grid = makeGrid(hierarchy, block);
    vtkNew<vtkFloatArray> values;
    values->SetName(name);
    values->SetNumberOfValues(size);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfValues(size);
    marks->FillValue(0);
    markRefined(hierarchy, index, block, marks->GetPointer(0));
    grid->GetCellData()->SetScalars(values);
    grid->GetCellData()->AddArray(marks);
    arrays.emplace_back(values);
    amr->SetDataSet(level, number, grid);
  }

  // Filled in parts, so that progress can be told between them.
  constexpr int part = 512;
  for (int begin = 0; begin < count; begin += part)
  {
    if (progress && !progress(static_cast<double>(begin) / count))
    {
      return false;
    }
    const int end = std::min(begin + part, count);
    FirstException failure;
#pragma omp parallel for schedule(dynamic, 4)
    for (int b = begin; b < end; ++b)
    {
      if (arrays[b])
      {
        failure.guard([&] { fill(cells, b, hierarchy.blocks[b].cells, arrays[b]->GetPointer(0)); });
      }
    }
    failure.rethrow();
  }
  return true;
}

void writeMesh(const TriangleMesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble(); // far from 0 a float has too few digits
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), &mesh.points[i].x);
  }
  vtkNew<vtkCellArray> triangles;
  for (const glm::ivec3& triangle : mesh.triangles)
  {
    triangles->InsertNextCell({ triangle.x, triangle.y, triangle.z });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
}

void writeTransfer(
  const TransferFunction& transfer, const Range& range, vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacity;
  double last = -std::numeric_limits<double>::infinity();
  for (const TransferFunction::Point& point : transfer.points())
  {
    double value = range.min + point.value * (range.max - range.min);
    if (value <= last) // at a jump, as VTK keeps one node alone for a value
    {
      value = std::nextafter(last, std::numeric_limits<double>::infinity());
    }
    colors->AddRGBPoint(value, point.color.r, point.color.g, point.color.b);
    opacity->AddPoint(value, point.color.a);
    last = value;
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
}
}
