// SPDX-License-Identifier: BSD-3-Clause
// The builder by itself: what it counts, when it builds bricks anew, how it reports progress and
// how it is aborted, and bricks and regions as VTK cells.

#include "AMR.h"
#include "Checks.h"

#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnstructuredGrid.h"

#include <atomic>
#include <new>
#include <stdexcept>

namespace
{
const test::Lattice lattice{ { -1.0, 2.0, 10.0 }, { 0.5, 1.0, 2.0 }, 4 };
const std::vector<test::Block> blocks{ { 0, { 0, 0, 0 }, { 8, 8, 8 } },
  { 0, { 8, 0, 0 }, { 4, 8, 8 } }, { 1, { 4, 8, 0 }, { 16, 12, 8 } } };
constexpr double DomainVolume = 12 * 8 * 8; // of which cells have 1.0

double ramp(double x, double, double) { return x; }

void checkCounts(test::Checks& checks)
{
  vtkNew<vtkExaBricksBuilder> builder;
  builder->SetInputDataObject(test::makeAMR(blocks, ramp, lattice));
  builder->Update();
  vtkExaBricksData* data = builder->GetOutput();
  checks.Equal(data->GetNumberOfLevels(), 2, "levels");
  checks.Equal(data->GetNumberOfBlocks(), 3, "blocks");
  checks.Equal(data->GetNumberOfLeafCells(), 12 * 8 * 8 - 4 * 3 * 2 + 16 * 12 * 8, "leaf cells");
  checks.Expect(data->GetNumberOfBricks() >= 2, "bricks");
  checks.Expect(data->GetNumberOfRegions() >= data->GetNumberOfBricks(), "regions");
  checks.Expect(data->GetActualMemorySize() > 0, "memory");
  checks.Expect(data->GetArrayName() == std::string("value"), "name of the array");
  double bounds[6];
  data->GetBounds(bounds);
  const double expected[6] = { -1.0, 5.0, 2.0, 10.0, 10.0, 26.0 };
  double spacing[3];
  data->GetFinestSpacing(spacing);
  for (int i = 0; i < 6; ++i)
  {
    checks.Near(bounds[i], expected[i], 1e-12, "bound " + std::to_string(i));
    checks.Near(spacing[i / 2], lattice.spacing[i / 2] / 4.0, 1e-12, "finest spacing");
  }

  // A copy shares what it holds.
  vtkNew<vtkExaBricksData> copy;
  copy->DeepCopy(data);
  data->Initialize();
  checks.Equal(data->GetNumberOfBricks(), 0, "bricks of data let go");
  checks.Expect(copy->GetNumberOfBricks() >= 2, "bricks of the copy");
}

// Time steps and other arrays on the same boxes keep bricks and regions.
void checkStructureIsKept(test::Checks& checks)
{
  vtkNew<vtkExaBricksBuilder> builder;
  const auto show = [&](const std::vector<test::Block>& boxes, const test::Field& field,
                      const test::Lattice& place, int builds, const std::string& what)
  {
    builder->SetInputDataObject(test::makeAMR(boxes, field, place));
    builder->Update();
    checks.Equal(builder->GetNumberOfStructureBuilds(), builds, what);
    checks.Expect((builder->GetOutput()->GetStructureTime() == 0.0) == (what.find("kept") == 0),
      what + ": structure time");
  };
  show(blocks, ramp, lattice, 1, "first build");
  show(blocks, test::constant(1.0), lattice, 1, "kept for the next time step");
  double range[2];
  builder->GetOutput()->GetScalarRange(range);
  checks.Equal(range[1], 1.0, "values of the next time step");
  builder->SetVectorModeToComponent();
  builder->Update();
  checks.Equal(builder->GetNumberOfStructureBuilds(), 1, "kept for another vector mode");
  auto moved = blocks;
  moved[2].first[1] = 4;
  show(moved, ramp, lattice, 2, "built for a moved block");
  moved.pop_back();
  show(moved, ramp, lattice, 3, "built for a missing block");
  builder->Update();
  checks.Equal(builder->GetNumberOfStructureBuilds(), 3, "nothing new, nothing built");
}

// An array whose values cannot be had, as if there were no memory to read them. Of a kind that is
// read through virtual functions, and so through this one.
class FailingArray : public vtkSOADataArrayTemplate<double>
{
public:
  static FailingArray* New();
  vtkTypeMacro(FailingArray, vtkSOADataArrayTemplate<double>);

  enum class Fault
  {
    None,
    NoMemory,
    Other
  };
  std::atomic<Fault> Now{ Fault::None };

  double GetComponent(vtkIdType tuple, int component) override
  {
    switch (this->Now)
    {
      case Fault::NoMemory:
        throw std::bad_alloc();
      case Fault::Other:
        throw std::runtime_error("this array is broken");
      default:
        return this->vtkSOADataArrayTemplate<double>::GetComponent(tuple, component);
    }
  }
};
vtkStandardNewMacro(FailingArray);

// What is thrown on the threads that read the values comes back as an error with an empty output,
// and once there is memory the next Update() works.
void checkExceptions(test::Checks& checks)
{
  constexpr int side = 64; // cells enough for several threads
  const test::Block block{ 0, { 0, 0, 0 }, { side, side, side } };
  auto amr = test::makeNullBlocks({ block });
  auto grid = test::makeGrid(block);
  vtkNew<FailingArray> array;
  array->SetName("failing");
  array->SetNumberOfComponents(1);
  array->SetNumberOfTuples(side * side * side);
  array->FillComponent(0, 1.0);
  grid->GetCellData()->SetScalars(array);
  amr->SetDataSet(0, 0, grid);

  test::Messages messages;
  vtkNew<vtkExaBricksBuilder> builder;
  builder->SetInputDataObject(amr);
  array->Now = FailingArray::Fault::NoMemory;
  builder->Update();
  checks.Equal(messages.Errors().size(), 1, "errors without memory");
  checks.Says(messages.TakeErrors(),
    { "Out of memory on the host", "262144 cells", "1048576 bytes", "Read fewer levels" },
    "without memory");
  checks.Equal(builder->GetOutput()->GetNumberOfLeafCells(), 0, "leaf cells without memory");
  checks.Equal(builder->GetOutput()->GetNumberOfBricks(), 0, "bricks without memory");
  builder->Update();
  checks.Silent(messages.TakeErrors(), "it is said once");
  array->Now = FailingArray::Fault::None;
  builder->Update();
  checks.Silent(messages.TakeErrors(), "with memory");
  checks.Equal(
    builder->GetOutput()->GetNumberOfLeafCells(), side * side * side, "leaf cells with memory");

  array->Now = FailingArray::Fault::Other;
  builder->Modified();
  builder->Update();
  checks.Says(messages.TakeErrors(), { "this array is broken" }, "another exception");
  checks.Equal(builder->GetOutput()->GetNumberOfLeafCells(), 0, "leaf cells of a broken array");
  array->Now = FailingArray::Fault::None;
  builder->Modified();
  builder->Update();
  checks.Silent(messages.TakeErrors(), "with a whole array");
  checks.Equal(
    builder->GetOutput()->GetNumberOfLeafCells(), side * side * side, "leaf cells in the end");
}

struct Watch
{
  std::vector<double> progress;
  double abortAt = 2.0;

  static void Follow(vtkObject* caller, unsigned long, void* self, void* amount)
  {
    Watch* watch = static_cast<Watch*>(self);
    watch->progress.push_back(*static_cast<double*>(amount));
    if (watch->progress.back() >= watch->abortAt)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }
};

void checkProgressAndAbort(test::Checks& checks)
{
  const std::vector<test::Block> many{ { 0, { 0, 0, 0 }, { 64, 64, 64 } },
    { 1, { 32, 32, 32 }, { 64, 64, 64 } } };
  auto amr = test::makeAMR(many, ramp);
  Watch watch;
  vtkNew<vtkCallbackCommand> follow;
  follow->SetCallback(Watch::Follow);
  follow->SetClientData(&watch);
  vtkNew<vtkExaBricksBuilder> builder;
  builder->AddObserver(vtkCommand::ProgressEvent, follow);
  builder->SetInputDataObject(amr);
  builder->Update();
  checks.Expect(watch.progress.size() > 4, "progress is reported more than four times");
  for (std::size_t i = 0; i < watch.progress.size(); ++i)
  {
    checks.Expect(watch.progress[i] >= 0.0 && watch.progress[i] <= 1.0 &&
        (i == 0 || watch.progress[i] >= watch.progress[i - 1]),
      "progress grows from 0 to 1, at " + std::to_string(watch.progress[i]));
  }
  checks.Expect(!watch.progress.empty() && watch.progress.back() == 1.0, "progress ends with 1");

  // Early, while bricks are built, and late, while values are read.
  for (const double when : { 0.05, 0.6 })
  {
    watch.progress.clear();
    watch.abortAt = when;
    vtkNew<vtkExaBricksBuilder> aborted;
    aborted->AddObserver(vtkCommand::ProgressEvent, follow);
    aborted->SetInputDataObject(amr);
    aborted->Update();
    checks.Equal(aborted->GetOutput()->GetNumberOfBricks(), 0,
      "bricks of a builder aborted at " + std::to_string(when));
    checks.Equal(aborted->GetOutput()->GetNumberOfLeafCells(), 0, "leaf cells of an aborted one");
    watch.abortAt = 2.0;
    aborted->SetAbortExecute(0);
    aborted->Update(); // the empty output does not count as up to date
    checks.Expect(aborted->GetOutput()->GetNumberOfBricks() > 0, "bricks of another try");
  }
}

double volumeOf(vtkUnstructuredGrid* cells)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    double b[6];
    cells->GetCellBounds(i, b);
    sum += (b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]);
  }
  return sum;
}

void checkCells(test::Checks& checks)
{
  vtkNew<vtkExaBricksBuilder> builder;
  builder->SetInputDataObject(test::makeAMR(blocks, ramp, lattice));
  builder->Update();
  vtkExaBricksData* data = builder->GetOutput();
  vtkNew<vtkUnstructuredGrid> bricks;
  data->GetBricksAsCells(bricks);
  checks.Equal(bricks->GetNumberOfCells(), data->GetNumberOfBricks(), "bricks as cells");
  checks.Near(volumeOf(bricks), DomainVolume, 1e-9, "volume of the bricks");
  double cellSum = 0.0;
  vtkDataArray* cells = bricks->GetCellData()->GetArray("Cells");
  for (vtkIdType i = 0; i < bricks->GetNumberOfCells(); ++i)
  {
    cellSum += cells->GetComponent(i, 0) * cells->GetComponent(i, 1) * cells->GetComponent(i, 2);
    // A ramp along x: the range of a brick is where it lies.
    double b[6];
    bricks->GetCellBounds(i, b);
    const double* range = bricks->GetCellData()->GetArray("Range")->GetTuple2(i);
    checks.Expect(range[0] > b[0] && range[1] < b[1], "range of brick " + std::to_string(i));
  }
  checks.Equal(cellSum, data->GetNumberOfLeafCells(), "cells of the bricks");
  checks.Equal(
    bricks->GetCellData()->GetArray("Level")->GetRange()[1], 1, "finest level of bricks");

  vtkNew<vtkUnstructuredGrid> regions;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(3.0, 0.0);
  opacity->AddPoint(5.0, 1.0);
  data->GetRegionsAsCells(regions, opacity);
  checks.Near(volumeOf(regions), DomainVolume, 1e-9, "volume of the regions");
  int active = 0;
  for (vtkIdType i = 0; i < regions->GetNumberOfCells(); ++i)
  {
    const double greatest = regions->GetCellData()->GetArray("Range")->GetTuple2(i)[1];
    const bool isActive = regions->GetCellData()->GetArray("Active")->GetTuple1(i) != 0.0;
    checks.Expect(isActive == (greatest > 3.0), "activity at " + std::to_string(greatest));
    checks.Expect(
      regions->GetCellData()->GetArray("BrickCount")->GetTuple1(i) >= 1.0, "brick count");
    active += isActive;
  }
  checks.Expect(active > 0 && active < regions->GetNumberOfCells(), "some regions are active");
  data->GetRegionsAsCells(regions);
  checks.Equal(regions->GetCellData()->GetArray("Active")->GetRange()[0], 1, "without a function");
}
}

int TestBuilder(int, char*[])
{
  test::Checks checks;
  checkExceptions(checks);
  checkCounts(checks);
  checkStructureIsKept(checks);
  checkProgressAndAbort(checks);
  checkCells(checks);
  return checks.Status();
}
