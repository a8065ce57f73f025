// SPDX-License-Identifier: BSD-3-Clause
// A window with a volume to look at, and its pixels as numbers.
#ifndef ExaBricksTestingStage_h
#define ExaBricksTestingStage_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeSource.h"
#include "vtkExaBricksVolumeMapper.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace test
{
constexpr double OneStep = 1.0 / 255.0; // of a colour on the screen

/// The colours of a window's pixels, in [0, 1]; row 0 at the bottom.
class Picture
{
public:
  using Color = std::array<double, 3>;

  /// Renders and reads.
  explicit Picture(vtkRenderWindow* window)
  {
    window->Render();
    this->Width = window->GetSize()[0];
    this->Height = window->GetSize()[1];
    vtkNew<vtkUnsignedCharArray> bytes;
    window->GetPixelData(0, 0, this->Width - 1, this->Height - 1, 1, bytes);
    this->Bytes.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
  }

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

  Color At(int x, int y) const
  {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * this->Width + x);
    return { this->Bytes[at] * OneStep, this->Bytes[at + 1] * OneStep,
      this->Bytes[at + 2] * OneStep };
  }
  Color Center() const { return this->At(this->Width / 2, this->Height / 2); }

  /// Mean colour of the pixels from (x0, y0) to, without, (x1, y1); without them, of all.
  Color Mean(int x0 = 0, int y0 = 0, int x1 = -1, int y1 = -1) const
  {
    x1 = x1 < 0 ? this->Width : x1;
    y1 = y1 < 0 ? this->Height : y1;
    Color sum{ 0.0, 0.0, 0.0 };
    for (int y = y0; y < y1; ++y)
    {
      for (int x = x0; x < x1; ++x)
      {
        const Color color = this->At(x, y);
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += color[c] / ((x1 - x0) * (y1 - y0));
        }
      }
    }
    return sum;
  }

  /// Part of the pixels that are not black.
  double Coverage() const
  {
    int covered = 0;
    for (int y = 0; y < this->Height; ++y)
    {
      for (int x = 0; x < this->Width; ++x)
      {
        covered += this->At(x, y) != Color{ 0.0, 0.0, 0.0 };
      }
    }
    return static_cast<double>(covered) / (this->Width * this->Height);
  }

  /// Greatest difference in any channel of any pixel; 1 if the sizes differ.
  double Difference(const Picture& other) const
  {
    if (this->Width != other.Width || this->Height != other.Height)
    {
      return 1.0;
    }
    int most = 0;
    for (std::size_t i = 0; i < this->Bytes.size(); ++i)
    {
      most = std::max(most, std::abs(int(this->Bytes[i]) - int(other.Bytes[i])));
    }
    return most * OneStep;
  }

  /// Peak signal-to-noise ratio over the pixels that are not black in both.
  double Decibel(const Picture& other) const
  {
    double squares = 0.0;
    int drawn = 0;
    for (std::size_t i = 0; i < this->Bytes.size(); i += 3)
    {
      int most = 0;
      for (std::size_t c = i; c < i + 3; ++c)
      {
        most = std::max<int>({ most, this->Bytes[c], other.Bytes[c] });
        squares += std::pow((int(this->Bytes[c]) - int(other.Bytes[c])) * OneStep, 2) / 3.0;
      }
      drawn += most > 0;
    }
    return -10.0 * std::log10(squares / drawn);
  }

private:
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;
};

/// Makes every value this colour and this opacity of a unit distance.
inline void setConstantColor(
  vtkVolumeProperty* property, double opacity, const Picture::Color& color = { 1.0, 1.0, 1.0 })
{
  property->GetRGBTransferFunction()->RemoveAllPoints();
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, color[0], color[1], color[2]);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, opacity);
}

/// From blue and transparent to red and half opaque.
inline void setRamp(vtkVolumeProperty* property, double least, double most)
{
  property->GetRGBTransferFunction()->RemoveAllPoints();
  property->GetRGBTransferFunction()->AddRGBPoint(least, 0.1, 0.2, 1.0);
  property->GetRGBTransferFunction()->AddRGBPoint(most, 1.0, 0.3, 0.1);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(least, 0.0);
  property->GetScalarOpacity()->AddPoint(most, 0.5);
}

/// Opacity of a ray of `length` through a medium that has `opacity` on a length of `unit`.
inline double opacityOf(double opacity, double length, double unit = 1.0)
{
  return 1.0 - std::pow(1.0 - opacity, length / unit);
}

/// One volume in one black window.
struct Stage
{
  vtkNew<vtkExaBricksVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;

  explicit Stage(int size = 100)
  {
    this->window->SetMultiSamples(0); // sample counts differ between drivers
    this->window->SetSize(size, size);
    this->window->AddRenderer(this->renderer);
    this->volume->SetMapper(this->mapper);
    this->renderer->AddVolume(this->volume);
    // A property makes functions with nodes at 0 and 1024 unless it is given some.
    this->Property()->SetColor(vtkNew<vtkColorTransferFunction>());
    this->Property()->SetScalarOpacity(vtkNew<vtkPiecewiseFunction>());
    this->Property()->SetInterpolationTypeToLinear();
  }

  explicit Stage(vtkOverlappingAMR* amr, int size = 100)
    : Stage(size)
  {
    this->mapper->SetInputData(amr);
  }

  vtkVolumeProperty* Property() { return this->volume->GetProperty(); }
};

/// A window that is there all the while: Xvfb starts anew when its last client has left, and
/// refuses windows meanwhile.
struct KeepDisplay
{
  vtkNew<vtkRenderWindow> window;

  KeepDisplay()
  {
    this->window->SetSize(10, 10);
    this->window->Render();
  }
};

/// Adds a solid box.
inline vtkSmartPointer<vtkActor> addBox(
  vtkRenderer* renderer, double x0, double x1, double y0, double y1, double z0, double z1)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(x0, x1, y0, y1, z0, z1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(box->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

/// Looks along -z, in parallel projection, at a square of `width` around (x, y, z).
inline void lookAlongZ(vtkRenderer* renderer, double x, double y, double z, double width)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * width);
  camera->SetFocalPoint(x, y, z);
  camera->SetPosition(x, y, z + 10.0 * width);
  camera->SetViewUp(0.0, 1.0, 0.0);
  renderer->ResetCameraClippingRange();
}
}

#endif
