// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksFirstPicture.h"

#include "Adapters/BrickedVolume.h"
#include "Adapters/ColorMaps.h"
#include "Adapters/CoveredCells.h"
#include "Adapters/Logarithm.h"
#include "Adapters/PropertyInput.h"
#include "Core/FirstPicture.h"
#include "Core/LowerCase.h"
#include "vtkExaBricksData.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkExaBricksFirstPicture);

vtkExaBricksFirstPicture::vtkExaBricksFirstPicture()
  : ScalarOpacity(vtkPiecewiseFunction::New())
{
}

vtkExaBricksFirstPicture::~vtkExaBricksFirstPicture() { this->ScalarOpacity->Delete(); }

bool vtkExaBricksFirstPicture::Choose(vtkExaBricksData* data)
{
  const auto bricked = data ? data->GetBrickedVolume() : nullptr;
  if (!bricked || bricked->volume.values->range.empty())
  {
    vtkErrorMacro("Expected data with a cell that has a value, found "
      << (!data ? "no data" : "none")
      << ". Update the mapper or builder first, and choose an array with values.");
    return false;
  }
  const exabricks::FirstPicture chosen = exabricks::chooseFirstPicture(
    bricked->volume, bricked->spacing, this->Logarithmic, exabricks::toBlending(this->BlendMode));
  this->LogarithmWanted = !this->Logarithmic && exabricks::wantsLogarithm(*bricked->volume.values);
  this->ColorRange[0] = chosen.colors.min;
  this->ColorRange[1] = chosen.colors.max;
  this->ScalarOpacityUnitDistance = chosen.unitDistance;
  this->ScalarOpacity->RemoveAllPoints();
  for (const exabricks::OpacityPoint& point : chosen.opacity)
  {
    this->ScalarOpacity->AddPoint(point.value, point.opacity);
  }
  const glm::dvec3 lo = bricked->world(chosen.lo);
  const glm::dvec3 hi = bricked->world(chosen.hi);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->ShownBounds[2 * axis] = lo[axis];
    this->ShownBounds[2 * axis + 1] = hi[axis];
  }
  this->Modified();
  return true;
}

void vtkExaBricksFirstPicture::SetColorMap(const std::string& name)
{
  if (!HasColorMap(name))
  {
    vtkErrorMacro("Expected one of the color maps " << GetColorMapNames() << ", found '" << name
                                                    << "'. It stays " << this->ColorMap << ".");
    return;
  }
  if (this->ColorMap != name)
  {
    this->ColorMap = name;
    this->Modified();
  }
}

std::string vtkExaBricksFirstPicture::GetColorMapNames() { return exabricks::colorMapNames(); }

bool vtkExaBricksFirstPicture::HasColorMap(const std::string& name)
{
  return exabricks::hasColorMap(name);
}

void vtkExaBricksFirstPicture::FillColorMap(
  const std::string& name, const double range[2], vtkColorTransferFunction* colors)
{
  if (!colors)
  {
    vtkGenericWarningMacro("Expected a color function to fill, found none.");
    return;
  }
  double spread[2] = { range[0], range[1] };
  if (!(spread[0] < spread[1]))
  {
    const double half = std::max(1e-6 * std::abs(spread[0]), 1e-30);
    spread[0] -= half;
    spread[1] += half;
  }
  exabricks::fillColorMap(name, spread, colors);
}

int vtkExaBricksFirstPicture::GetArrayPreference(const std::string& array)
{
  const std::array<std::string, 5> known{ "density", "dens", "rho", "temperature", "temp" };
  return static_cast<int>(
    known.end() - std::find(known.begin(), known.end(), exabricks::lowerCase(array)));
}

bool vtkExaBricksFirstPicture::IsVolumeFraction(const std::string& array)
{
  return exabricks::isVolumeFraction(array.c_str());
}

vtkIdType vtkExaBricksFirstPicture::HideCoveredCells(vtkOverlappingAMR* amr)
{
  return amr ? exabricks::hideCoveredCells(amr) : 0;
}

std::string vtkExaBricksFirstPicture::AddLogarithm(
  vtkOverlappingAMR* amr, const std::string& array, int component)
{
  return amr ? exabricks::addLogarithm(amr, array, component) : std::string();
}

void vtkExaBricksFirstPicture::InitializeProperty(vtkVolumeProperty* property)
{
  if (!property)
  {
    vtkErrorMacro("Expected a volume property to initialize, found none.");
    return;
  }
  for (int component = 0; component < VTK_MAX_VRCOMP; ++component)
  {
    vtkNew<vtkColorTransferFunction> colors;
    FillColorMap(this->ColorMap, this->ColorRange, colors);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->DeepCopy(this->ScalarOpacity);
    property->SetColor(component, colors);
    property->SetScalarOpacity(component, opacity);
    property->SetScalarOpacityUnitDistance(component, this->ScalarOpacityUnitDistance);
  }
  property->SetInterpolationTypeToLinear();
}

void vtkExaBricksFirstPicture::InitializeCamera(vtkCamera* camera, double aspect)
{
  if (!camera || !(aspect > 0.0))
  {
    vtkErrorMacro("Expected a camera and a width of the picture by its height above 0, found "
      << (camera ? "a camera" : "none") << " and " << aspect << ".");
    return;
  }
  const double* const b = this->ShownBounds;
  const double middle[3] = { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) };
  const double away = vtkMath::Norm(middle) + 1.0; // so that rounding leaves a direction
  camera->SetFocalPoint(middle);
  camera->SetPosition(middle[0] + away, middle[1] - away, middle[2] + away);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->OrthogonalizeViewUp();
  FitCamera(camera, this->ShownBounds, aspect);
}

void vtkExaBricksFirstPicture::FitCamera(vtkCamera* camera, const double bounds[6], double aspect)
{
  constexpr double Margin = 1.05;
  double focal[3];
  double back[3];
  double up[3];
  double right[3];
  camera->GetFocalPoint(focal);
  camera->GetDirectionOfProjection(back);
  vtkMath::MultiplyScalar(back, -1.0);
  camera->GetViewUp(up);
  vtkMath::Cross(up, back, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(back, right, up);
  const double slope = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  double distance = 0.0;
  double scale = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double d[3]; // from the focal point
    for (int axis = 0; axis < 3; ++axis)
    {
      d[axis] = bounds[2 * axis + (corner >> axis & 1)] - focal[axis];
    }
    const double half =
      Margin * std::max(std::abs(vtkMath::Dot(d, up)), std::abs(vtkMath::Dot(d, right)) / aspect);
    distance = std::max(distance, vtkMath::Dot(d, back) + half / slope);
    scale = std::max(scale, half);
  }
  double position[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    position[axis] = focal[axis] + distance * back[axis];
  }
  camera->SetPosition(position);
  camera->SetParallelScale(scale);
}

void vtkExaBricksFirstPicture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Logarithmic: " << this->Logarithmic << "\n";
  os << indent << "LogarithmWanted: " << this->LogarithmWanted << "\n";
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "ColorMap: " << this->ColorMap << "\n";
  os << indent << "ColorRange: " << this->ColorRange[0] << " " << this->ColorRange[1] << "\n";
  os << indent << "ScalarOpacityUnitDistance: " << this->ScalarOpacityUnitDistance << "\n";
  os << indent << "ShownBounds: " << this->ShownBounds[0] << " " << this->ShownBounds[1] << " "
     << this->ShownBounds[2] << " " << this->ShownBounds[3] << " " << this->ShownBounds[4] << " "
     << this->ShownBounds[5] << "\n";
}
