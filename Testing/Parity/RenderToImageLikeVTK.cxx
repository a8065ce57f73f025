// SPDX-License-Identifier: BSD-3-Clause
// The volume as an image of its colors and one of the depths at which it is first seen, instead of
// in the window.

#include "Parity.h"

#include "vtkBox.h"

namespace
{
// Largest difference of an image's component to the other's, and how many pixels differ by more
// than `bound`.
struct Difference
{
  double largest = 0.0;
  int beyond = 0;
};
Difference compare(vtkImageData* one, vtkImageData* other, int components, double bound)
{
  Difference found;
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    double most = 0.0;
    for (int k = 0; k < components; ++k)
    {
      most = std::max(most,
        std::abs(one->GetPointData()->GetScalars()->GetComponent(i, k) -
          other->GetPointData()->GetScalars()->GetComponent(i, k)));
    }
    found.largest = std::max(found.largest, most);
    found.beyond += most > bound;
  }
  return found;
}

struct Images : parity::Mappers
{
  vtkNew<vtkImageData> ours;
  vtkNew<vtkImageData> theirs;

  Images()
    : Mappers({ { 24, 24, 24 }, {}, parity::ball })
  {
    this->ShowBall();
    this->Property()
      ->GetScalarOpacity()
      ->RemoveAllPoints(); // so that there is a place to see first
    this->Property()->GetScalarOpacity()->AddPoint(8.0, 0.8);
    this->Property()->GetScalarOpacity()->AddPoint(8.05, 0.0);
    this->mapper->RenderToImageOn();
    this->onGPU->RenderToImageOn();
  }

  void DrawBoth()
  {
    for (vtkVolumeMapper* by :
      { static_cast<vtkVolumeMapper*>(this->mapper), static_cast<vtkVolumeMapper*>(this->onGPU) })
    {
      this->volume->SetMapper(by);
      this->window->Render();
    }
  }

  int DrawnInWindow(vtkVolumeMapper* by) { return this->Draw(by).Coverage() > 0.0 ? 1 : 0; }
};

void checkColors(test::Checks& checks)
{
  Images scene;
  scene.mapper->GetColorImage(scene.ours);
  checks.Equal(scene.ours->GetNumberOfPoints(), 0, "points of an image before the first picture");
  scene.DrawBoth();
  checks.Equal(scene.DrawnInWindow(scene.mapper), 0, "nothing is drawn in the window");
  scene.mapper->GetColorImage(scene.ours);
  scene.onGPU->GetColorImage(scene.theirs);
  checks.Equal(scene.ours->GetDimensions()[0], scene.theirs->GetDimensions()[0], "width");
  checks.Equal(scene.ours->GetDimensions()[1], scene.theirs->GetDimensions()[1], "height");
  checks.Equal(scene.ours->GetScalarType(), scene.theirs->GetScalarType(), "type of colors");
  checks.Equal(scene.ours->GetNumberOfScalarComponents(), 4, "components");
  const Difference off = compare(scene.ours, scene.theirs, 4, 8.0);
  std::cout << "colors: largest difference " << off.largest
            << ", pixels beyond 8 of 255: " << off.beyond << "\n";
  checks.Expect(off.beyond <= 60, "the colors are VTK's, but for edges");

  scene.mapper->RenderToImageOff();
  checks.Equal(scene.DrawnInWindow(scene.mapper), 1, "drawn in the window again");
}

void checkDepths(test::Checks& checks)
{
  Images scene;
  scene.DrawBoth();
  scene.mapper->GetDepthImage(scene.ours);
  scene.onGPU->GetDepthImage(scene.theirs);
  checks.Equal(scene.ours->GetScalarType(), VTK_FLOAT, "type of depths");
  double range[2];
  scene.ours->GetScalarRange(range);
  const Difference off = compare(scene.ours, scene.theirs, 1, 0.01 * (range[1] - range[0]));
  std::cout << "depths: " << range[0] << " to " << range[1]
            << ", pixels beyond a hundredth of that: " << off.beyond << "\n";
  checks.Expect(range[0] > 0.0 && range[1] == 1.0, "range of depths");
  checks.Expect(off.beyond <= 60, "the depths are VTK's, but for edges");

  scene.mapper->SetDepthImageScalarTypeToUnsignedShort();
  vtkNew<vtkImageData> shorts;
  scene.mapper->GetDepthImage(shorts);
  checks.Equal(shorts->GetScalarType(), VTK_UNSIGNED_SHORT, "type of depths");
  for (vtkIdType i = 0; i < shorts->GetNumberOfPoints(); i += 97)
  {
    checks.Expect(std::abs(shorts->GetPointData()->GetScalars()->GetTuple1(i) -
                    65535.0 * scene.ours->GetPointData()->GetScalars()->GetTuple1(i)) <= 0.51,
      "the same depths as numbers of 16 bits");
  }
}

// The window depth at which a pixel's ray leaves the volume's bounds; 1 where it does not pass
// them.
double findBackFace(Images& scene, int x, int y)
{
  const auto toWorld = [&](double depth)
  {
    scene.renderer->SetDisplayPoint(x + 0.5, y + 0.5, depth);
    scene.renderer->DisplayToWorld();
    const double* const at = scene.renderer->GetWorldPoint();
    return std::array<double, 3>{ at[0] / at[3], at[1] / at[3], at[2] / at[3] };
  };
  double enter;
  double leave;
  double first[3];
  double last[3];
  int planes[2];
  if (!vtkBox::IntersectWithLine(scene.volume->GetBounds(), toWorld(0.0).data(),
        toWorld(1.0).data(), enter, leave, first, last, planes[0], planes[1]))
  {
    return 1.0;
  }
  scene.renderer->SetWorldPoint(last[0], last[1], last[2], 1.0);
  scene.renderer->WorldToDisplay();
  return scene.renderer->GetDisplayPoint()[2];
}

// VTK's mapper, against its own documentation, takes the front face.
void checkBackFace(test::Checks& checks)
{
  Images scene;
  scene.DrawBoth();
  scene.mapper->GetDepthImage(scene.ours);
  scene.mapper->ClampDepthToBackfaceOn();
  vtkNew<vtkImageData> clamped;
  scene.mapper->GetDepthImage(clamped);
  int seen = 0;
  int unlike = 0;
  for (vtkIdType i = 0; i < clamped->GetNumberOfPoints(); ++i)
  {
    const double depth = scene.ours->GetPointData()->GetScalars()->GetTuple1(i);
    const int x = static_cast<int>(i) % clamped->GetDimensions()[0];
    const int y = static_cast<int>(i) / clamped->GetDimensions()[0];
    const double expected = depth < 1.0 ? depth : findBackFace(scene, x, y);
    seen += depth < 1.0;
    unlike += std::abs(clamped->GetPointData()->GetScalars()->GetTuple1(i) - expected) > 1e-4;
  }
  checks.Expect(seen > 1000, "depths of what is seen");
  checks.Expect(unlike <= 20, "depths of the back face elsewhere: " + std::to_string(unlike));
}

// Ours has floats too, which are those of the bytes, and beyond the bounds nothing.
void checkFloats(test::Checks& checks)
{
  Images scene;
  scene.DrawBoth();
  scene.mapper->GetColorImage(scene.ours);
  vtkNew<vtkImageData> floats;
  scene.mapper->SetColorImageScalarTypeToFloat();
  scene.mapper->GetColorImage(floats);
  checks.Equal(floats->GetScalarType(), VTK_FLOAT, "type of floats");
  vtkDataArray* bytes = scene.ours->GetPointData()->GetScalars();
  vtkDataArray* colors = floats->GetPointData()->GetScalars();
  double most = 0.0;
  int drawn = 0;
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    const bool isWhite = bytes->GetTuple4(i)[3] == 0.0; // beyond
    drawn += isWhite ? 0 : 1;
    for (int c = 0; c < 4; ++c)
    {
      const double found = 255.0 * colors->GetComponent(i, c);
      most = std::max(most, std::abs(found - (isWhite ? 0.0 : bytes->GetComponent(i, c))));
    }
  }
  checks.Expect(drawn > 1000, "something is drawn");
  checks.Expect(most < 0.501, "floats are those of the bytes: " + std::to_string(most));
}

// Where one is asked for that there is not, it says so, and keeps what was set.
void checkMessages(test::Checks& checks)
{
  Images scene;
  test::Messages messages;
  scene.mapper->SetDepthImageScalarType(VTK_INT);
  checks.Says(messages.TakeErrors(), { "VTK_FLOAT" }, "type of depths");
  checks.Equal(scene.mapper->GetDepthImageScalarType(), VTK_FLOAT, "type of depths");
  scene.mapper->SetColorImageScalarType(VTK_INT);
  checks.Says(messages.TakeErrors(), { "VTK_FLOAT" }, "type of colors");
  checks.Equal(scene.mapper->GetColorImageScalarType(), VTK_UNSIGNED_CHAR, "type of colors");
  scene.mapper->GetColorImage(nullptr);
  checks.Says(messages.TakeErrors(), { "Expected an image" }, "no image");
}
}

int RenderToImageLikeVTK(int, char*[])
{
  test::Checks checks;
  test::KeepDisplay display;
  checkColors(checks);
  checkDepths(checks);
  checkBackFace(checks);
  checkFloats(checks);
  checkMessages(checks);
  return checks.Status();
}
