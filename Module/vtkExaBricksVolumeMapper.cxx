// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolumeMapper.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/FirstSeen.h"
#include "Adapters/LightingInput.h"
#include "Adapters/ViewInput.h"
#include "vtkExaBricksVolumeMapperInternals.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkGarbageCollector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkExaBricksVolumeMapper);

vtkExaBricksVolumeMapper::vtkExaBricksVolumeMapper()
  : Internals(new vtkInternals(this))
{
}

vtkExaBricksVolumeMapper::~vtkExaBricksVolumeMapper()
{
  this->SetDevice(nullptr);
  this->SetOpacityArrayName(nullptr);
  this->SetTransfer2DYAxisArray(nullptr);
}

void vtkExaBricksVolumeMapper::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  // Mapper and builder hold the same producer: without this the collector would not see the
  // builder's share, and leave the input behind.
  vtkGarbageCollectorReport(collector, this->Internals->Builder, "Builder");
}

int vtkExaBricksVolumeMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkOverlappingAMR");
  return 1;
}

void vtkExaBricksVolumeMapper::SetInputData(vtkOverlappingAMR* amr)
{
  this->SetInputDataInternal(0, amr);
}

void vtkExaBricksVolumeMapper::SetReconstruction(int reconstruction)
{
  const int clamped = vtkMath::ClampValue(reconstruction, int(BASIS), int(COMPLETED));
  if (clamped != this->Reconstruction || !this->Internals->ReconstructionChosen)
  {
    this->Internals->ReconstructionChosen = true;
    this->Reconstruction = clamped;
    this->Modified();
  }
}

void vtkExaBricksVolumeMapper::SetVectorComponent(int component)
{
  const int clamped = std::max(component, 0);
  if (clamped != this->VectorComponent)
  {
    this->VectorComponent = clamped;
    this->Modified();
  }
}

bool vtkExaBricksVolumeMapper::GetDrawn() { return this->Internals->Drawn.any(); }

const char* vtkExaBricksVolumeMapper::GetReconstructionAsString()
{
  return this->Reconstruction == NEAREST ? "Nearest"
    : this->Reconstruction == COMPLETED  ? "Completed"
                                         : "Basis";
}

const char* vtkExaBricksVolumeMapper::GetTraversalAsString()
{
  return this->Traversal == RAY_QUERY ? "RayQuery"
    : this->Traversal == KD_TREE      ? "KdTree"
                                      : "Automatic";
}

int vtkExaBricksVolumeMapper::IsRenderSupported(
  vtkRenderWindow* window, vtkVolumeProperty* vtkNotUsed(property))
{
  if (!vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    return 0;
  }
  exabricks::VolumeRenderer& renderer = this->Internals->Renderer;
  renderer.selectDevice(this->Device ? this->Device : "");
  return renderer.findDevice().empty() ? 1 : 0;
}

void vtkExaBricksVolumeMapper::GetDevices(vtkStringArray* lines)
{
  if (!lines)
  {
    return;
  }
  lines->Initialize();
  for (const std::string& line : exabricks::VolumeRenderer::listDevices())
  {
    lines->InsertNextValue(line);
  }
}

vtkExaBricksBuilder* vtkExaBricksVolumeMapper::GetBuilder() { return this->Internals->Builder; }

const char* vtkExaBricksVolumeMapper::GetDeviceName()
{
  return this->Internals->Renderer.statistics().device.c_str();
}

const char* vtkExaBricksVolumeMapper::GetTraversalUsed()
{
  switch (this->Internals->Renderer.statistics().traversal)
  {
    case exabricks::Traversal::RayQuery:
      return "RayQuery";
    case exabricks::Traversal::KdTree:
      return "KdTree";
    default:
      return "none";
  }
}

vtkIdType vtkExaBricksVolumeMapper::GetNumberOfActiveRegions()
{
  return static_cast<vtkIdType>(this->Internals->Renderer.statistics().activeRegions);
}

vtkTypeInt64 vtkExaBricksVolumeMapper::GetDeviceMemory()
{
  return static_cast<vtkTypeInt64>(this->Internals->Renderer.statistics().deviceBytes);
}

double vtkExaBricksVolumeMapper::GetUploadTime()
{
  return this->Internals->Renderer.statistics().uploadTime;
}

double vtkExaBricksVolumeMapper::GetColorTime()
{
  return this->Internals->Renderer.statistics().colorTime;
}

double vtkExaBricksVolumeMapper::GetOpacityTime()
{
  return this->Internals->Renderer.statistics().opacityTime;
}

double vtkExaBricksVolumeMapper::GetShadowTime()
{
  return this->Internals->Renderer.statistics().shadowTime;
}

double vtkExaBricksVolumeMapper::GetMarchTime()
{
  return this->Internals->Renderer.statistics().marchTime;
}

double vtkExaBricksVolumeMapper::GetUsedImageSampleDistance()
{
  return this->Internals->Coarseness.imageSampleDistance;
}

double vtkExaBricksVolumeMapper::GetUsedStepGrowth()
{
  return this->Internals->Coarseness.stepGrowth;
}

int vtkExaBricksVolumeMapper::GetLevelsLeftOut()
{
  return this->Internals->Renderer.statistics().levelsLeftOut;
}

void vtkExaBricksVolumeMapper::SetColorImageScalarType(int type)
{
  if (type != VTK_FLOAT && type != VTK_UNSIGNED_CHAR)
  {
    vtkErrorMacro("Expected VTK_FLOAT or VTK_UNSIGNED_CHAR as ColorImageScalarType, found "
      << type << ". It stays as it was.");
  }
  else if (type != this->ColorImageScalarType)
  {
    this->ColorImageScalarType = type;
    this->Modified();
  }
}

void vtkExaBricksVolumeMapper::SetDepthImageScalarType(int type)
{
  if (type != VTK_FLOAT && type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT)
  {
    vtkErrorMacro("Expected VTK_FLOAT, VTK_UNSIGNED_CHAR or VTK_UNSIGNED_SHORT as "
                  "DepthImageScalarType, found "
      << type << ". It stays as it was.");
  }
  else if (type != this->DepthImageScalarType)
  {
    this->DepthImageScalarType = type;
    this->Modified();
  }
}

void vtkExaBricksVolumeMapper::GetColorImage(vtkImageData* image)
{
  if (image)
  {
    this->Internals->Images.getColors(this->ColorImageScalarType, image);
  }
  else
  {
    vtkErrorMacro("Expected an image to put the colors into, found none.");
  }
}

void vtkExaBricksVolumeMapper::GetDepthImage(vtkImageData* image)
{
  if (image)
  {
    this->Internals->Images.getDepths(
      this->DepthImageScalarType, this->ClampDepthToBackface != 0, image);
  }
  else
  {
    vtkErrorMacro("Expected an image to put the depths into, found none.");
  }
}

vtkIdType vtkExaBricksVolumeMapper::GetNumberOfRays() { return this->Internals->Rays; }

vtkDataSet* vtkExaBricksVolumeMapper::GetDataSetInput()
{
  vtkDataSet* only = this->GetInput();
  vtkDataArray* scalars = only ? only->GetPointData()->GetScalars() : nullptr;
  const bool named = this->ScalarMode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA &&
    this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME && scalars && scalars->GetName() &&
    std::string(scalars->GetName()) == this->ArrayName;
  const bool active = this->ScalarMode == VTK_SCALAR_MODE_DEFAULT ||
    this->ScalarMode == VTK_SCALAR_MODE_USE_POINT_DATA;
  return scalars && (named || active) ? only : nullptr;
}

vtkDataSet* vtkExaBricksVolumeMapper::GetInput(int port)
{
  auto* amr = vtkOverlappingAMR::SafeDownCast(
    this->GetNumberOfInputConnections(port) > 0 ? this->GetInputDataObject(port, 0) : nullptr);
  if (amr && amr->GetNumberOfLevels() == 0)
  {
    // Programs ask it for its range before anything was drawn, where VTK has an empty image.
    this->GetInputAlgorithm(port, 0)->Update();
  }
  vtkDataSet* only = nullptr;
  std::size_t blocks = 0;
  if (amr)
  {
    exabricks::forEachBlock(amr,
      [&](vtkDataSet* block)
      {
        only = block;
        ++blocks;
      });
  }
  return blocks == 1 ? only : nullptr;
}

double* vtkExaBricksVolumeMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm(0, 0)->Update();
    vtkOverlappingAMR* amr = vtkOverlappingAMR::SafeDownCast(this->GetDataObjectInput());
    // An AMR that was never initialised has no bounds to ask for in VTK before 9.6.
    if (amr && amr->GetNumberOfLevels() > 0 && exabricks::getFirstBlock(amr))
    {
      amr->GetBounds(this->Bounds);
    }
  }
  return this->Bounds;
}

void vtkExaBricksVolumeMapper::Update(int vtkNotUsed(port))
{
  // vtkVolume updates before each picture, and Render() once more: a fault is reported once.
  const std::string fault = this->Internals->ConfigureBuilder();
  if (!fault.empty() && fault != this->Internals->ConfigurationFault)
  {
    vtkErrorMacro(<< fault << ".");
  }
  this->Internals->ConfigurationFault = fault;
  if (fault.empty())
  {
    this->Internals->Builder->Update();
  }
}

void vtkExaBricksVolumeMapper::Render(vtkRenderer* ren, vtkVolume* vol)
{
  vtkInternals& internals = *this->Internals;
  const std::string refused = internals.Report(exabricks::checkWithoutData(this, vol));
  if (!refused.empty())
  {
    internals.ReportFault(refused);
    internals.Drawn.set(ren, false);
    return;
  }
  internals.Report(exabricks::checkLights(ren, vol));
  if (internals.DrawnWithOther.is(ren) && !ren->GetSelector())
  {
    internals.ReportFault({});
    internals.Drawn.set(ren, true);
    return;
  }
  this->Update();
  if (!internals.GetBrickedVolume())
  {
    internals.DropVolume();
    internals.Drawn.set(ren, false);
    return; // the builder has reported why, or was aborted
  }
  if (ren->GetRenderWindow()->CheckAbortStatus())
  {
    internals.Drawn.set(ren, false);
    return;
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  const double start = vtkTimerLog::GetUniversalTime();
  internals.Aborted = false;
  const auto bricked = internals.FindShown(vol->GetProperty()); // an observer may have changed it
  if (!bricked)
  {
    internals.Drawn.set(ren, false);
  }
  else if (const std::optional<std::string> fault = internals.Draw(ren, vol, bricked))
  {
    internals.ReportFault(*fault);
    if (!ren->GetSelector())
    {
      internals.Drawn.set(ren, fault->empty());
    }
  }
  else if (internals.Aborted)
  {
    internals.Drawn.set(ren, false);
  }
  this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
}

std::optional<exabricks::FirstSeen> vtkExaBricksVolumeMapper::FindFirstSeen(
  vtkRenderer* ren, vtkVolume* vol, double displayX, double displayY, double opacity)
{
  vtkInternals& internals = *this->Internals;
  const std::string refused = internals.Report(exabricks::checkWithoutData(this, vol));
  if (!refused.empty())
  {
    internals.ReportFault(refused);
    return std::nullopt;
  }
  this->Update();
  const auto bricked = internals.FindShown(vol->GetProperty());
  if (!bricked)
  {
    return std::nullopt;
  }
  std::string fault = internals.CheckData(vol->GetProperty(), *bricked);
  std::optional<exabricks::FirstSeen> found;
  try
  {
    const auto place = exabricks::findPlace(ren, displayX, displayY);
    if (fault.empty() && place)
    {
      internals.UpdateRenderer(vol->GetProperty(), bricked);
      found = exabricks::findFirstSeen(internals.Renderer,
        internals.MakeView(ren, vol, *bricked, place->width, place->height), *place,
        glm::dvec3(bricked->volume.structure->tree.size), opacity, fault);
    }
  }
  catch (const std::bad_alloc&)
  {
    internals.Bricked.reset();
    fault = "out of memory on the host. Read fewer levels";
  }
  if (!fault.empty())
  {
    internals.ReportFault(fault);
  }
  return found;
}

void vtkExaBricksVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Compositor.release(window);
  this->Internals->Renderer.release();
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkExaBricksVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reconstruction: " << this->GetReconstructionAsString() << "\n";
  os << indent << "StepScale: " << this->StepScale << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << " ("
     << this->MinimumImageSampleDistance << " to " << this->MaximumImageSampleDistance << ")\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "InteractiveAdjustSampleDistances: " << this->InteractiveAdjustSampleDistances
     << "\n";
  os << indent << "InteractiveUpdateRate: " << this->InteractiveUpdateRate << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "Traversal: " << this->GetTraversalAsString() << "\n";
  os << indent << "EarlyTerminationOpacity: " << this->EarlyTerminationOpacity << "\n";
  os << indent << "VectorMode: " << vtkExaBricksBuilder::GetVectorModeAsString(this->VectorMode)
     << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent
     << "OpacityArrayName: " << (this->OpacityArrayName ? this->OpacityArrayName : "(none)")
     << "\n";
  os << indent << "OpacityComponent: " << this->OpacityComponent << "\n";
  os << indent << "Transfer2DYAxisArray: "
     << (this->Transfer2DYAxisArray ? this->Transfer2DYAxisArray : "(none)") << "\n";
  os << indent << "UseNanColor: " << this->UseNanColor << "\n";
  os << indent << "GlobalIlluminationReach: " << this->GlobalIlluminationReach << "\n";
  os << indent << "VolumetricScatteringBlending: " << this->VolumetricScatteringBlending << "\n";
  os << indent << "LevelRange: " << this->LevelRange[0] << ", " << this->LevelRange[1] << "\n";
  os << indent << "FinalColorWindow: " << this->FinalColorWindow << "\n";
  os << indent << "FinalColorLevel: " << this->FinalColorLevel << "\n";
  os << indent << "RenderToImage: " << (this->RenderToImage ? "on" : "off") << "\n";
  os << indent
     << "ColorImageScalarType: " << vtkImageScalarTypeNameMacro(this->ColorImageScalarType) << "\n";
  os << indent
     << "DepthImageScalarType: " << vtkImageScalarTypeNameMacro(this->DepthImageScalarType) << "\n";
  os << indent << "ClampDepthToBackface: " << (this->ClampDepthToBackface ? "on" : "off") << "\n";
  os << indent << "Device: " << (this->Device ? this->Device : "(best)") << "\n";
  os << indent << "Drawn: " << this->GetDrawn() << "\n";
  os << indent << "DeviceName: " << this->GetDeviceName() << "\n";
  os << indent << "TraversalUsed: " << this->GetTraversalUsed() << "\n";
  os << indent << "NumberOfActiveRegions: " << this->GetNumberOfActiveRegions() << "\n";
  os << indent << "LevelsLeftOut: " << this->GetLevelsLeftOut() << "\n";
  os << indent << "NumberOfRays: " << this->GetNumberOfRays() << "\n";
  os << indent << "DeviceMemory: " << this->GetDeviceMemory() << " bytes\n";
}
