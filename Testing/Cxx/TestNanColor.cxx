// SPDX-License-Identifier: BSD-3-Clause
// Cells without a value show in the NaN color of the color function where it is asked for, each as
// it is, with the field up to its faces; hidden cells never do.

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkExaBricksPicker.h"
#include "vtkPlane.h"
#include "vtkStringArray.h"

#include <limits>

namespace
{
constexpr double Opacity = 0.1;
constexpr double NanOpacity = 0.2;
const test::Picture::Color NanColor{ 0.9, 0.3, 0.0 };
const double NotANumber = std::numeric_limits<double>::quiet_NaN();

// A colour of the window, of rays that pass a length of cells without a value, then one with.
test::Picture::Color expect(double without, double with)
{
  const double front = test::opacityOf(NanOpacity, without);
  const double behind = (1.0 - front) * test::opacityOf(Opacity, with);
  test::Picture::Color color{};
  for (int c = 0; c < 3; ++c)
  {
    color[c] = front * NanColor[c] + behind;
  }
  return color;
}

struct Scene
{
  test::Checks& checks;
  test::Stage& stage;

  void Shows(double without, double with, const std::string& what) const
  {
    const test::Picture picture(this->stage.window);
    const test::Picture::Color color = expect(without, with);
    for (int c = 0; c < 3; ++c)
    {
      // Above coarse cells, and above fine ones.
      this->checks.Near(picture.At(70, 25)[c], color[c], test::OneStep, what + ", coarse");
      this->checks.Near(picture.At(25, 25)[c], color[c], test::OneStep, what + ", fine");
    }
  }
};
}

int TestNanColor(int, char*[])
{
  test::Checks checks;
  test::Messages messages;

  // A cube from 0 to 8, refined in the eighth at its lower corner, without values above z = 2.
  const auto amr = test::makeAMR(
    test::cornerRefined(), [](double, double, double z) { return z > 2.0 ? NotANumber : 1.0; });
  test::Stage stage(amr);
  test::setConstantColor(stage.Property(), Opacity);
  vtkColorTransferFunction* colors = stage.Property()->GetRGBTransferFunction();
  colors->SetNanColor(NanColor[0], NanColor[1], NanColor[2]);
  colors->SetNanOpacity(NanOpacity);
  test::lookAlongZ(stage.renderer, 4.0, 4.0, 4.0, 8.0);
  const Scene scene{ checks, stage };
  vtkExaBricksVolumeMapper* mapper = stage.mapper;

  checks.Expect(!mapper->GetUseNanColor(), "off by default");
  scene.Shows(0.0, 2.0, "left out");
  mapper->UseNanColorOn();
  vtkNew<vtkStringArray> devices;
  vtkExaBricksVolumeMapper::GetDevices(devices);
  std::vector<int> traversals{ mapper->KD_TREE };
  if (devices->GetValue(0).find("without ray query") == std::string::npos)
  {
    traversals.push_back(mapper->RAY_QUERY);
  }
  for (const int traversal : traversals)
  {
    mapper->SetTraversal(traversal);
    for (const int reconstruction : { mapper->BASIS, mapper->NEAREST, mapper->COMPLETED })
    {
      mapper->SetReconstruction(reconstruction);
      scene.Shows(6.0, 2.0,
        std::string(mapper->GetReconstructionAsString()) + ", " + mapper->GetTraversalAsString());
    }
  }
  mapper->SetTraversalToAutomatic();

  // With a tolerance, no level of them is left out.
  mapper->SetReconstructionToBasis();
  mapper->SetErrorTolerance(0.01);
  scene.Shows(6.0, 2.0, "within a tolerance");
  checks.Equal(mapper->GetLevelsLeftOut(), 0, "levels left out");
  mapper->SetErrorTolerance(0.0);

  // Cut within a cell.
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 5.3);
  plane->SetNormal(0.0, 0.0, -1.0);
  mapper->AddClippingPlane(plane);
  scene.Shows(3.3, 2.0, "clipped");
  mapper->RemoveAllClippingPlanes();

  // In a slice each place has the opacity of its cell, whatever the unit distance.
  vtkNew<vtkPlane> slice;
  stage.Property()->SetSliceFunction(slice);
  stage.Property()->SetScalarOpacityUnitDistance(4.0);
  mapper->SetBlendModeToSlice();
  slice->SetOrigin(0.0, 0.0, 3.0);
  for (const int reconstruction : { mapper->BASIS, mapper->NEAREST, mapper->COMPLETED })
  {
    mapper->SetReconstruction(reconstruction);
    scene.Shows(1.0, 0.0, "a slice without values");
  }
  slice->SetOrigin(0.0, 0.0, 1.3);
  scene.Shows(0.0, 1.0, "a slice with values");
  mapper->SetBlendModeToComposite();
  mapper->SetReconstructionToBasis();
  stage.Property()->SetScalarOpacityUnitDistance(1.0);

  // They are seen first, and have no value to tell.
  vtkNew<vtkExaBricksPicker> picker;
  checks.Expect(picker->Pick(70.0, 25.0, 0.0, stage.renderer) != 0, "picked");
  checks.Expect(std::isnan(picker->GetValue()), "a cell without a value is picked");

  // What of the transfer function shows nothing is passed, they are not.
  stage.Property()->GetScalarOpacity()->RemoveAllPoints();
  stage.Property()->GetScalarOpacity()->AddPoint(0.0, 0.0);
  scene.Shows(6.0, 0.0, "alone");
  mapper->UseNanColorOff();
  checks.Equal(test::Picture(stage.window).Coverage(), 0.0, "nothing");
  mapper->UseNanColorOn();

  // Data of which no cell has a value, infinite ones too, and a hidden half.
  const auto nothing = test::makeAMR(test::cornerRefined(),
    [](double x, double, double)
    { return x > 2.0 ? NotANumber : -std::numeric_limits<double>::infinity(); });
  mapper->SetInputData(nothing);
  scene.Shows(8.0, 0.0, "no values at all");
  test::forEachGrid(nothing,
    [](unsigned int, vtkUniformGrid* grid)
    {
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        double bounds[6];
        grid->GetCellBounds(cell, bounds);
        if (bounds[4] >= 4.0)
        {
          grid->BlankCell(cell);
        }
      }
    });
  nothing->Modified();
  scene.Shows(4.0, 0.0, "hidden cells");
  checks.Silent(messages.TakeErrors(), "nothing to say");
  checks.Silent(messages.TakeWarnings(), "nothing to say");

  // Where it cannot be, it is said.
  mapper->SetInputData(amr);
  mapper->SetBlendModeToMaximumIntensity();
  test::Picture(stage.window);
  checks.Says(
    messages.TakeWarnings(), { "UseNanColor", "composite and slice" }, "another blend mode");
  return checks.Status();
}
