// SPDX-License-Identifier: BSD-3-Clause
// Stand-ins for the paper's models, from the source to a picture: each scene is drawn with its own
// view, the gear's surface hides what of the volume is behind it, and the builder finds the
// structure that the scene stands for.

#include "Adapters/AMRCompatibility.h"
#include "Checks.h"
#include "Core/Structure.h"
#include "Scenes/StandIn.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksSceneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkStringArray.h"

#include <array>

namespace
{
constexpr int Size = 96;

// Cells that are not marked as refined.
vtkIdType countLeafCells(vtkOverlappingAMR* amr)
{
  vtkIdType leafCells = 0;
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int index = 0; index < exabricks::numberOfBlocks(amr, level); ++index)
    {
      vtkDataSet* block = exabricks::getBlock(amr, level, index);
      vtkDataArray* marks = block->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
      for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
      {
        leafCells += marks->GetTuple1(cell) == 0.0;
      }
    }
  }
  return leafCells;
}

// The device of the last picture.
bool hasRayQuery(vtkExaBricksVolumeMapper* mapper)
{
  vtkNew<vtkStringArray> devices;
  vtkExaBricksVolumeMapper::GetDevices(devices);
  for (vtkIdType i = 0; i < devices->GetNumberOfValues(); ++i)
  {
    const std::string line = devices->GetValue(i);
    if (line.find(mapper->GetDeviceName()) != std::string::npos &&
      line.find("(with ray query)") != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

void checkPicture(test::Checks& checks, int scene)
{
  vtkNew<vtkExaBricksSceneSource> source;
  source->SetScene(scene);
  source->SetNumberOfLeafCells(std::max<vtkIdType>(60000, source->GetLeastNumberOfLeafCells()));
  const std::string name = source->GetSceneName();

  test::Stage stage(Size);
  stage.mapper->SetInputConnection(source->GetOutputPort());
  stage.mapper->SetScalarModeToUseCellFieldData();
  stage.mapper->SelectScalarArray("value");
  source->InitializeProperty(stage.Property());
  source->InitializeCamera(stage.renderer->GetActiveCamera());
  stage.renderer->ResetCameraClippingRange();
  const test::Picture picture(stage.window);
  if (hasRayQuery(stage.mapper))
  {
    // Two ways to find the same regions: garbage would not agree.
    stage.mapper->SetTraversalToRayQuery();
    const double likeness = picture.Decibel(test::Picture(stage.window));
    checks.Expect(likeness >= 50.0, name + " by ray query: " + std::to_string(likeness) + " dB");
  }
  else
  {
    std::cout << name << ": the device has no ray query to compare with\n";
  }
  const double brightness = picture.Mean()[0] + picture.Mean()[1] + picture.Mean()[2];
  checks.Expect(picture.Coverage() > 0.1, name + " covers more than a tenth of the picture");
  checks.Expect(brightness > 0.03, name + " is not dark");
  double least = 3.0;
  double most = 0.0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const test::Picture::Color color = picture.At(x, y);
      least = std::min(least, color[0] + color[1] + color[2]);
      most = std::max(most, color[0] + color[1] + color[2]);
    }
  }
  checks.Expect(most - least > 0.8, name + " has bright and dark parts");

  // The builder finds what the generator has made.
  const auto kind = static_cast<exabricks::StandInKind>(scene);
  const exabricks::Structure structure = exabricks::buildStructure(
    exabricks::makeStandIn(kind, static_cast<std::uint64_t>(source->GetNumberOfLeafCells()))
      .hierarchy);
  vtkExaBricksData* data = stage.mapper->GetBuilder()->GetOutput();
  const auto leafCells = static_cast<double>(structure.leafCells);
  checks.Equal(static_cast<double>(data->GetNumberOfLeafCells()), leafCells, name + ": leaf cells");
  checks.Equal(static_cast<double>(data->GetNumberOfBlocks()),
    static_cast<double>(structure.hierarchy.blocks.size()), name + ": blocks");
  checks.Equal(static_cast<double>(data->GetNumberOfBricks()),
    static_cast<double>(structure.bricks.size()), name + ": bricks");
  checks.Equal(static_cast<double>(data->GetNumberOfRegions()),
    static_cast<double>(structure.tree.regions.size()), name + ": regions");
  checks.Equal(data->GetNumberOfLevels(), structure.hierarchy.levels(), name + ": levels");
  checks.Equal(data->GetNumberOfAbsentCells(), 0.0, name + ": absent cells");
  checks.Equal(static_cast<double>(countLeafCells(source->GetOutput())), leafCells,
    name + ": cells not marked as refined");
  checks.Expect(stage.mapper->GetNumberOfActiveRegions() < data->GetNumberOfRegions(),
    name + " has empty space");
  checks.Expect((source->GetMesh()->GetNumberOfCells() > 0) ==
      (scene == vtkExaBricksSceneSource::GEAR || scene >= vtkExaBricksSceneSource::EXAJET_REAR),
    name + ": surface");
}

// The gear's surface is seen through the volume before it, and hides the one behind it.
void checkSurfaceCutsVolume(test::Checks& checks)
{
  vtkNew<vtkExaBricksSceneSource> source;
  source->SetSceneToGear();
  source->SetNumberOfLeafCells(source->GetLeastNumberOfLeafCells());
  test::Stage stage(Size);
  stage.mapper->SetInputConnection(source->GetOutputPort(0));
  vtkNew<vtkPolyDataMapper> surfaceMapper;
  surfaceMapper->SetInputConnection(source->GetOutputPort(1));
  vtkNew<vtkActor> surface;
  surface->SetMapper(surfaceMapper);
  surface->GetProperty()->LightingOff();
  surface->GetProperty()->SetColor(0.0, 0.0, 0.0);
  stage.renderer->AddActor(surface);
  // Every value in red, so that what is left of it says how long the ray was.
  test::setConstantColor(stage.Property(), 0.5, { 1.0, 0.0, 0.0 });
  stage.Property()->SetScalarOpacityUnitDistance(1.0);
  source->InitializeCamera(stage.renderer->GetActiveCamera());
  stage.renderer->ResetCameraClippingRange();
  const test::Picture with(stage.window);
  stage.renderer->RemoveActor(surface);
  const test::Picture without(stage.window);
  int cut = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const double less = without.At(x, y)[0] - with.At(x, y)[0];
      checks.Expect(less > -1.5 * test::OneStep, "nothing is added by the surface");
      cut += less > 0.05;
    }
  }
  const double share = static_cast<double>(cut) / (Size * Size);
  checks.Expect(share > 0.02 && share < 0.5,
    "the surface hides some of the volume, found a share of " + std::to_string(share));
}

// Several processes have blocks of their own, which are together those of one.
void checkPieces(test::Checks& checks)
{
  vtkNew<vtkExaBricksSceneSource> source;
  source->SetNumberOfLeafCells(60000);
  const auto count = [&](int piece, int pieces)
  {
    source->UpdatePiece(piece, pieces, 0);
    std::array<vtkIdType, 2> found{ 0, 0 }; // blocks, cells
    exabricks::forEachBlock(source->GetOutput(),
      [&](vtkDataSet* block)
      {
        ++found[0];
        found[1] += block->GetNumberOfCells();
      });
    return found;
  };
  const std::array<vtkIdType, 2> all = count(0, 1);
  std::array<vtkIdType, 2> sum{ 0, 0 };
  for (int piece = 0; piece < 3; ++piece)
  {
    const std::array<vtkIdType, 2> own = count(piece, 3);
    checks.Expect(own[0] > 0 && own[0] < all[0], "a piece has some of the blocks");
    checks.Equal(exabricks::numberOfBlocks(source->GetOutput(), 0) > 0, true, "boxes of all");
    sum = { sum[0] + own[0], sum[1] + own[1] };
  }
  checks.Equal(sum[0], all[0], "blocks of all pieces");
  checks.Equal(sum[1], all[1], "cells of all pieces");
}

void checkMessages(test::Checks& checks)
{
  test::Messages messages;
  vtkNew<vtkExaBricksSceneSource> source;
  source->SetSceneName("impact-20k");
  checks.Equal(source->GetScene(), vtkExaBricksSceneSource::IMPACT_20K, "scene by name");
  source->SetSceneName("teapot");
  checks.Says(messages.TakeErrors(), { "'teapot'", "Impact-5K", "Exajet-wing" }, "no such scene");
  checks.Equal(source->GetScene(), vtkExaBricksSceneSource::IMPACT_20K, "the scene is kept");
  source->SetSceneName(nullptr);
  checks.Says(messages.TakeErrors(), { "null" }, "no name");
  source->InitializeCamera(nullptr);
  source->InitializeProperty(nullptr);
  checks.Says(messages.TakeErrors(), { "camera", "property" }, "nothing to set");
  source->SetSceneToWind();
  source->SetNumberOfLeafCells(1000);
  source->Update();
  checks.Says(messages.TakeWarnings(), { "1000000", "Wind", "1000" }, "too few cells");
  checks.Expect(source->GetOutput()->GetNumberOfLevels() == 3, "the least number is made");
}
}

int TestSceneSource(int, char*[])
{
  test::Checks checks;
  const test::KeepDisplay display;
  for (int scene = 0; scene <= vtkExaBricksSceneSource::EXAJET_WING; ++scene)
  {
    checkPicture(checks, scene);
  }
  checkSurfaceCutsVolume(checks);
  checkPieces(checks);
  checkMessages(checks);
  return checks.Status();
}
