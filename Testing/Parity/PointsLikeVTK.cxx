// SPDX-License-Identifier: BSD-3-Clause
// An image of values at points, as VTK's mappers take it, wrapped as an AMR of one block: drawn,
// picked and asked for as the image itself.

#include "Parity.h"

#include "vtkAMRBox.h"
#include "vtkCellPicker.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksPicker.h"
#include "vtkVolumePicker.h"

namespace
{
constexpr int Points = 25; // along each axis, one unit apart

// A ball whose surface is as rough as values at points can be.
double roughBall(int i, int j, int k)
{
  return parity::ball(i, j, k) + ((i + j + k) % 2 == 0 ? 0.6 : -0.6);
}

vtkSmartPointer<vtkImageData> makeImageOfPoints()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Points, Points, Points);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int k = 0; k < Points; ++k)
  {
    for (int j = 0; j < Points; ++j)
    {
      for (int i = 0; i < Points; ++i)
      {
        image->SetScalarComponentFromDouble(i, j, k, 0, roughBall(i, j, k));
      }
    }
  }
  image->GetPointData()->GetScalars()->SetName("roughness");
  return image;
}

// All that it takes to hand an image to a mapper of AMR.
vtkSmartPointer<vtkOverlappingAMR> wrap(vtkImageData* image)
{
  const int cells = Points - 1;
  auto amr = test::makeNullBlocks({ { 0, { 0, 0, 0 }, { cells, cells, cells } } });
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(image);
  amr->SetDataSet(0, 0, grid);
  return amr;
}

struct Wrapped : parity::Mappers
{
  vtkSmartPointer<vtkImageData> image = makeImageOfPoints();

  Wrapped()
    : Mappers({ { Points - 1, Points - 1, Points - 1 }, {}, parity::ball })
  {
    this->mapper->SetInputData(wrap(this->image));
    this->ForEach([](vtkVolumeMapper* any) { any->SetScalarModeToDefault(); });
    this->fixedPoint->SetInputData(this->image);
    this->onGPU->SetInputData(this->image);
    this->ShowBall();
  }
};

void checkPictures(test::Checks& checks)
{
  Wrapped scene;
  scene.ExpectSame(checks, "values at points");
  checks.Expect(scene.mapper->GetBuilder()->GetOutput()->GetNumberOfLeafCells() ==
      scene.image->GetNumberOfPoints(),
    "each point counts as a cell");
  for (int axis = 0; axis < 6; ++axis)
  {
    double bounds[6];
    scene.mapper->GetBuilder()->GetOutput()->GetBounds(bounds);
    checks.Expect(bounds[axis] == scene.image->GetBounds()[axis], "the bounds are the image's");
  }

  scene.Property()->SetInterpolationTypeToNearest();
  scene.ExpectSameAsOnGPU(checks, "the nearest point");
  scene.Property()->SetInterpolationTypeToLinear();

  scene.ForEach([](vtkVolumeMapper* any) { any->SetBlendModeToMinimumIntensity(); });
  scene.ExpectSameAsOnGPU(checks, "the least value between points");
  scene.ForEach([](vtkVolumeMapper* any) { any->SetBlendModeToComposite(); });

  // Where it ends, the image is opaque: nothing of it is beyond its outermost points.
  vtkPiecewiseFunction* opacity = scene.Property()->GetScalarOpacity();
  opacity->AddPoint(12.0, 0.9);
  opacity->AddPoint(30.0, 0.9);
  // The fixed-point mapper has other faces: 33 dB to both.
  scene.ExpectSameAsOnGPU(checks, "opaque to its faces");
}

// A label may be at one point alone: the mean of cells would have none of it.
void checkLabel(test::Checks& checks)
{
  Wrapped scene;
  for (vtkIdType point = 0; point < scene.image->GetNumberOfPoints(); ++point)
  {
    scene.image->GetPointData()->GetScalars()->SetComponent(point, 0, point % 7 == 3 ? 3.0 : 0.0);
  }
  scene.image->Modified();
  scene.mapper->SetInputData(wrap(scene.image));
  vtkPiecewiseFunction* opacity = scene.Property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(2.4, 0.0);
  opacity->AddPoint(2.6, 0.8);
  scene.Property()->SetInterpolationTypeToNearest();
  scene.ExpectSameAsOnGPU(checks, "labels at points");
  scene.Property()->SetInterpolationTypeToLinear();
}

// VTK's own pickers, which take images, have the only block for one.
void checkPickers(test::Checks& checks)
{
  Wrapped scene;
  vtkNew<vtkCellPicker> cellPicker;
  vtkNew<vtkVolumePicker> volumePicker;
  vtkNew<vtkExaBricksPicker> ourPicker;
  vtkCellPicker* const pickers[] = { cellPicker, volumePicker };
  for (vtkCellPicker* picker : pickers)
  {
    std::array<vtkIdType, 2> cells;
    std::array<std::array<double, 3>, 2> places;
    vtkVolumeMapper* const mappers[] = { scene.onGPU, scene.mapper };
    for (int i = 0; i < 2; ++i)
    {
      scene.Draw(mappers[i]);
      checks.Expect(
        picker->Pick(60.0, 60.0, 0.0, scene.renderer) != 0, "VTK's picker finds the volume");
      cells[i] = picker->GetCellId();
      picker->GetPickPosition(places[i].data());
    }
    checks.Expect(cells[0] >= 0 && cells[0] == cells[1], "it finds the same cell of it");
    checks.Expect(places[0] == places[1], "it finds the same place of it");
  }

  checks.Expect(ourPicker->Pick(60.0, 60.0, 0.0, scene.renderer) != 0, "ours finds it");
  int ijk[3];
  double fractions[3];
  checks.Expect(
    scene.image->ComputeStructuredCoordinates(ourPicker->GetPickPosition(), ijk, fractions) != 0,
    "the place is in the image");
  checks.Expect(ourPicker->GetCellId() == scene.image->ComputeCellId(ijk),
    "the cell is that between points, found " + std::to_string(ourPicker->GetCellId()));
  int nearest[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    nearest[axis] = ijk[axis] + (fractions[axis] < 0.5 ? 0 : 1);
  }
  checks.Expect(
    std::abs(ourPicker->GetValue() - roughBall(nearest[0], nearest[1], nearest[2])) < 1e-5,
    "the value is that of the nearest point");
}

// Where the wrapped image has hidden points, nothing is drawn around them.
void checkHiddenPoints(test::Checks& checks)
{
  Wrapped scene;
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(scene.image);
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    if (point % Points < Points / 2)
    {
      grid->BlankPoint(point);
    }
  }
  const double whole = scene.Draw(scene.mapper).Coverage();
  const int cells = Points - 1;
  auto amr = test::makeNullBlocks({ { 0, { 0, 0, 0 }, { cells, cells, cells } } });
  amr->SetDataSet(0, 0, grid);
  scene.mapper->SetInputData(amr);
  const double half = scene.Draw(scene.mapper).Coverage();
  checks.Expect(scene.mapper->GetBuilder()->GetOutput()->GetNumberOfAbsentCells() ==
      Points * Points * (Points / 2),
    "hidden points are absent");
  checks.Expect(half > 0.3 * whole && half < 0.8 * whole, "and not drawn");
}
}

int PointsLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  checkPictures(checks);
  checkLabel(checks);
  checkPickers(checks);
  checkHiddenPoints(checks);
  return checks.Status();
}
