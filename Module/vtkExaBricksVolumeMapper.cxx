// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolumeMapper.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/BrickedVolume.h"
#include "Adapters/Compositor.h"
#include "Adapters/DrawnRenderers.h"
#include "Adapters/Requests.h"
#include "Adapters/TransferFunctionInput.h"
#include "Adapters/ViewInput.h"
#include "Core/Completion.h"
#include "Vulkan/VolumeRenderer.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkGarbageCollector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

vtkStandardNewMacro(vtkExaBricksVolumeMapper);

static_assert(static_cast<int>(vtkExaBricksVolumeMapper::MAGNITUDE) ==
      static_cast<int>(vtkExaBricksBuilder::MAGNITUDE) &&
    static_cast<int>(vtkExaBricksVolumeMapper::COMPONENT) ==
      static_cast<int>(vtkExaBricksBuilder::COMPONENT),
  "the mapper hands its vector mode to the builder");

static_assert(static_cast<int>(vtkExaBricksVolumeMapper::NEAREST) ==
      static_cast<int>(exabricks::Reconstruction::Nearest) &&
    static_cast<int>(vtkExaBricksVolumeMapper::COMPLETED) ==
      static_cast<int>(exabricks::Reconstruction::Completed),
  "the mapper hands its reconstruction to the renderer");

struct vtkExaBricksVolumeMapper::vtkInternals
{
  vtkSmartPointer<vtkExaBricksBuilder> Builder = vtkSmartPointer<vtkExaBricksBuilder>::New();
  exabricks::VolumeRenderer Renderer;
  exabricks::Compositor Compositor;
  exabricks::DrawnRenderers Drawn;

  // What the renderer was last given.
  std::shared_ptr<const exabricks::BrickedVolume> Bricked;
  bool Completed = false;                // its values
  vtkVolumeProperty* Property = nullptr; // compared only, never followed
  vtkMTimeType PropertyTime = 0;

  bool ReconstructionChosen = false;
  bool VectorChosen = false;

  std::set<std::string> Said;     // warnings, once each
  std::string SaidFault;          // of the last picture, said once as long as it stays
  std::string ConfigurationFault; // empty if the builder has the mapper's input and array

  void WarnOnce(vtkExaBricksVolumeMapper* self, const std::string& what)
  {
    if (this->Said.insert(what).second)
    {
      vtkWarningWithObjectMacro(self, << what);
    }
  }

  // Says a fault, or that there is none any more.
  void SayFault(vtkExaBricksVolumeMapper* self, const std::string& fault)
  {
    if (!fault.empty() && fault != this->SaidFault)
    {
      vtkErrorWithObjectMacro(self, "The volume is not drawn: " << fault << ".");
    }
    this->SaidFault = fault;
  }

  // Gives back what was held of the former volume.
  void DropVolume()
  {
    this->Renderer.setVolume({});
    this->Bricked.reset();
  }

  // Null: there is nothing to draw.
  std::shared_ptr<const exabricks::BrickedVolume> GetBrickedVolume()
  {
    vtkExaBricksData* data = this->Builder->GetOutput();
    return this->ConfigurationFault.empty() && data ? data->GetBrickedVolume() : nullptr;
  }

  // Returns which values cannot be drawn with.
  std::string CheckValues(vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property);
  // Says what the volume is drawn without; returns what is refused.
  std::string CheckRequests(
    vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property, int components);
  // Points the builder to the mapper's input and array; returns why it cannot.
  std::string ConfigureBuilder(vtkExaBricksVolumeMapper* self);
  // Hands the renderer what has changed. Throws std::bad_alloc.
  void UpdateRenderer(vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property,
    const std::shared_ptr<const exabricks::BrickedVolume>& bricked);
  // Renders the picture and puts it into the window, as Compositor::draw() does.
  std::optional<std::string> Draw(vtkExaBricksVolumeMapper* self, vtkRenderer* ren, vtkVolume* vol,
    const exabricks::BrickedVolume& bricked);
};

std::string vtkExaBricksVolumeMapper::vtkInternals::ConfigureBuilder(vtkExaBricksVolumeMapper* self)
{
  vtkAlgorithmOutput* input =
    self->GetNumberOfInputConnections(0) > 0 ? self->GetInputConnection(0, 0) : nullptr;
  if (!input)
  {
    // Nothing of the former input is kept.
    this->Builder->RemoveAllInputConnections(0);
    this->Builder->GetOutputDataObject(0)->Initialize();
    this->DropVolume();
    return "Expected a vtkOverlappingAMR as input, found none. Call SetInputConnection()";
  }
  vtkExaBricksBuilder* builder = this->Builder;
  if (builder->GetNumberOfInputConnections(0) == 0 || builder->GetInputConnection(0, 0) != input)
  {
    builder->SetInputConnection(input);
  }
  builder->SetVectorMode(self->VectorMode);
  builder->SetVectorComponent(self->VectorComponent);

  // Asked for an attribute, VTK marks the filter as modified even where nothing changes: it would
  // run again for every picture.
  const auto useActiveScalars = [builder](int wanted)
  {
    vtkInformation* present = builder->GetInputArrayInformation(0);
    if (present->Has(vtkDataObject::FIELD_NAME()) ||
      present->Get(vtkDataObject::FIELD_ASSOCIATION()) != wanted)
    {
      builder->SetInputArrayToProcess(0, 0, 0, wanted, vtkDataSetAttributes::SCALARS);
    }
    return std::string();
  };
  int association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  switch (self->ScalarMode)
  {
    case VTK_SCALAR_MODE_DEFAULT:
      return useActiveScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS);
    case VTK_SCALAR_MODE_USE_POINT_DATA:
      return useActiveScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    case VTK_SCALAR_MODE_USE_CELL_DATA:
      return useActiveScalars(association);
    case VTK_SCALAR_MODE_USE_POINT_FIELD_DATA:
      association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
      break;
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
      break;
    default:
      return std::string("Expected a scalar mode of points or cells, found ") +
        self->GetScalarModeAsString() + ". Call one of SetScalarModeTo...";
  }
  std::string name = self->ArrayName ? self->ArrayName : "";
  if (self->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
  {
    // Ids mean the arrays of a block, so look at the first.
    self->GetInputAlgorithm(0, 0)->Update();
    vtkOverlappingAMR* amr = vtkOverlappingAMR::SafeDownCast(self->GetDataObjectInput());
    vtkDataSet* block = amr ? exabricks::getFirstBlock(amr) : nullptr;
    vtkDataSetAttributes* data = block ? block->GetAttributes(association) : nullptr;
    const char* found = data && self->ArrayId >= 0 ? data->GetArrayName(self->ArrayId) : nullptr;
    if (!found)
    {
      return "Expected the number of an array from 0 to " +
        std::to_string(data ? data->GetNumberOfArrays() - 1 : -1) + ", found " +
        std::to_string(self->ArrayId) + ". Call SelectScalarArray() with the name of an array";
    }
    name = found;
  }
  builder->SetInputArrayToProcess(0, 0, 0, association, name.c_str());
  return {};
}

void vtkExaBricksVolumeMapper::vtkInternals::UpdateRenderer(vtkExaBricksVolumeMapper* self,
  vtkVolumeProperty* property, const std::shared_ptr<const exabricks::BrickedVolume>& bricked)
{
  this->Renderer.selectTraversal(static_cast<exabricks::Traversal>(self->Traversal));
  this->Renderer.selectDevice(self->Device ? self->Device : "");
  const bool newData = bricked != this->Bricked;
  const bool completed = self->Reconstruction == COMPLETED;
  if (newData || completed != this->Completed)
  {
    // The former one goes first, as completing the levels takes memory.
    this->Renderer.setVolume({});
    exabricks::Volume volume = bricked->volume;
    if (completed)
    {
      volume.values = exabricks::complete(*volume.structure, *volume.values);
    }
    this->Renderer.setVolume(std::move(volume));
    this->Bricked = bricked;
    this->Completed = completed;
  }
  if (newData || property != this->Property || property->GetMTime() > this->PropertyTime)
  {
    // Nodes are normalised to the range of the data, so new data want new tables too.
    this->Property = property;
    this->Renderer.setTransferFunction(
      exabricks::makeTransferFunction(property, bricked->volume.values->range));
    // Now, as discretised functions make tables when they are asked, and are modified by that.
    this->PropertyTime = property->GetMTime();
  }
}

vtkExaBricksVolumeMapper::vtkExaBricksVolumeMapper()
  : Internals(new vtkInternals)
{
}

vtkExaBricksVolumeMapper::~vtkExaBricksVolumeMapper() { this->SetDevice(nullptr); }

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

void vtkExaBricksVolumeMapper::SetVectorMode(int mode)
{
  const int clamped = vtkMath::ClampValue(mode, int(MAGNITUDE), int(COMPONENT));
  if (clamped != this->VectorMode || !this->Internals->VectorChosen)
  {
    this->Internals->VectorChosen = true;
    this->VectorMode = clamped;
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

double vtkExaBricksVolumeMapper::GetMarchTime()
{
  return this->Internals->Renderer.statistics().marchTime;
}

int vtkExaBricksVolumeMapper::GetLevelsLeftOut()
{
  return this->Internals->Renderer.statistics().levelsLeftOut;
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
  // vtkVolume updates before each picture, and Render() once more: a fault is said once.
  const std::string fault = this->Internals->ConfigureBuilder(this);
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

std::string vtkExaBricksVolumeMapper::vtkInternals::CheckValues(
  vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property)
{
  const double unit = property->GetScalarOpacityUnitDistance(0);
  if (!(unit > 0.0) || !std::isfinite(unit) || !std::isfinite(self->StepScale) ||
    !std::isfinite(self->ErrorTolerance))
  {
    return "expected a finite, positive ScalarOpacityUnitDistance, a finite StepScale and a finite "
           "ErrorTolerance, found " +
      std::to_string(unit) + ", " + std::to_string(self->StepScale) + " and " +
      std::to_string(self->ErrorTolerance);
  }
  return {};
}

std::string vtkExaBricksVolumeMapper::vtkInternals::CheckRequests(
  vtkExaBricksVolumeMapper* self, vtkVolumeProperty* property, int components)
{
  exabricks::Requests requests =
    exabricks::checkComponents(property, components, this->VectorChosen);
  if (!this->ReconstructionChosen && property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION)
  {
    requests.drawnWithout.push_back(
      "The property's interpolation type is nearest, its default, and does not count yet: the "
      "volume is drawn continuous, by the reconstruction Basis. Call SetReconstructionToNearest(), "
      "or SetInterpolationTypeToLinear() of the property.");
  }
  for (const std::string& what : requests.drawnWithout)
  {
    this->WarnOnce(self, what);
  }
  return requests.refused;
}

std::optional<std::string> vtkExaBricksVolumeMapper::vtkInternals::Draw(
  vtkExaBricksVolumeMapper* self, vtkRenderer* ren, vtkVolume* vol,
  const exabricks::BrickedVolume& bricked)
{
  const auto makeView = [&](int width, int height)
  {
    exabricks::View view = exabricks::makeView(ren, vol, bricked, width, height);
    view.quality.reconstruction = static_cast<exabricks::Reconstruction>(self->Reconstruction);
    view.quality.stepScale = self->StepScale;
    view.quality.errorTolerance = self->ErrorTolerance;
    view.opacityUnitDistance = vol->GetProperty()->GetScalarOpacityUnitDistance(0);
    view.quality.terminationOpacity = self->EarlyTerminationOpacity;
    return view;
  };
  return this->Compositor.draw(self, ren, vol, makeView, this->Renderer);
}

void vtkExaBricksVolumeMapper::Render(vtkRenderer* ren, vtkVolume* vol)
{
  vtkInternals& internals = *this->Internals;
  if (ren->GetSelector())
  {
    return; // blended colours would be taken for ids
  }
  const exabricks::Requests requests = exabricks::checkRequests(this, vol);
  for (const std::string& what : requests.drawnWithout)
  {
    internals.WarnOnce(this, what);
  }
  if (!requests.refused.empty())
  {
    internals.SayFault(this, requests.refused);
    internals.Drawn.set(ren, false);
    return;
  }
  this->Update();
  if (!internals.GetBrickedVolume())
  {
    internals.DropVolume();
    internals.Drawn.set(ren, false);
    return; // the builder has said why, or was told to stop
  }
  if (ren->GetRenderWindow()->CheckAbortStatus())
  {
    internals.Drawn.set(ren, false);
    return;
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  const double start = vtkTimerLog::GetUniversalTime();
  // An observer may have changed what there is to draw.
  const vtkSmartPointer<vtkVolumeProperty> property = vol->GetProperty();
  if (const auto bricked = internals.GetBrickedVolume())
  {
    std::optional<std::string> fault = internals.CheckRequests(this, property, bricked->components);
    fault = fault->empty() ? internals.CheckValues(this, property) : fault;
    try
    {
      internals.UpdateRenderer(this, property, bricked);
      fault = fault->empty() ? internals.Draw(this, ren, vol, *bricked) : fault;
    }
    catch (const std::bad_alloc&)
    {
      internals.Bricked.reset();
      fault = "out of memory on the host. Read fewer levels, or make the window smaller";
    }
    if (fault)
    {
      internals.SayFault(this, *fault);
      internals.Drawn.set(ren, fault->empty());
    }
  }
  else
  {
    internals.Drawn.set(ren, false);
  }
  this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
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
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "Traversal: " << this->GetTraversalAsString() << "\n";
  os << indent << "EarlyTerminationOpacity: " << this->EarlyTerminationOpacity << "\n";
  os << indent << "VectorMode: " << (this->VectorMode == COMPONENT ? "Component" : "Magnitude")
     << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "Device: " << (this->Device ? this->Device : "(best)") << "\n";
  os << indent << "Drawn: " << this->GetDrawn() << "\n";
  os << indent << "DeviceName: " << this->GetDeviceName() << "\n";
  os << indent << "TraversalUsed: " << this->GetTraversalUsed() << "\n";
  os << indent << "NumberOfActiveRegions: " << this->GetNumberOfActiveRegions() << "\n";
  os << indent << "LevelsLeftOut: " << this->GetLevelsLeftOut() << "\n";
  os << indent << "DeviceMemory: " << this->GetDeviceMemory() << " bytes\n";
}
