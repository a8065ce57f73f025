// SPDX-License-Identifier: BSD-3-Clause
// One field as an AMR of one level and as an image for VTK's mappers, in one window, with one
// property: what is set for all mappers, all of them draw the same.
#ifndef ExaBricksTestingParity_h
#define ExaBricksTestingParity_h

#include "AMR.h"
#include "Checks.h"
#include "Stage.h"

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFloatArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <functional>

namespace parity
{
/// A block of cells with its lower corner at the lattice's origin.
struct Scene
{
  std::array<int, 3> cells{ 24, 24, 24 };
  test::Lattice lattice{};
  test::Field field;
  std::vector<test::Field> furtherFields{}; // of further components
};

/// A ball with a core, off the middle of a block from 0 to 24.
inline double ball(double x, double y, double z)
{
  return std::hypot(x - 11.0, y - 12.5, z - 13.0);
}

inline vtkSmartPointer<vtkOverlappingAMR> makeAMR(const Scene& scene)
{
  auto amr = test::makeAMR({ { 0, { 0, 0, 0 }, scene.cells } }, scene.field, scene.lattice);
  if (!scene.furtherFields.empty())
  {
    std::vector<test::Field> fields{ scene.field };
    fields.insert(fields.end(), scene.furtherFields.begin(), scene.furtherFields.end());
    test::forEachGrid(
      amr, [&](unsigned int, vtkUniformGrid* grid) { test::addCells(grid, fields); });
  }
  return amr;
}

/// The same trilinear function over the same bounds, as an image that has it at its points: between
/// the middles of cells it is linear, and from the outer ones on constant, so that points at every
/// half cell have all of it.
inline vtkSmartPointer<vtkImageData> makeImage(const Scene& scene)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const std::array<double, 3>& spacing = scene.lattice.spacing;
  const std::array<double, 3>& origin = scene.lattice.origin;
  image->SetOrigin(origin.data());
  image->SetSpacing(0.5 * spacing[0], 0.5 * spacing[1], 0.5 * spacing[2]);
  image->SetDimensions(2 * scene.cells[0] + 1, 2 * scene.cells[1] + 1, 2 * scene.cells[2] + 1);
  image->AllocateScalars(VTK_FLOAT, 1 + static_cast<int>(scene.furtherFields.size()));
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    // At the middle of a cell, or half way between the two beside the point.
    std::array<std::array<double, 2>, 3> middles;
    const int* const size = image->GetDimensions();
    vtkIdType rest = point;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int half = static_cast<int>(rest % size[axis]);
      rest /= size[axis];
      for (int side = 0; side < 2; ++side)
      {
        const int cell = std::min(std::max((half - 1 + side) / 2, 0), scene.cells[axis] - 1);
        middles[axis][side] = origin[axis] + spacing[axis] * (cell + 0.5);
      }
    }
    for (int k = 0; k < values->GetNumberOfComponents(); ++k)
    {
      const test::Field& field = k == 0 ? scene.field : scene.furtherFields[k - 1];
      double sum = 0.0;
      for (int corner = 0; corner < 8; ++corner)
      {
        sum +=
          field(middles[0][corner & 1], middles[1][corner >> 1 & 1], middles[2][corner >> 2 & 1]);
      }
      values->SetComponent(point, k, sum / 8.0);
    }
  }
  return image;
}

/// Our mapper on a stage, and VTK's own beside it. Colours, camera and the volume's matrix are
/// those of the stage, for all.
struct Mappers : test::Stage
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> fixedPoint;
  vtkNew<vtkGPUVolumeRayCastMapper> onGPU;

  explicit Mappers(const Scene& scene, int size = 120)
    : Stage(makeAMR(scene), size)
  {
    const auto image = makeImage(scene);
    // Steps so short that they do not show.
    const std::array<double, 3>& spacing = scene.lattice.spacing;
    const double step = 0.1 * std::min({ spacing[0], spacing[1], spacing[2] });
    this->mapper->SetStepScale(0.25);
    this->fixedPoint->SetInputData(image);
    this->fixedPoint->AutoAdjustSampleDistancesOff();
    this->fixedPoint->SetImageSampleDistance(1.0);
    this->fixedPoint->SetSampleDistance(static_cast<float>(step));
    this->onGPU->SetInputData(image);
    this->onGPU->AutoAdjustSampleDistancesOff();
    this->onGPU->UseJitteringOff();
    this->onGPU->SetSampleDistance(static_cast<float>(step));
  }

  /// A translucent ball with a denser core.
  void ShowBall()
  {
    vtkVolumeProperty* property = this->Property();
    property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 0.9, 0.2);
    property->GetRGBTransferFunction()->AddRGBPoint(5.0, 0.9, 0.3, 0.1);
    property->GetRGBTransferFunction()->AddRGBPoint(11.0, 0.2, 0.4, 1.0);
    property->GetScalarOpacity()->AddPoint(0.0, 0.7);
    property->GetScalarOpacity()->AddPoint(5.0, 0.15);
    property->GetScalarOpacity()->AddPoint(11.0, 0.02);
    property->GetScalarOpacity()->AddPoint(12.0, 0.0);
    vtkCamera* camera = this->renderer->GetActiveCamera();
    camera->SetFocalPoint(12.0, 12.0, 12.0);
    camera->SetPosition(40.0, -45.0, 50.0);
    this->renderer->ResetCamera();
    camera->Zoom(1.4);
  }

  std::array<vtkVolumeMapper*, 2> Peers() { return { this->fixedPoint, this->onGPU }; }

  /// Sets something of all mappers.
  void ForEach(const std::function<void(vtkVolumeMapper*)>& set)
  {
    set(this->mapper);
    for (vtkVolumeMapper* peer : this->Peers())
    {
      set(peer);
    }
  }

  test::Picture Draw(vtkVolumeMapper* by)
  {
    this->volume->SetMapper(by);
    return test::Picture(this->window);
  }

  /// How near the picture by one of VTK's mappers is to ours: dB over the pixels drawn in either.
  double Compare(vtkVolumeMapper* peer)
  {
    return this->Draw(this->mapper).Decibel(this->Draw(peer));
  }

  /// Ours is like that of one of VTK's mappers, where the other one differs from both.
  void ExpectSameAs(test::Checks& checks, vtkVolumeMapper* peer, const std::string& what,
    double leastDecibel = 35.0)
  {
    const double decibel = this->Compare(peer);
    std::cout << what << ", " << peer->GetClassName() << ": " << decibel << " dB\n";
    checks.Expect(decibel >= leastDecibel,
      what + ": " + std::to_string(decibel) + " dB beside " + peer->GetClassName());
  }
  void ExpectSameAsOnGPU(test::Checks& checks, const std::string& what, double leastDecibel = 35.0)
  {
    this->ExpectSameAs(checks, this->onGPU, what, leastDecibel);
  }

  /// Ours is like that of both of VTK's mappers, which have 39 to 49 dB between them.
  void ExpectSame(test::Checks& checks, const std::string& what, double leastDecibel = 35.0)
  {
    for (vtkVolumeMapper* peer : this->Peers())
    {
      this->ExpectSameAs(checks, peer, what, leastDecibel);
    }
  }
};
}

#endif
