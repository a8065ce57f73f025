// SPDX-License-Identifier: BSD-3-Clause

#include "Picture.h"

#include "Annotation.h"
#include "Framing.h"
#include "Messages.h"
#include "Output.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"
#include "vtkExaBricksFirstPicture.h"
#include "vtkExaBricksVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace render
{

namespace
{

double inSeconds(std::chrono::steady_clock::time_point since)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

}

Picture::Picture(const Options& options, vtkRenderWindow* window, vtkOverlappingAMR* amr,
  const std::string& array, int components)
  : Asked(options)
  , VolumeMapper(vtkSmartPointer<vtkExaBricksVolumeMapper>::New())
  , Chosen(vtkSmartPointer<vtkExaBricksFirstPicture>::New())
  , Volume(vtkSmartPointer<vtkVolume>::New())
  , Ren(vtkSmartPointer<vtkRenderer>::New())
  , Window(window)
{
  this->VolumeMapper->SetInputDataObject(amr);
  this->SetUpMapper(array, components);
  this->Volume->SetMapper(this->VolumeMapper);
  this->Ren->AddVolume(this->Volume);
  this->Ren->SetBackground(options.Background.data());
  this->Window->SetSize(options.Size[0], options.Size[1]);
  this->Window->AddRenderer(this->Ren);
}

Picture::~Picture() { this->Window->RemoveRenderer(this->Ren); }

bool Picture::LogarithmWanted() const { return this->Chosen->GetLogarithmWanted(); }

vtkExaBricksVolumeMapper* Picture::Mapper() const { return this->VolumeMapper; }

vtkRenderer* Picture::Renderer() const { return this->Ren; }

vtkExaBricksData* Picture::Data() const { return this->VolumeMapper->GetBuilder()->GetOutput(); }

void Picture::SetUpMapper(const std::string& array, int components)
{
  vtkExaBricksVolumeMapper* mapper = this->VolumeMapper;
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray(array.c_str());
  if (components > 1 && this->Asked.Component)
  {
    mapper->SetVectorModeToComponent();
    mapper->SetVectorComponent(*this->Asked.Component);
  }
  else
  {
    mapper->SetVectorModeToMagnitude();
  }

  if (this->Asked.Reconstruction == "nearest")
  {
    mapper->SetReconstructionToNearest();
  }
  else if (this->Asked.Reconstruction == "completed")
  {
    mapper->SetReconstructionToCompleted();
  }
  else
  {
    mapper->SetReconstructionToBasis();
  }
  if (this->Asked.Traversal == "ray-query")
  {
    mapper->SetTraversalToRayQuery();
  }
  else if (this->Asked.Traversal == "kd-tree")
  {
    mapper->SetTraversalToKdTree();
  }
  else
  {
    mapper->SetTraversalToAutomatic();
  }
  this->SetUpBlending();
  if (this->Asked.LevelRange)
  {
    mapper->SetLevelRange((*this->Asked.LevelRange)[0], (*this->Asked.LevelRange)[1]);
  }
  for (const Plane& cut : this->Asked.ClippingPlanes)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(cut.Origin.data());
    plane->SetNormal(cut.Normal.data());
    mapper->AddClippingPlane(plane);
  }
  if (this->Asked.Cropping)
  {
    mapper->CroppingOn();
    mapper->SetCroppingRegionPlanes(this->Asked.Cropping->data());
  }
  if (this->Asked.StepScale > 0.0)
  {
    mapper->SetStepScale(this->Asked.StepScale);
  }
  mapper->SetErrorTolerance(this->Asked.ErrorTolerance);
  mapper->SetVolumetricScatteringBlending(static_cast<float>(this->Asked.Scattering));
  mapper->SetGlobalIlluminationReach(static_cast<float>(this->Asked.ShadowReach));
  if (!this->Asked.Device.empty())
  {
    mapper->SetDevice(this->Asked.Device.c_str());
  }
}

void Picture::SetUpBlending()
{
  const std::string& mode = this->Asked.BlendMode;
  vtkExaBricksVolumeMapper* mapper = this->VolumeMapper;
  if (mode == "maximum")
  {
    mapper->SetBlendModeToMaximumIntensity();
  }
  else if (mode == "minimum")
  {
    mapper->SetBlendModeToMinimumIntensity();
  }
  else if (mode == "average")
  {
    mapper->SetBlendModeToAverageIntensity();
  }
  else if (mode == "additive")
  {
    mapper->SetBlendModeToAdditive();
  }
  else if (mode == "isosurface")
  {
    mapper->SetBlendModeToIsoSurface();
    vtkContourValues* values = this->Volume->GetProperty()->GetIsoSurfaceValues();
    for (std::size_t i = 0; i < this->Asked.IsoValues.size(); ++i)
    {
      const double value = this->Asked.IsoValues[i];
      values->SetValue(static_cast<int>(i), this->Asked.Log ? std::log10(value) : value);
    }
  }
  else if (mode == "slice")
  {
    mapper->SetBlendModeToSlice();
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(this->Asked.Slice->Origin.data());
    plane->SetNormal(this->Asked.Slice->Normal.data());
    this->Volume->GetProperty()->SetSliceFunction(plane);
  }
  else if (mode != "composite")
  {
    throw Failure(ExitCode::BadArguments,
      "'" + mode +
        "' is no blend mode: choose of composite, maximum, minimum, average, additive, "
        "isosurface, slice.");
  }
}

void Picture::Prepare()
{
  Progress progress("Building bricks and regions", this->Asked.Quiet);
  progress.Follow(this->VolumeMapper->GetBuilder());
  const auto start = std::chrono::steady_clock::now();
  this->VolumeMapper->Update();
  this->PrepareTime = inSeconds(start);
  throwIfErrors(ExitCode::RenderingFailed, "The data could not be made ready for drawing");
  vtkExaBricksData* data = this->Data();
  if (!data || data->GetNumberOfLeafCells() <= data->GetNumberOfAbsentCells())
  {
    throw Failure(ExitCode::RenderingFailed,
      this->Asked.Log ? "No cell holds a number above zero: draw the array without --log."
                      : "No cell of the array holds a number: choose another array.");
  }

  this->Chosen->SetLogarithmic(this->Asked.Log);
  this->Chosen->SetBlendMode(this->VolumeMapper->GetBlendMode());
  this->Chosen->Choose(data);
  this->Chosen->GetColorRange(this->ColorRange);
  this->OpacityUnit = this->Asked.OpacityUnit > 0.0 ? this->Asked.OpacityUnit
                                                    : this->Chosen->GetScalarOpacityUnitDistance();
  this->ChooseOpacity();
  double bounds[6];
  data->GetBounds(bounds);
  double shown[6];
  std::copy_n(this->ShowsAsChosen() ? this->Chosen->GetShownBounds() : bounds, 6, shown);
  if (this->Asked.Range)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double value = (*this->Asked.Range)[i];
      this->ColorRange[i] = this->Asked.Log ? std::log10(value) : value;
    }
  }
  this->ApplyProperty();
  placeCamera(this->Asked, shown, this->Ren->GetActiveCamera());
  this->Ren->ResetCameraClippingRange(bounds);
}

// What shows with opacities of one's own is not known.
bool Picture::ShowsAsChosen() const { return this->Asked.Opacity.empty(); }

void Picture::ChooseOpacity()
{
  this->Opacity = this->Asked.Opacity;
  if (this->Opacity.empty())
  {
    // Of several surfaces those behind show through.
    const double part = this->Asked.IsoValues.size() > 1 ? 0.5 : 1.0;
    vtkPiecewiseFunction* chosen = this->Chosen->GetScalarOpacity();
    for (int i = 0; i < chosen->GetSize(); ++i)
    {
      double node[4];
      chosen->GetNodeValue(i, node);
      this->Opacity.push_back({ node[0], part * node[1] });
    }
  }
  else if (this->Asked.Log)
  {
    for (OpacityPoint& point : this->Opacity)
    {
      point.Value = std::log10(point.Value);
    }
  }
}

void Picture::ApplyProperty()
{
  vtkNew<vtkColorTransferFunction> colors;
  if (this->Asked.Colors.empty())
  {
    vtkExaBricksFirstPicture::FillColorMap(this->Asked.ColorMap, this->ColorRange, colors);
  }
  for (const ColorPoint& point : this->Asked.Colors)
  {
    colors->AddRGBPoint(point.Value, point.Color[0], point.Color[1], point.Color[2]);
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const OpacityPoint& point : this->Opacity)
  {
    opacity->AddPoint(point.Value, point.Opacity);
  }
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(this->OpacityUnit);
  property->SetInterpolationTypeToLinear();
  property->SetShade(this->Asked.Shaded);
}

void Picture::Annotate(const std::string& title)
{
  double bounds[6];
  this->Data()->GetBounds(bounds);
  // Bounds of all data may reach far beyond the picture.
  if (this->ShowsAsChosen())
  {
    this->Chosen->GetShownBounds(bounds);
  }
  annotate(this->Ren, bounds, this->Volume->GetProperty()->GetRGBTransferFunction(), title);
  this->Ren->ResetCameraClippingRange();
}

void Picture::DrawOther(vtkOverlappingAMR* amr)
{
  this->VolumeMapper->SetInputDataObject(amr);
  this->Ren->ResetCameraClippingRange();
  this->DrawFrame();
}

void Picture::Turn(double degrees)
{
  vtkCamera* camera = this->Ren->GetActiveCamera();
  double up[3];
  std::copy_n(camera->GetViewUp(), 3, up);
  if (this->Asked.Up && this->Asked.Scene.empty())
  {
    std::copy_n(this->Asked.Up->data(), 3, up);
  }
  else
  {
    // That of the data that is nearest to the picture's: pictures from above lean, and their
    // turntable does not.
    const auto largest =
      std::max_element(up, up + 3, [](double a, double b) { return std::abs(a) < std::abs(b); });
    const double axis[3] = { largest == up ? 1.0 : 0.0, largest == up + 1 ? 1.0 : 0.0,
      largest == up + 2 ? 1.0 : 0.0 };
    std::copy_n(axis, 3, up);
  }
  const double* const focal = camera->GetFocalPoint();
  vtkNew<vtkTransform> turn;
  turn->Translate(focal);
  turn->RotateWXYZ(degrees, up);
  turn->Translate(-focal[0], -focal[1], -focal[2]);
  camera->ApplyTransform(turn);
  this->Ren->ResetCameraClippingRange();
  this->DrawFrame();
}

double Picture::DrawFrame()
{
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const double seconds = inSeconds(start);
  throwIfErrors(ExitCode::RenderingFailed, "The picture could not be drawn");
  return seconds;
}

void Picture::Draw()
{
  Progress progress("Drawing", this->Asked.Quiet);
  this->FirstFrameTime = this->DrawFrame();
  for (int frame = 0; frame < this->Asked.Frames; ++frame)
  {
    this->FrameTimes.push_back(this->DrawFrame());
    progress.Show((frame + 1.0) / this->Asked.Frames);
  }
}

double Picture::MedianFrameTime() const
{
  std::vector<double> sorted = this->FrameTimes;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  return n == 0 ? 0.0 : 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
}

vtkSmartPointer<vtkImageData> Picture::Pixels() const
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  throwIfErrors(ExitCode::RenderingFailed, "The picture could not be read from the window");
  return grab->GetOutput();
}

vtkSmartPointer<vtkImageData> Picture::Floats()
{
  vtkNew<vtkImageData> image;
  this->VolumeMapper->RenderToImageOn();
  this->VolumeMapper->SetColorImageScalarTypeToFloat();
  this->DrawFrame();
  this->VolumeMapper->GetColorImage(image);
  this->VolumeMapper->RenderToImageOff();
  return image;
}

vtkSmartPointer<vtkImageData> Picture::Result()
{
  return holdsFloats(this->Asked.Output) ? this->Floats() : this->Pixels();
}

}
