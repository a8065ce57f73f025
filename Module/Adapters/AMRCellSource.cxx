// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/AMRCellSource.h"

#include "Adapters/Ghosts.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArrayAccessor.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace exabricks
{
namespace
{
// Reads a row of values as double; `component` as for AMRCellSource. One for each type of array.
struct RowReader
{
  template <typename Array>
  void operator()(Array* array, vtkIdType first, std::int64_t count, int component, bool needsAll,
    double* values) const
  {
    const vtkDataArrayAccessor<Array> get(array);
    const int components = array->GetNumberOfComponents();
    if (component >= 0)
    {
      for (std::int64_t i = 0; i < count; ++i)
      {
        values[i] = static_cast<double>(get.Get(first + i, component));
        for (int c = 0; needsAll && c < components; ++c)
        {
          const bool there = std::isfinite(static_cast<double>(get.Get(first + i, c)));
          values[i] = there ? values[i] : std::numeric_limits<double>::quiet_NaN();
        }
      }
      return;
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      double sum = 0.0;
      for (int c = 0; c < components; ++c)
      {
        const double value = static_cast<double>(get.Get(first + i, c));
        sum += value * value;
      }
      values[i] = std::sqrt(sum);
    }
  }
};

// Reads all rows of a box, for one type of array.
struct BoxReader
{
  template <typename Array>
  void operator()(Array* array, const std::vector<vtkIdType>& rows, std::int64_t count,
    int component, bool needsAll, double* values) const
  {
    const RowReader readRow;
    for (const vtkIdType row : rows)
    {
      readRow(array, row, count, component, needsAll, values);
      values += count;
    }
  }
};

// Bits are read through a buffer of the array's own, which threads cannot share.
vtkSmartPointer<vtkDataArray> readableByThreads(vtkDataArray* array)
{
  if (array->GetDataType() != VTK_BIT)
  {
    return array;
  }
  auto copy = vtkSmartPointer<vtkUnsignedCharArray>::New();
  copy->DeepCopy(array);
  return copy;
}

// `component`: as for AMRCellSource; of an array of one, that.
void readRows(vtkDataArray* array, const std::vector<vtkIdType>& rows, std::int64_t count,
  int component, bool needsAll, double* values)
{
  component = array->GetNumberOfComponents() == 1 ? 0 : component;
  const BoxReader readBox;
  if (!vtkArrayDispatch::Dispatch::Execute(
        array, readBox, rows, count, component, needsAll, values))
  {
    readBox(array, rows, count, component, needsAll, values);
  }
}
}

AMRCellSource::AMRCellSource(const AMRInput& input, int component)
  : Component(component)
  , FirstComponent(component)
  , Sources(input.grids.size())
{
  for (std::size_t b = 0; b < input.grids.size(); ++b)
  {
    vtkImageData* grid = input.grids[b];
    Source& source = this->Sources[b];
    int points[3];
    grid->GetDimensions(points);
    source.first = input.hierarchy.blocks[b].cells.lo - input.offsets[b];
    if (input.onPoints)
    {
      source.gridCells = Int3(points[0], points[1], points[2]);
      // Of a block alone duplicates are another process's points.
      source.hidden = vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT;
      source.ghosts = findGhosts(grid->GetPointData(), grid->GetNumberOfPoints(), source.hidden);
      continue;
    }
    source.gridCells = Int3(points[0] - 1, points[1] - 1, points[2] - 1);
    source.hidden = vtkDataSetAttributes::HIDDENCELL;
    source.pointGhosts = findGhosts(
      grid->GetPointData(), grid->GetNumberOfPoints(), vtkDataSetAttributes::HIDDENPOINT);
    source.ghosts = findGhosts(grid->GetCellData(), grid->GetNumberOfCells(), AnyGhost);
    if (source.ghosts)
    {
      const Box& cells = input.hierarchy.blocks[b].cells;
      this->ForEachRow(source, cells,
        [&](vtkIdType first, std::int64_t count)
        {
          source.hasDuplicates = source.hasDuplicates ||
            std::any_of(source.ghosts + first, source.ghosts + first + count,
              [](unsigned char ghost) { return ghost & vtkDataSetAttributes::DUPLICATECELL; });
        });
    }
  }
}

void AMRCellSource::selectOfAll(int component)
{
  this->Component = component;
  this->NeedsAll = true;
}

void AMRCellSource::setWholeRanges(std::vector<std::optional<Range>> ranges)
{
  this->WholeRanges = std::move(ranges);
}

std::optional<Range> AMRCellSource::wholeRange() const
{
  // One component alone is that which was asked for.
  const std::size_t component = this->NeedsAll ? static_cast<std::size_t>(this->Component) : 0;
  return component < this->WholeRanges.size() ? this->WholeRanges[component] : std::nullopt;
}

void AMRCellSource::setArray(int block, vtkDataArray* array)
{
  this->Sources[block].array = readableByThreads(array);
}

void AMRCellSource::setSecondArray(int block, vtkDataArray* array, int component)
{
  this->Sources[block].second = readableByThreads(array);
  this->SecondComponent = component;
}

template <typename Visitor>
void AMRCellSource::ForEachRow(const Source& source, const Box& cells, Visitor&& visit) const
{
  const Int3 n = source.gridCells;
  for (std::int64_t z = cells.lo.z; z < cells.hi.z; ++z)
  {
    for (std::int64_t y = cells.lo.y; y < cells.hi.y; ++y)
    {
      const Int3 at = Int3(cells.lo.x, y, z) - source.first;
      visit(static_cast<vtkIdType>(at.x + n.x * (at.y + n.y * at.z)), cells.size().x);
    }
  }
}

void AMRCellSource::read(int block, const Box& cells, double* values) const
{
  const Source& source = this->Sources[block];
  std::vector<vtkIdType> rows;
  rows.reserve(static_cast<std::size_t>(cells.size().y * cells.size().z));
  this->ForEachRow(source, cells, [&](vtkIdType first, std::int64_t) { rows.push_back(first); });
  const std::int64_t count = cells.size().x;
  if (this->NeedsAll && source.second)
  {
    const bool isSecond = this->Component == 1;
    std::vector<double> others(rows.size() * static_cast<std::size_t>(count));
    readRows(
      source.array, rows, count, this->FirstComponent, false, isSecond ? others.data() : values);
    readRows(
      source.second, rows, count, this->SecondComponent, false, isSecond ? values : others.data());
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      values[i] = std::isfinite(others[i]) ? values[i] : std::numeric_limits<double>::quiet_NaN();
    }
  }
  else
  {
    readRows(source.array, rows, count, this->Component, this->NeedsAll, values);
  }
  // Of all values that are none, this one is for hidden cells.
  std::replace(values, values + rows.size() * static_cast<std::size_t>(count), HiddenValue,
    std::numeric_limits<double>::quiet_NaN());
  if (source.pointGhosts)
  {
    this->HideCellsOfHiddenPoints(source, cells, values);
  }
  if (source.ghosts)
  {
    for (const vtkIdType row : rows)
    {
      for (std::int64_t i = 0; i < count; ++i, ++values)
      {
        if (source.ghosts[row + i] & source.hidden)
        {
          *values = HiddenValue;
        }
      }
    }
  }
}

void AMRCellSource::HideCellsOfHiddenPoints(
  const Source& source, const Box& cells, double* values) const
{
  const HiddenCorners corners(source.pointGhosts, source.gridCells + Int3(1));
  for (std::int64_t z = cells.lo.z; z < cells.hi.z; ++z)
  {
    for (std::int64_t y = cells.lo.y; y < cells.hi.y; ++y)
    {
      for (std::int64_t x = cells.lo.x; x < cells.hi.x; ++x, ++values)
      {
        if (corners.hide(Int3(x, y, z) - source.first))
        {
          *values = HiddenValue;
        }
      }
    }
  }
}

bool AMRCellSource::hasDuplicates(int block) const { return this->Sources[block].hasDuplicates; }

void AMRCellSource::readDuplicates(int block, const Box& cells, unsigned char* duplicate) const
{
  const Source& source = this->Sources[block];
  this->ForEachRow(source, cells,
    [&](vtkIdType first, std::int64_t count)
    {
      for (std::int64_t i = 0; i < count; ++i)
      {
        *duplicate++ = (source.ghosts[first + i] & vtkDataSetAttributes::DUPLICATECELL) != 0;
      }
    });
}
}
