// SPDX-License-Identifier: BSD-3-Clause
// A 2-D transfer function, of values and of the magnitude of their gradients, shows the same as
// with VTK's GPU mapper; the fixed-point mapper has none.

#include "Parity.h"

namespace
{
// Steeper further out.
double bowl(double x, double y, double z)
{
  const double distance = parity::ball(x, y, z);
  return 0.05 * distance * distance;
}

// Its values at the middles of cells: VTK takes gradients over the distance of points.
vtkSmartPointer<vtkImageData> makeMiddles(int cells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(0.5, 0.5, 0.5);
  image->SetDimensions(cells, cells, cells);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    double at[3];
    image->GetPoint(point, at);
    image->GetPointData()->GetScalars()->SetComponent(point, 0, bowl(at[0], at[1], at[2]));
  }
  return image;
}

// A pixel for each value and gradient.
vtkSmartPointer<vtkImageData> makeFunction()
{
  constexpr int Size = 256;
  auto function = vtkSmartPointer<vtkImageData>::New();
  function->SetDimensions(Size, Size, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  auto* colors = vtkFloatArray::SafeDownCast(function->GetPointData()->GetScalars());
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const double value = (x + 0.5) / Size;
      const double gradient = (y + 0.5) / Size;
      const double steep = std::min(0.2 + 3.0 * gradient, 1.0);
      const double opacity = 0.03 * std::max(1.0 - 9.0 * std::abs(value - 0.1), 0.0) * steep;
      colors->SetTuple4(
        x + static_cast<vtkIdType>(y) * Size, 1.0 - steep, 0.3 + 2.0 * value, steep, opacity);
    }
  }
  return function;
}
}

int TransferFunction2DLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  parity::Scene scene;
  scene.field = bowl;
  parity::Mappers mappers(scene);
  mappers.ShowBall(); // for its view
  vtkVolumeProperty* property = mappers.Property();
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  // VTK's mapper finds no gradients unless there is this function, which is not drawn beside the
  // other.
  property->GetGradientOpacity()->AddPoint(0.0, 0.0);
  property->GetGradientOpacity()->AddPoint(1.0, 1.0);
  property->SetTransferFunction2D(makeFunction());
  mappers.onGPU->SetInputData(makeMiddles(scene.cells[0]));
  // VTK's mapper takes the opacity of a 2-D function for that of a sample, at whatever distance.
  property->SetScalarOpacityUnitDistance(mappers.onGPU->GetSampleDistance());
  for (const bool shaded : { false, true })
  {
    property->SetShade(shaded);
    property->SetAmbient(0.2);
    property->SetDiffuse(0.8);
    property->SetSpecular(0.0);
    const test::Picture ours = mappers.Draw(mappers.mapper);
    const double decibel = ours.Decibel(mappers.Draw(mappers.onGPU));
    std::cout << (shaded ? "shaded" : "unshaded") << ": " << decibel << " dB\n";
    checks.Expect(decibel >= 35.0, std::to_string(decibel) + " dB");
    checks.Expect(ours.Coverage() > 0.2, "it shows");
  }
  return checks.Status();
}
