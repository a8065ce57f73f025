// SPDX-License-Identifier: BSD-3-Clause
// From a file to a picture: a reader, the mapper and a volume, as with any volume mapper of VTK.
// Left the vorticity, right the density of a Rayleigh-Taylor instability on three levels.

#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkRegressionTestImage.h"
#include "vtkTestUtilities.h"
#include "vtkXMLUniformGridAMRReader.h"

#include <array>
#include <memory>
#include <vector>

namespace
{
// Colours and opacities by value; `unit` is the length that the opacities are meant for.
void showVolume(vtkVolume* volume, double unit, const std::vector<std::array<double, 4>>& colors,
  const std::vector<std::array<double, 2>>& opacities)
{
  vtkNew<vtkColorTransferFunction> color;
  for (const auto& node : colors)
  {
    color->AddRGBPoint(node[0], node[1], node[2], node[3]);
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& node : opacities)
  {
    opacity->AddPoint(node[0], node[1]);
  }
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(unit);
}
}

int TestReaderToPicture(int argc, char* argv[])
{
  test::Checks checks;
  std::unique_ptr<char[]> file(
    vtkTestUtilities::ExpandDataFileName(argc, argv, "rt_medium/rt_medium.vthb"));
  vtkNew<vtkXMLUniformGridAMRReader> reader;
  reader->SetFileName(file.get());
  reader->SetMaximumLevelsToReadByDefault(0); // all

  test::Stage stage;
  stage.window->SetSize(300, 300);
  stage.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  stage.mapper->SetInputConnection(reader->GetOutputPort());
  stage.mapper->SetScalarModeToUseCellFieldData();
  stage.mapper->SelectScalarArray("magvort");
  showVolume(stage.volume, 0.02, { { 0.5, 0.1, 0.2, 0.8 }, { 6.0, 1.0, 0.9, 0.6 } },
    { { 0.5, 0.0 }, { 10.0, 0.5 } });

  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetActiveCamera(stage.renderer->GetActiveCamera());
  stage.window->AddRenderer(right);
  vtkNew<vtkExaBricksVolumeMapper> density;
  density->SetInputConnection(reader->GetOutputPort());
  density->SetScalarModeToUseCellFieldData();
  density->SelectScalarArray("density");
  vtkNew<vtkVolume> heavyGas;
  heavyGas->SetMapper(density);
  showVolume(heavyGas, 0.03, { { 1.7, 0.1, 0.4, 1.0 }, { 2.05, 1.0, 0.6, 0.1 } },
    { { 1.5, 0.0 }, { 2.1, 0.15 } });
  right->AddVolume(heavyGas);

  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->SetPosition(0.8, -1.8, 0.9);
  camera->SetFocalPoint(0.25, 0.25, 0.45);
  camera->SetViewUp(0.0, 0.0, 1.0);
  stage.renderer->ResetCameraClippingRange();
  const test::Picture picture(stage.window);

  vtkExaBricksData* data = stage.mapper->GetBuilder()->GetOutput();
  double range[2];
  data->GetScalarRange(range);
  checks.Equal(data->GetNumberOfLevels(), 3, "levels");
  checks.Equal(data->GetNumberOfBlocks(), 25, "blocks");
  checks.Equal(data->GetNumberOfLeafCells(), 549120, "leaf cells");
  checks.Equal(data->GetNumberOfAbsentCells(), 0, "absent cells");
  checks.Near(range[1], 18.7710, 1e-4, "greatest magvort");
  checks.Expect(
    stage.mapper->GetNumberOfActiveRegions() < data->GetNumberOfRegions(), "still gas is skipped");
  checks.Equal(
    density->GetBuilder()->GetNumberOfStructureBuilds(), 1, "builds of the right mapper");

  // The heavy gas lies above, the mixing zone in the middle.
  const auto above = picture.Mean(180, 210, 270, 240);
  const auto below = picture.Mean(180, 60, 270, 90);
  checks.Expect(above[0] > 0.4 && below[0] < 0.05, "heavy gas above, none below");
  checks.Expect(above[0] > above[2], "heavy gas is orange");
  checks.Expect(picture.Mean(50, 130, 100, 170)[0] > 0.1, "vortices in the middle");
  checks.Expect(picture.Mean(50, 240, 100, 260)[0] < 0.02, "no vortices above");

  const int image = vtkRegressionTestImage(stage.window);
  return image == vtkTesting::FAILED ? EXIT_FAILURE : checks.Status();
}
