// SPDX-License-Identifier: BSD-3-Clause
// A range of levels: without fine ones, coarse cells below them show; without coarse ones, there is
// nothing beside the fine blocks.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksPicker.h"

int TestLevelRange(int, char*[])
{
  test::Checks checks;
  test::Messages messages;
  // Three levels, each in the lower corner of the one before, with the level as value.
  auto amr = test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 8, 8 } }, { 1, { 0, 0, 0 }, { 8, 8, 8 } },
                             { 2, { 0, 0, 0 }, { 8, 8, 8 } } },
    test::constant(0.0));
  test::forEachGrid(amr,
    [](unsigned int level, vtkUniformGrid* grid)
    { test::addCells(grid, test::constant(static_cast<double>(level))); });
  test::Stage stage(amr, 80);
  vtkExaBricksVolumeMapper* mapper = stage.mapper;
  mapper->SetReconstructionToNearest();
  test::setConstantColor(stage.Property(), 1.0, { 0.2, 0.0, 0.0 });
  stage.Property()->GetRGBTransferFunction()->AddRGBPoint(2.0, 1.0, 0.0, 0.0);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  stage.renderer->GetActiveCamera()->SetPosition(4.0, 4.0, -80.0); // from below
  stage.renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
  stage.renderer->ResetCameraClippingRange();

  // At places of the finest, of the middle and of the coarsest level: x is to the left from below.
  const auto shows = [&](const std::array<double, 3>& levels, const std::string& what)
  {
    const test::Picture picture(stage.window);
    const int places[3] = { 70, 50, 10 };
    for (int i = 0; i < 3; ++i)
    {
      const double red = levels[i] < 0.0 ? 0.0 : 0.2 + 0.4 * levels[i];
      checks.Near(picture.At(places[i], 10)[0], red, test::OneStep, what);
    }
  };
  shows({ 2.0, 1.0, 0.0 }, "all levels");
  checks.Equal(mapper->GetBuilder()->GetOutput()->GetNumberOfLeafCells(),
    vtkIdType(512 - 64 + 512 - 64 + 512), "leaf cells of all levels");
  mapper->SetLevelRange(0, 1);
  shows({ 1.0, 1.0, 0.0 }, "without the finest");
  checks.Equal(mapper->GetBuilder()->GetOutput()->GetNumberOfLeafCells(), vtkIdType(512 - 64 + 512),
    "leaf cells without the finest");
  mapper->SetLevelRange(1, 2);
  shows({ 2.0, 1.0, -1.0 }, "without the coarsest");
  mapper->SetLevelRange(1, 1);
  shows({ 1.0, 1.0, -1.0 }, "the middle one");

  // Levels keep their numbers.
  vtkNew<vtkExaBricksPicker> picker;
  checks.Expect(picker->Pick(70, 10, 0.0, stage.renderer), "the middle one is picked");
  checks.Equal(picker->GetLevel(), 1, "picked level");
  mapper->SetLevelRange(2, 17);
  shows({ 2.0, -1.0, -1.0 }, "from the finest on");
  checks.Silent(messages.TakeErrors() + messages.TakeWarnings(), "nothing to say");
  mapper->SetLevelRange(3, 5);
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "levels that are not there");
  checks.Says(messages.TakeErrors(), { "from level 3 to 5", "3 levels", "SetLevelRange" },
    "levels that are not there");
  mapper->SetLevelRange(2, 1);
  test::Picture(stage.window);
  checks.Says(messages.TakeErrors(), { "2 to 1", "SetLevelRange" }, "an empty range");

  // A reader that has read the coarsest level alone tells the boxes of all: said once, unless it is
  // meant so.
  const std::vector<test::Block> blocks{ { 0, { 0, 0, 0 }, { 8, 8, 8 } },
    { 1, { 0, 0, 0 }, { 8, 8, 8 } }, { 2, { 0, 0, 0 }, { 8, 8, 8 } } };
  auto unread = test::makeNullBlocks(blocks);
  auto coarsest = test::makeGrid(blocks[0]);
  test::addCells(coarsest, test::constant(1.0));
  unread->SetDataSet(0, 0, coarsest);
  test::Stage meant(unread, 20);
  meant.mapper->SetLevelRange(0, 0);
  meant.window->Render();
  checks.Silent(messages.TakeWarnings(), "levels left out on purpose");
  meant.mapper->SetLevelRange(0, 9);
  meant.window->Render();
  checks.Says(messages.TakeWarnings(),
    { "Of 3 levels 1 was read, with 36 % of the cells", "SetMaxLevel(2)" }, "levels not read");
  meant.mapper->SetLevelRange(0, 8);
  meant.window->Render();
  checks.Silent(messages.TakeWarnings(), "once");
  return checks.Status();
}
