// SPDX-License-Identifier: BSD-3-Clause
// Input that cannot be drawn: each time one clear error, which says what was expected and what was
// found, nothing of the volume is drawn, and the rest of the scene is.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTrivialProducer.h"

#include <limits>
#ifdef EXABRICKS_AMR_OF_VTK_9_6
#include "vtkDoubleArray.h"
#include "vtkRectilinearGrid.h"
#endif

namespace
{
// A stage with a red square behind the volume.
struct Scene
{
  test::Checks& checks;
  test::Stage stage;
  test::Messages messages;
  vtkNew<vtkPlaneSource> plane;

  explicit Scene(test::Checks& checksOfTest)
    : checks(checksOfTest)
    , stage(50)
  {
    this->plane->SetOrigin(0.0, 0.0, -1.0);
    this->plane->SetPoint1(8.0, 0.0, -1.0);
    this->plane->SetPoint2(0.0, 8.0, -1.0);
    vtkNew<vtkPolyDataMapper> planeMapper;
    planeMapper->SetInputConnection(this->plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(planeMapper);
    actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    actor->GetProperty()->LightingOff();
    this->stage.renderer->AddActor(actor);
    test::setConstantColor(this->stage.Property(), 1.0, { 0.0, 1.0, 0.0 });
    vtkCamera* camera = this->stage.renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(4.0);
    camera->SetFocalPoint(4.0, 4.0, 0.0);
    camera->SetPosition(4.0, 4.0, 100.0);
    camera->SetClippingRange(1.0, 200.0);
  }

  // Two pictures show the square only. The error has `words` in it.
  void Fails(const std::vector<std::string>& words, const std::string& what)
  {
    const test::Picture picture(this->stage.window);
    const auto color = picture.Center();
    this->checks.Expect(
      color[0] == 1.0 && color[1] == 0.0, what + ": only the square is to be seen");
    this->checks.Expect(!this->stage.mapper->GetDrawn(), what + ": the mapper tells so");
    this->checks.Equal(this->messages.Errors().size(), 1, what + ": number of errors");
    this->checks.Says(this->messages.TakeErrors(), words, what);
    this->checks.Expect(test::Picture(this->stage.window).Center()[1] == 0.0,
      what + ": only the square is to be seen once more");
    this->checks.Silent(this->messages.TakeErrors(), what + ": said again");
  }

  void Fails(vtkOverlappingAMR* amr, const std::vector<std::string>& words, const std::string& what)
  {
    this->stage.mapper->SetInputData(amr);
    this->Fails(words, what);
  }

  // Good input is drawn after all that.
  void Works(const std::string& what)
  {
    this->checks.Expect(
      test::Picture(this->stage.window).Center()[1] == 1.0, what + ": is drawn again");
    this->checks.Expect(this->stage.mapper->GetDrawn(), what + ": the mapper tells so");
    this->checks.Silent(this->messages.TakeErrors(), what + ": no error");
  }
};

void addGrid(vtkOverlappingAMR* amr, const test::Block& block, const test::Lattice& lattice = {})
{
  auto grid = test::makeGrid(block, lattice);
  test::addCells(grid, test::constant(1.0));
  amr->SetDataSet(block.level, 0, grid);
}
}

int TestBadInput(int, char*[])
{
  test::Checks checks;
  Scene scene(checks);
  vtkExaBricksVolumeMapper* mapper = scene.stage.mapper;
  const auto blocks = test::cornerRefined();

  scene.Fails({ "found none", "SetInputConnection" }, "no input");
  scene.Fails(vtkSmartPointer<vtkOverlappingAMR>::New(), { "at least one block", "found none" },
    "an AMR never initialised");
  scene.Fails(test::makeNullBlocks(blocks), { "at least one block", "found none" }, "null blocks");

  // A reader that has nothing yet.
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(vtkNew<vtkOverlappingAMR>());
  mapper->SetInputConnection(producer->GetOutputPort());
  scene.Fails({ "at least one block" }, "a pipeline without data");

  auto flatGrid = vtkSmartPointer<vtkUniformGrid>::New();
  flatGrid->SetDimensions(9, 9, 1);
  vtkNew<vtkDoubleArray> flatValues;
  flatValues->SetNumberOfTuples(64);
  flatGrid->GetCellData()->SetScalars(flatValues);
#ifdef EXABRICKS_AMR_OF_VTK_9_6
  const int plane = vtkStructuredData::VTK_STRUCTURED_XY_PLANE;
#else
  const int plane = VTK_XY_PLANE;
#endif
  auto flat = test::makeNullBlocks({ { 0, { 0, 0, 0 }, { 8, 8, 1 } } }, {}, plane);
  flat->SetDataSet(0, 0, flatGrid);
  scene.Fails(flat, { "3-D AMR", "9 x 9 x 1 points" }, "a 2-D AMR");

  // Arrays: the message lists those that there are.
  auto good = test::makeAMR(blocks, test::constant(1.0));
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray("pressure");
  scene.Fails(good, { "'pressure'", "'value'" }, "a missing array");
  mapper->SelectScalarArray(0);
  scene.Works("the first array");
  mapper->SelectScalarArray(3);
  scene.Fails({ "from 0 to 0", "found 3" }, "a missing array by number");
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("value");
  scene.Fails({ "'value'" }, "a cell array as points");
  mapper->SetScalarModeToDefault();
  auto inactive = test::makeAMR(blocks, test::constant(1.0));
  test::forEachGrid(inactive,
    [](unsigned int, vtkUniformGrid* grid) { grid->GetCellData()->SetActiveScalars(nullptr); });
  scene.Fails(inactive, { "active scalars", "'value'" }, "no active scalars");
  auto oneWithout = test::makeAMR(blocks, test::constant(1.0));
  test::forEachGrid(oneWithout,
    [](unsigned int level, vtkUniformGrid* grid)
    {
      if (level == 1)
      {
        grid->GetCellData()->Initialize();
      }
    });
  scene.Fails(
    oneWithout, { "in every block", "no arrays", "level 1" }, "an array of some blocks only");
  auto vectors = test::makeAMR(blocks, test::constant(1.0));
  test::forEachGrid(vectors,
    [](unsigned int, vtkUniformGrid* grid)
    {
      vtkNew<vtkDoubleArray> three;
      three->SetName("velocity");
      three->SetNumberOfComponents(3);
      three->SetNumberOfTuples(grid->GetNumberOfCells());
      three->FillValue(1.0);
      grid->GetCellData()->AddArray(three);
      grid->GetCellData()->SetActiveScalars("velocity");
    });
  mapper->SetVectorModeToComponent();
  mapper->SetVectorComponent(3);
  scene.Fails(vectors, { "'velocity'", "below 3", "3" }, "a component out of range");
  mapper->SetVectorComponent(2);
  scene.Works("a component in range");
  scene.stage.Property()->IndependentComponentsOff();
  scene.Works("one of dependent components");
  mapper->SetVectorModeToDisabled();
  scene.Fails({ "2 or 4 dependent components", "found 3" }, "dependent components");
  mapper->SetVectorModeToComponent();
  scene.stage.Property()->IndependentComponentsOn();
  scene.stage.Property()->SetScalarOpacityUnitDistance(0.0);
  scene.Fails({ "ScalarOpacityUnitDistance", "found 0" }, "no unit distance");
  scene.stage.Property()->SetScalarOpacityUnitDistance(1.0);
  mapper->SetStepScale(std::nan(""));
  scene.Fails({ "StepScale", "nan" }, "a step that is no number");
  mapper->SetStepScale(1.0);
  scene.Works("values in range");

  // Arrays of another length than the grid: nothing is read past their end.
  auto tooShort = test::makeAMR(blocks, test::constant(1.0));
  test::forEachGrid(tooShort,
    [](unsigned int, vtkUniformGrid* grid)
    {
      grid->GetCellData()->Initialize();
      vtkNew<vtkDoubleArray> three;
      three->SetName("three");
      three->SetNumberOfTuples(3);
      three->FillValue(1.0);
      grid->GetCellData()->SetScalars(three);
    });
  scene.Fails(tooShort, { "at least 512 values", "'three'", "found 3" }, "a short array");
  // One that is too long has a value for each cell, as for VTK's mappers.
  auto tooLong = test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 8, 8 } } }, test::constant(1.0));
  test::forEachGrid(tooLong,
    [](unsigned int, vtkUniformGrid* grid)
    { grid->GetCellData()->GetArray(0)->InsertNextTuple1(7.0); });
  mapper->SetInputData(tooLong);
  scene.Works("a long array");
  checks.Equal(mapper->GetBuilder()->GetOutput()->GetNumberOfLeafCells(), 512, "its cells");

  auto turned = test::makeAMR({ { 0, { 0, 0, 0 }, { 8, 8, 8 } } }, test::constant(1.0));
  test::forEachGrid(turned,
    [](unsigned int, vtkUniformGrid* grid)
    { grid->SetDirectionMatrix(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0); });
  scene.Fails(turned, { "along the axes", "turned", "SetUserMatrix" }, "a turned grid");

  // An array without a name is as good as any.
  auto unnamed = test::makeAMR(blocks, test::constant(1.0));
  test::forEachGrid(unnamed,
    [](unsigned int, vtkUniformGrid* grid)
    {
      grid->GetCellData()->Initialize();
      vtkNew<vtkDoubleArray> points;
      points->SetNumberOfTuples(grid->GetNumberOfPoints());
      points->FillValue(1.0);
      grid->GetPointData()->SetScalars(points);
    });
  mapper->SetInputData(unnamed);
  scene.Works("an unnamed point array");

  // Lattices: ratios that are not whole, that differ between axes, and grids beside the lattice.
  auto half = test::makeNullBlocks(blocks);
  addGrid(half, blocks[0]);
  const double odd[3] = { 0.4, 0.4, 0.4 };
  half->SetSpacing(1, odd);
  addGrid(half, blocks[1], { { 0.0, 0.0, 0.0 }, { 0.8, 0.8, 0.8 } });
  scene.Fails(half, { "whole refinement ratio", "0.4", "level 1" }, "a ratio of 2.5");
  auto skewed = test::makeNullBlocks(blocks);
  addGrid(skewed, blocks[0]);
  const double uneven[3] = { 0.5, 0.5, 0.25 };
  skewed->SetSpacing(1, uneven);
  addGrid(skewed, blocks[1], { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.5 } });
  scene.Fails(skewed, { "same whole refinement ratio", "0.25" }, "a ratio of 2, 2, 4");
  // Levels whose cells would be too many finest cells wide for any integer, at once and as a
  // product of ratios.
  const std::vector<std::pair<int, std::string>> ratios{ { 62, "4.61168601842739e+18" },
    { 64, "1.84467440737096e+19" }, { 200, "1.60693804425899e+60" } };
  for (const auto& ratio : ratios)
  {
    auto wide = test::makeNullBlocks(blocks);
    addGrid(wide, blocks[0]);
    const double tiny = std::ldexp(1.0, -ratio.first);
    const double spacing[3] = { tiny, tiny, tiny };
    wide->SetSpacing(1, spacing);
    addGrid(wide, blocks[1], { {}, { 2.0 * tiny, 2.0 * tiny, 2.0 * tiny } });
    scene.Fails(wide,
      { "less than 2^30 finest cells", "ratio of " + ratio.second + " between levels 0 and 1" },
      "a ratio of 2^" + std::to_string(ratio.first));
  }
  const std::vector<test::Block> four{ blocks[0], blocks[1], { 2, { 0, 0, 0 }, { 8, 8, 8 } },
    { 3, { 0, 0, 0 }, { 8, 8, 8 } } };
  const test::Lattice steep{ {}, { 1.0, 1.0, 1.0 }, 2, { 1 << 21, 1 << 21, 1 << 21 } };
  scene.Fails(test::makeAMR(four, test::constant(1.0), steep),
    { "less than 2^30 finest cells", "ratio of 2097152 between levels 1 and 2",
      "whose cells are 2097152 finest cells" },
    "a product of ratios of 2^63");
  auto beside = test::makeNullBlocks(blocks);
  addGrid(beside, blocks[0]);
  addGrid(beside, blocks[1], { { 0.2, 0.0, 0.0 } });
  scene.Fails(beside, { "block 0 of level 1", "lattice" }, "a grid beside the lattice");
  auto small = test::makeNullBlocks(blocks);
  addGrid(small, { 0, { 0, 0, 0 }, { 8, 8, 7 } });
  scene.Fails(small, { "8 x 8 x 8 cells", "8 x 8 x 7 cells" }, "a grid smaller than its box");

#ifdef EXABRICKS_AMR_OF_VTK_9_6
  auto stretched = test::makeNullBlocks({ blocks[0] });
  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(9, 9, 9);
  vtkNew<vtkDoubleArray> coordinates;
  for (int i = 0; i < 9; ++i)
  {
    coordinates->InsertNextValue(i);
  }
  rectilinear->SetXCoordinates(coordinates);
  rectilinear->SetYCoordinates(coordinates);
  rectilinear->SetZCoordinates(coordinates);
  stretched->SetDataSet(0, 0, rectilinear);
  scene.Fails(stretched, { "uniform spacing", "vtkRectilinearGrid" }, "a rectilinear block");
#endif

  mapper->SetInputData(good);
  scene.Works("good input");

  // Boxes at the last cells that an AMR can number: the origin is as far away on the other side.
  constexpr int far = std::numeric_limits<int>::max() - 7;
  mapper->SetInputData(test::makeAMR({ { 0, { far, far, far }, { 8, 8, 8 } } }, test::constant(1.0),
    { { -double(far), -double(far), -double(far) } }));
  scene.Works("boxes near the largest int");

  // All cells absent: no fault, but nothing to see.
  mapper->SetInputData(test::makeAMR(blocks, test::constant(std::nan(""))));
  checks.Expect(
    test::Picture(scene.stage.window).Center()[1] == 0.0, "nothing but NaN draws nothing");
  checks.Expect(scene.messages.Errors().empty(), "nothing but NaN is no error");
  double range[2];
  mapper->GetBuilder()->GetOutput()->GetScalarRange(range);
  checks.Expect(range[0] > range[1], "nothing but NaN has an empty range");
  return checks.Status();
}
