// SPDX-License-Identifier: BSD-3-Clause
// Run by mpiexec on three processes or more: what vtkExaBricksRedistribute hands out, keeps, and
// says.
#include "AMR.h"
#include "Checks.h"
#include "GreatestAllocation.h"
#include "Stage.h"

#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksRedistribute.h"

#include "vtkMPIController.h"

namespace
{
double slope(double x, double y, double z) { return x + 10.0 * y + 100.0 * z; }

// Sixteen blocks in a row, every second one refined: of each process its own, in turn.
vtkSmartPointer<vtkOverlappingAMR> deal(int rank, int ranks, const test::Field& field = slope)
{
  std::vector<test::Block> blocks;
  for (int i = 0; i < 16; ++i)
  {
    blocks.push_back({ 0, { 8 * i, 0, 0 }, { 8, 8, 8 } });
  }
  for (int i = 0; i < 16; i += 2)
  {
    blocks.push_back({ 1, { 16 * i + 4, 4, 4 }, { 8, 8, 8 } });
  }
  return test::keepBlocks(test::makeAMR(blocks, field),
    [=](unsigned int, unsigned int number) { return static_cast<int>(number) % ranks == rank; });
}

int countBlocks(vtkOverlappingAMR* amr)
{
  int count = 0;
  exabricks::forEachBlock(amr, [&](vtkDataSet*) { ++count; });
  return count;
}

vtkOverlappingAMR* outputOf(vtkExaBricksRedistribute* redistribute)
{
  return vtkOverlappingAMR::SafeDownCast(redistribute->GetOutputDataObject(0));
}

// What deal() gives each process, shared out.
vtkSmartPointer<vtkExaBricksRedistribute> redistributeDealt(vtkMPIController* controller)
{
  auto redistribute = vtkSmartPointer<vtkExaBricksRedistribute>::New();
  redistribute->SetController(controller);
  redistribute->SetInputData(
    deal(controller->GetLocalProcessId(), controller->GetNumberOfProcesses()));
  redistribute->Update();
  return redistribute;
}

// Cells have their values, wherever they come from; all are drawn, each by one process.
void checkCells(test::Checks& checks, vtkMPIController* controller)
{
  const auto redistribute = redistributeDealt(controller);
  vtkIdType wrong = 0;
  vtkIdType held = 0;
  exabricks::forEachBlock(outputOf(redistribute),
    [&](vtkDataSet* block)
    {
      vtkDataArray* values = block->GetCellData()->GetArray("value");
      for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
      {
        double bounds[6];
        block->GetCellBounds(cell, bounds);
        const double expected = slope(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
          0.5 * (bounds[4] + bounds[5]));
        wrong += std::abs(values->GetComponent(cell, 0) - expected) > 1e-9;
        ++held;
      }
    });
  checks.Equal(wrong, 0, "cells with another value");
  checks.Equal(redistribute->GetNumberOfCells(), held, "cells held");
  const vtkIdType own = redistribute->GetNumberOfCellsToDraw();
  checks.Expect(redistribute->GetBytesReceived() > 0, "some came from others");
  vtkIdType all = 0;
  controller->AllReduce(&own, &all, 1, vtkCommunicator::SUM_OP);
  const vtkIdType leaves = 16 * 512 - 8 * 64 + 8 * 512;
  checks.Equal(redistribute->GetNumberOfLeafCells(), leaves, "leaf cells");
  checks.Expect(std::abs(all - leaves) <= controller->GetNumberOfProcesses(), "all are drawn");
  checks.Expect(held >= own && held < leaves, "no process holds all cells");

  // Ranges are those of all, so that functions mean the same everywhere.
  vtkNew<vtkExaBricksBuilder> builder;
  builder->SetInputConnection(redistribute->GetOutputPort());
  builder->Update();
  double range[2];
  builder->GetOutput()->GetScalarRange(range);
  checks.Equal(range[0], slope(0.5, 0.5, 0.5), "least value of all processes");
  checks.Equal(range[1], slope(127.5, 7.5, 7.5), "greatest value of all processes");
}

// What hides cells travels with them, as marks of cells.
void checkHidden(test::Checks& checks, vtkMPIController* controller)
{
  auto input = deal(controller->GetLocalProcessId(), controller->GetNumberOfProcesses());
  if (controller->GetLocalProcessId() == 1)
  {
    vtkDataSet* const block = exabricks::getFirstBlock(input);
    block->AllocatePointGhostArray();
    const vtkIdType inside = 4 + 9 * (4 + 9 * 4); // of eight cells
    block->GetPointGhostArray()->SetValue(inside, vtkDataSetAttributes::HIDDENPOINT);
  }
  vtkNew<vtkExaBricksRedistribute> redistribute;
  redistribute->SetController(controller);
  redistribute->SetInputData(input);
  redistribute->Update();
  vtkNew<vtkExaBricksBuilder> builder;
  builder->SetInputConnection(redistribute->GetOutputPort());
  builder->Update();
  const vtkIdType own = builder->GetOutput()->GetNumberOfAbsentCells();
  vtkIdType all = 0;
  controller->AllReduce(&own, &all, 1, vtkCommunicator::MAX_OP);
  checks.Equal(all, 8, "cells of a hidden point, where they are drawn");
}

// Other values on the same boxes move, and nothing else is done anew.
void checkTimeSteps(test::Checks& checks, vtkMPIController* controller)
{
  vtkNew<vtkExaBricksRedistribute> redistribute;
  redistribute->SetController(controller);
  for (int step = 0; step < 4; ++step)
  {
    redistribute->SetInputData(deal(controller->GetLocalProcessId(),
      controller->GetNumberOfProcesses(), [=](double, double, double) { return 1.0 + step; }));
    redistribute->Update();
    checks.Equal(outputOf(redistribute)->GetNumberOfLevels(), 2u, "levels");
    vtkDataSet* block = exabricks::getFirstBlock(outputOf(redistribute));
    checks.Equal(block->GetCellData()->GetArray("value")->GetComponent(0, 0), 1.0 + step, "value");
  }
  checks.Equal(redistribute->GetNumberOfStructureBuilds(), 1, "builds of the structure");
}

// What a part cannot have alone is said.
void checkMessages(test::Checks& checks, vtkMPIController* controller)
{
  const auto redistribute = redistributeDealt(controller);
  test::KeepDisplay display;
  test::Stage stage(outputOf(redistribute));
  stage.Property()->GetScalarOpacity()->AddPoint(0.0, 0.5);
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  test::Messages messages;
  stage.window->Render();
  checks.Silent(messages.TakeWarnings(), "a plain part");
  stage.mapper->SetErrorTolerance(0.01);
  stage.window->Render();
  checks.Says(messages.TakeWarnings(), { "without ErrorTolerance" }, "a tolerance");
  stage.mapper->SetErrorTolerance(0.0);
  stage.mapper->SetReconstructionToCompleted();
  stage.window->Render();
  checks.Says(messages.TakeWarnings(), { "SetForCompleted" }, "too few cells to complete");
  stage.mapper->SetReconstructionToBasis();
  stage.mapper->SetLevelRange(0, 0);
  stage.window->Render();
  checks.Says(
    messages.TakeErrors(), { "SetLevelRange() of the vtkExaBricksRedistribute" }, "levels");
  stage.mapper->SetLevelRange(0, VTK_INT_MAX);
  stage.mapper->SetBlendModeToMaximumIntensity();
  stage.window->Render();
  checks.Says(messages.TakeWarnings(), { "of its own part" }, "a maximum");
  checks.Silent(messages.TakeErrors(), "a part");
}

// What is wrong on one process is said once, with its number, and nobody waits for it.
void checkFaults(test::Checks& checks, vtkMPIController* controller)
{
  const int rank = controller->GetLocalProcessId();
  const int ranks = controller->GetNumberOfProcesses();
  test::Messages messages;
  vtkNew<vtkExaBricksRedistribute> redistribute;
  redistribute->SetController(controller);
  const auto expect = [&](const std::vector<std::string>& words, const std::string& what)
  {
    redistribute->Update();
    checks.Equal(countBlocks(outputOf(redistribute)), 0, what + ": blocks");
    const std::string said = messages.TakeErrors();
    rank == 0 ? checks.Says(said, words, what) : checks.Silent(said, what);
  };

  auto lacking = deal(rank, ranks);
  if (rank == 2)
  {
    exabricks::getFirstBlock(lacking)->GetCellData()->RemoveArray("value");
  }
  redistribute->SetInputData(lacking);
  expect({ "process 2 of " + std::to_string(ranks), "a cell array 'value'" }, "a missing array");

  auto odd = deal(rank, ranks);
  if (rank == 1)
  {
    odd = test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 8, 8 } } }, slope, { {}, { 1.5, 1.5, 1.5 } });
  }
  redistribute->SetInputData(odd);
  expect({ "process 1 of " + std::to_string(ranks), "spacing" }, "another spacing");

  // A process may have no input at all; others that have arrays beside draw those that all have.
  auto more = deal(rank, ranks);
  test::forEachGrid(more,
    [&](unsigned int, vtkUniformGrid* grid)
    {
      if (rank == 0)
      {
        vtkNew<vtkDoubleArray> beside;
        beside->SetName("beside");
        beside->SetNumberOfTuples(grid->GetNumberOfCells());
        beside->Fill(1.0);
        grid->GetCellData()->AddArray(beside);
      }
    });
  redistribute->SetInputDataObject(rank == 1 ? nullptr : more.Get());
  redistribute->Update();
  checks.Silent(messages.TakeErrors(), "a process without an input");
  vtkDataSet* const block = exabricks::getFirstBlock(outputOf(redistribute));
  checks.Expect(
    block && block->GetCellData()->HasArray("value") && !block->GetCellData()->HasArray("beside"),
    "the array that all have");

  // Coarse levels alone.
  redistribute->SetInputData(deal(rank, ranks));
  redistribute->SetLevelRange(0, 0);
  redistribute->Update();
  checks.Equal(redistribute->GetNumberOfLeafCells(), 16 * 512, "cells of level 0");
  redistribute->SetLevelRange(0, VTK_INT_MAX);

  // Without any blocks there is nothing, and nothing to say.
  redistribute->SetInputData(test::makeNullBlocks({ { 0, { 0, 0, 0 }, { 8, 8, 8 } } }));
  redistribute->Update();
  checks.Equal(countBlocks(outputOf(redistribute)), 0, "blocks of nothing");
  checks.Silent(messages.TakeErrors(), "nothing to share out");

  redistribute->SetInputData(deal(rank, ranks));
  redistribute->Update();
  checks.Expect(countBlocks(outputOf(redistribute)) > 0, "all is well again");
  checks.Silent(messages.TakeErrors(), "all is well again");

  // An AMR that is not shared out is drawn, and that is said.
  test::KeepDisplay display;
  vtkMultiProcessController::SetGlobalController(controller);
  test::Stage stage(deal(rank, ranks));
  stage.Property()->GetScalarOpacity()->AddPoint(0.0, 0.5);
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  stage.window->Render();
  checks.Says(
    messages.TakeWarnings(), { "vtkExaBricksRedistribute" }, "an AMR that is not shared out");

  // A process that cannot draw says so with its number, and the others draw theirs.
  redistribute->Update();
  test::Stage part(outputOf(redistribute));
  part.Property()->GetScalarOpacity()->AddPoint(0.0, 0.5);
  part.Property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  if (rank == 2)
  {
    part.mapper->SetDevice("abacus");
  }
  part.window->Render();
  checks.Equal(part.mapper->GetDrawn(), rank != 2, "a process without a device");
  const std::string said = messages.TakeErrors();
  rank == 2
    ? checks.Says(said, { "process 2 of " + std::to_string(ranks), "abacus" }, "without a device")
    : checks.Silent(said, "those with one");
  vtkMultiProcessController::SetGlobalController(nullptr);
}

// A process runs out of memory while the AMR is shared out, and then while its part is made ready:
// the others do not wait for it, and all is well when there is memory again.
void checkMemory(test::Checks& checks, vtkMPIController* controller)
{
  const int rank = controller->GetLocalProcessId();
  const int ranks = controller->GetNumberOfProcesses();
  const std::size_t little = 4096; // bytes: less than what comes from any other process
  test::Messages messages;
  const auto memory = [&]
  {
    return rank == 2 ? std::make_unique<test::GreatestAllocation>(little)
                     : std::make_unique<test::GreatestAllocation>();
  };
  vtkNew<vtkExaBricksRedistribute> redistribute;
  redistribute->SetController(controller);
  redistribute->SetInputData(deal(rank, ranks));
  {
    const auto limit = memory();
    redistribute->Update();
  }
  checks.Equal(countBlocks(outputOf(redistribute)), 0, "blocks without memory");
  const std::string said = messages.TakeErrors();
  const std::vector<std::string> words{ "process 2 of " + std::to_string(ranks), "out of memory" };
  rank == 0 ? checks.Says(said, words, "without memory") : checks.Silent(said, "without memory");
  redistribute->Modified();
  redistribute->Update();
  checks.Expect(countBlocks(outputOf(redistribute)) > 0, "with memory again");

  test::KeepDisplay display;
  vtkMultiProcessController::SetGlobalController(controller);
  test::Stage part(outputOf(redistribute));
  part.Property()->GetScalarOpacity()->AddPoint(0.0, 0.5);
  part.Property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  {
    // Drivers of OpenGL do not expect to be without memory: the rest of a picture has it.
    const auto limit = memory();
    part.mapper->Update();
  }
  const std::string saidOfPart = messages.TakeErrors();
  rank == 2 ? checks.Says(saidOfPart, { "memory" }, "a part without memory")
            : checks.Silent(saidOfPart, "parts with memory");
  part.mapper->Modified();
  part.window->Render();
  checks.Expect(part.mapper->GetDrawn(), "a part with memory again");
  checks.Silent(messages.TakeErrors(), "with memory again");
  vtkMultiProcessController::SetGlobalController(nullptr);
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  int status = EXIT_FAILURE;
  {
    test::Checks checks;
    checks.Expect(controller->GetNumberOfProcesses() >= 3, "run by mpiexec -n 3 or more");
    checkCells(checks, controller);
    checkHidden(checks, controller);
    checkTimeSteps(checks, controller);
    checkMessages(checks, controller);
    checkFaults(checks, controller);
    checkMemory(checks, controller);
    status = checks.Status();
  }
  int worst = EXIT_SUCCESS;
  controller->AllReduce(&status, &worst, 1, vtkCommunicator::MAX_OP);
  controller->Finalize();
  return worst;
}
