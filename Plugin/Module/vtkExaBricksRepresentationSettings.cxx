// SPDX-License-Identifier: BSD-3-Clause
// What the panel sets of the representation's volume: handed on to its property and its mapper.
#include "vtkExaBricksRedistribute.h"
#include "vtkExaBricksRepresentation.h"
#include "vtkExaBricksVolume.h"
#include "vtkExaBricksVolumeMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkImplicitFunction.h"
#include "vtkPVTransferFunction2D.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

namespace
{
// What is set for one component is set for all: there is one color map, and one material.
template <typename Set>
void forEachComponent(const Set& set)
{
  for (int component = 0; component < VTK_MAX_VRCOMP; ++component)
  {
    set(component);
  }
}
}

void vtkExaBricksRepresentation::SetColor(vtkColorTransferFunction* color)
{
  forEachComponent([&](int component) { this->Property->SetColor(component, color); });
}

void vtkExaBricksRepresentation::SetScalarOpacity(vtkPiecewiseFunction* opacity)
{
  forEachComponent([&](int component) { this->Property->SetScalarOpacity(component, opacity); });
}

void vtkExaBricksRepresentation::SetScalarOpacityUnitDistance(double distance)
{
  forEachComponent(
    [&](int component) { this->Property->SetScalarOpacityUnitDistance(component, distance); });
}

void vtkExaBricksRepresentation::SetShading(bool shading)
{
  forEachComponent([&](int component) { this->Property->SetShade(component, shading); });
}

void vtkExaBricksRepresentation::SetAmbient(double ambient)
{
  forEachComponent([&](int component) { this->Property->SetAmbient(component, ambient); });
}

void vtkExaBricksRepresentation::SetDiffuse(double diffuse)
{
  forEachComponent([&](int component) { this->Property->SetDiffuse(component, diffuse); });
}

void vtkExaBricksRepresentation::SetSpecular(double specular)
{
  forEachComponent([&](int component) { this->Property->SetSpecular(component, specular); });
}

void vtkExaBricksRepresentation::SetSpecularPower(double power)
{
  forEachComponent([&](int component) { this->Property->SetSpecularPower(component, power); });
}

void vtkExaBricksRepresentation::SetVolumetricScatteringBlending(double blending)
{
  this->Mapper->SetVolumetricScatteringBlending(static_cast<float>(blending));
}

void vtkExaBricksRepresentation::SetGlobalIlluminationReach(double reach)
{
  this->Mapper->SetGlobalIlluminationReach(static_cast<float>(reach));
}

void vtkExaBricksRepresentation::SetVolumeAnisotropy(double anisotropy)
{
  this->Property->SetScatteringAnisotropy(static_cast<float>(anisotropy));
}

void vtkExaBricksRepresentation::SetNumberOfIsosurfaceValues(int count)
{
  this->Property->GetIsoSurfaceValues()->SetNumberOfContours(count);
}

void vtkExaBricksRepresentation::SetIsosurfaceValue(int number, double value)
{
  this->Property->GetIsoSurfaceValues()->SetValue(number, value);
}

void vtkExaBricksRepresentation::SetSliceFunction(vtkImplicitFunction* function)
{
  this->Property->SetSliceFunction(function);
}

void vtkExaBricksRepresentation::SetComponents(int components)
{
  this->Components = components;
  this->Property->SetIndependentComponents(components != DEPENDENT);
}

void vtkExaBricksRepresentation::SetUseSeparateOpacityArray(bool use)
{
  this->UseSeparateOpacityArray = use;
}

void vtkExaBricksRepresentation::OtherArray::Select(int ofAssociation, const char* ofName)
{
  this->association = ofAssociation;
  this->name = ofName ? ofName : "";
}

void vtkExaBricksRepresentation::SelectOpacityArray(
  int, int, int, int association, const char* name)
{
  this->OpacityArray.Select(association, name);
}

void vtkExaBricksRepresentation::SelectOpacityArrayComponent(int component)
{
  this->OpacityArray.component = component;
}

void vtkExaBricksRepresentation::SetUseTransfer2D(bool use) { this->UseTransfer2D = use; }

void vtkExaBricksRepresentation::SetTransferFunction2D(vtkPVTransferFunction2D* function)
{
  this->TransferFunction2D = function;
}

void vtkExaBricksRepresentation::SetUseGradientForTransfer2D(bool use)
{
  this->UseGradientForTransfer2D = use;
}

void vtkExaBricksRepresentation::SelectColorArray2(int, int, int, int association, const char* name)
{
  this->ColorArray2.Select(association, name);
}

void vtkExaBricksRepresentation::SelectColorArray2Component(int component)
{
  this->ColorArray2.component = component;
}

void vtkExaBricksRepresentation::SetUseNanColor(bool use) { this->Mapper->SetUseNanColor(use); }

void vtkExaBricksRepresentation::SetLevelRange(int first, int last)
{
  // Of several ranks each has what the levels leave it.
  const bool several = this->IsOneOfSeveral();
  this->Mapper->SetLevelRange(several ? 0 : first, several ? VTK_INT_MAX : last);
  if (several)
  {
    this->Redistribute->SetLevelRange(first, last);
    this->MarkModified();
  }
}

void vtkExaBricksRepresentation::SetCropping(bool cropping) { this->Mapper->SetCropping(cropping); }

void vtkExaBricksRepresentation::SetCroppingRegionPlanes(
  double lowerX, double upperX, double lowerY, double upperY, double lowerZ, double upperZ)
{
  this->Mapper->SetCroppingRegionPlanes(lowerX, upperX, lowerY, upperY, lowerZ, upperZ);
}

void vtkExaBricksRepresentation::SetCroppingRegionFlags(int flags)
{
  this->Mapper->SetCroppingRegionFlags(flags);
}

void vtkExaBricksRepresentation::SetReconstruction(int reconstruction)
{
  const bool wasCompleted =
    this->Mapper->GetReconstruction() == vtkExaBricksVolumeMapper::COMPLETED;
  this->Mapper->SetReconstruction(reconstruction);
  const bool isCompleted = reconstruction == vtkExaBricksVolumeMapper::COMPLETED;
  if (this->IsOneOfSeveral() && wasCompleted != isCompleted)
  {
    this->MarkModified(); // other cells around each part are needed
  }
}

void vtkExaBricksRepresentation::SetBlendMode(int mode) { this->Mapper->SetBlendMode(mode); }

void vtkExaBricksRepresentation::SetStepScale(double scale) { this->Mapper->SetStepScale(scale); }

void vtkExaBricksRepresentation::SetErrorTolerance(double tolerance)
{
  // Each of several ranks would choose steps, and levels to leave out, by its own part of the
  // picture, and the parts would not fit together.
  this->Mapper->SetErrorTolerance(this->IsOneOfSeveral() ? 0.0 : tolerance);
}

void vtkExaBricksRepresentation::SetTraversal(int traversal)
{
  this->Mapper->SetTraversal(traversal);
}

void vtkExaBricksRepresentation::SetEarlyTerminationOpacity(double opacity)
{
  this->Mapper->SetEarlyTerminationOpacity(opacity);
}

void vtkExaBricksRepresentation::SetDevice(const char* device)
{
  this->Mapper->SetDevice(device && device[0] ? device : nullptr);
}
