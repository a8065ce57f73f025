// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolumeMapper.h"

#include "Adapters/AMRCompatibility.h"
#include "Adapters/ArraySelection.h"
#include "Adapters/BrickedVolume.h"
#include "Adapters/Compositor.h"
#include "Adapters/CutawayInput.h"
#include "Adapters/DrawnRenderers.h"
#include "Adapters/FirstSeen.h"
#include "Adapters/LightingInput.h"
#include "Adapters/MediumInput.h"
#include "Adapters/PropertyInput.h"
#include "Adapters/ViewInput.h"
#include "Core/Completion.h"
#include "Vulkan/VolumeRenderer.h"
#include "vtkExaBricksBuilder.h"
#include "vtkExaBricksData.h"

#include "vtkCommand.h"
#include "vtkGarbageCollector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <set>

vtkStandardNewMacro(vtkExaBricksVolumeMapper);

static_assert(static_cast<int>(vtkExaBricksVolumeMapper::MAGNITUDE) ==
      static_cast<int>(vtkExaBricksBuilder::MAGNITUDE) &&
    static_cast<int>(vtkExaBricksVolumeMapper::DISABLED) ==
      static_cast<int>(vtkExaBricksBuilder::DISABLED) &&
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
  bool Completed = false;                // whether its levels were completed
  vtkVolumeProperty* Property = nullptr; // compared only, never followed
  vtkMTimeType PropertyTime = 0;

  bool ReconstructionChosen = false;

  std::set<std::string> ReportedWarnings; // each is reported once
  std::string ReportedFault;              // of the last picture: reported once as long as it stays
  bool Aborted = false;                   // the window was told to stop in the last picture
  std::string ConfigurationFault;         // empty if the builder has the mapper's input and array

  explicit vtkInternals(vtkExaBricksVolumeMapper* self)
    : Self(self)
  {
  }

  // The steps of a picture, in their order.
  std::string ConfigureBuilder();
  std::shared_ptr<const exabricks::BrickedVolume> GetBrickedVolume() const;
  std::optional<std::string> Draw(vtkRenderer* ren, vtkVolume* vol,
    const std::shared_ptr<const exabricks::BrickedVolume>& bricked);
  std::string CheckData(vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked);
  void UpdateRenderer(
    vtkVolumeProperty* property, const std::shared_ptr<const exabricks::BrickedVolume>& bricked);
  void UpdateVolume(const std::shared_ptr<const exabricks::BrickedVolume>& bricked, bool completed);
  void UpdateTransferFunction(vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked);
  exabricks::Reconstruction FindReconstruction(vtkVolumeProperty* property) const;
  exabricks::View MakeView(vtkRenderer* ren, vtkVolume* vol,
    const exabricks::BrickedVolume& bricked, int width, int height) const;
  std::optional<std::string> Composite(
    vtkRenderer* ren, vtkVolume* vol, const exabricks::BrickedVolume& bricked);

  void DropVolume();
  std::string Report(const exabricks::Requests& requests);
  void ReportFault(const std::string& fault);

private:
  vtkExaBricksVolumeMapper* const Self;
};

// Points the builder to the mapper's input and array; returns why it cannot.
std::string vtkExaBricksVolumeMapper::vtkInternals::ConfigureBuilder()
{
  vtkExaBricksBuilder* builder = this->Builder;
  vtkAlgorithmOutput* input =
    this->Self->GetNumberOfInputConnections(0) > 0 ? this->Self->GetInputConnection(0, 0) : nullptr;
  if (!input)
  {
    // Nothing of the former input is kept.
    builder->RemoveAllInputConnections(0);
    builder->GetOutputDataObject(0)->Initialize();
    this->DropVolume();
    return "Expected a vtkOverlappingAMR as input, found none. Call SetInputConnection()";
  }
  if (builder->GetNumberOfInputConnections(0) == 0 || builder->GetInputConnection(0, 0) != input)
  {
    builder->SetInputConnection(input);
  }
  builder->SetVectorMode(this->Self->VectorMode);
  builder->SetVectorComponent(this->Self->VectorComponent);
  builder->SetLevelRange(this->Self->LevelRange);
  return exabricks::selectArray(builder, this->Self);
}

// What the builder made; null if there is nothing to draw.
std::shared_ptr<const exabricks::BrickedVolume>
vtkExaBricksVolumeMapper::vtkInternals::GetBrickedVolume() const
{
  vtkExaBricksData* data = this->Builder->GetOutput();
  return this->ConfigurationFault.empty() && data ? data->GetBrickedVolume() : nullptr;
}

// Checks what is asked for, updates the renderer and draws. Returns as Compositor::draw() does.
std::optional<std::string> vtkExaBricksVolumeMapper::vtkInternals::Draw(
  vtkRenderer* ren, vtkVolume* vol, const std::shared_ptr<const exabricks::BrickedVolume>& bricked)
{
  const vtkSmartPointer<vtkVolumeProperty> property = vol->GetProperty();
  const std::string refused = this->CheckData(property, *bricked);
  if (bricked->volume.values->range.empty())
  {
    this->Report({ {}, { "No cell of the array has a finite value: nothing shows." } });
  }
  try
  {
    if (!refused.empty())
    {
      if (bricked != this->Bricked)
      {
        this->DropVolume(); // two of them may be too much memory
      }
      return refused;
    }
    this->UpdateRenderer(property, bricked);
    return this->Composite(ren, vol, *bricked);
  }
  catch (const std::bad_alloc&)
  {
    this->Bricked.reset();
    return "out of memory on the host. Read fewer levels, or make the window smaller";
  }
}

// Returns what is refused of the data and the property, or nothing.
std::string vtkExaBricksVolumeMapper::vtkInternals::CheckData(
  vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked)
{
  const exabricks::MapperSettings settings{ this->Self->StepScale, this->Self->SampleDistance,
    this->Self->ErrorTolerance, { this->Self->FinalColorWindow, this->Self->FinalColorLevel } };
  const std::string refused = exabricks::checkNumbers(property, settings);
  return refused.empty() && bricked.volume.components() > 1
    ? this->Report(exabricks::checkMedium(this->Self, property, bricked))
    : refused;
}

// Hands the renderer what has changed. Throws std::bad_alloc.
void vtkExaBricksVolumeMapper::vtkInternals::UpdateRenderer(
  vtkVolumeProperty* property, const std::shared_ptr<const exabricks::BrickedVolume>& bricked)
{
  this->Renderer.selectTraversal(static_cast<exabricks::Traversal>(this->Self->Traversal));
  this->Renderer.selectDevice(this->Self->Device ? this->Self->Device : "");
  const bool newData = bricked != this->Bricked;
  const bool completed = this->FindReconstruction(property) == exabricks::Reconstruction::Completed;
  if (newData || this->Completed != completed)
  {
    this->UpdateVolume(bricked, completed);
  }
  // Nodes are normalised to the range of the data, so new data want new tables too.
  if (newData || property != this->Property || property->GetMTime() > this->PropertyTime)
  {
    this->UpdateTransferFunction(property, *bricked);
  }
}

void vtkExaBricksVolumeMapper::vtkInternals::UpdateVolume(
  const std::shared_ptr<const exabricks::BrickedVolume>& bricked, bool completed)
{
  exabricks::Volume volume = bricked->volume;
  if (!this->Bricked || this->Bricked->volume.structure != volume.structure)
  {
    // The former one goes first, as completing the levels takes memory.
    this->Renderer.setVolume({});
  }
  if (completed)
  {
    volume.values = exabricks::complete(*volume.structure, *volume.values);
    for (std::shared_ptr<const exabricks::Values>& values : volume.furtherValues)
    {
      values = exabricks::complete(*volume.structure, *values);
    }
  }
  this->Renderer.setVolume(std::move(volume));
  this->Bricked = bricked;
  this->Completed = completed;
}

void vtkExaBricksVolumeMapper::vtkInternals::UpdateTransferFunction(
  vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked)
{
  this->Property = property;
  if (bricked.volume.components() > 1)
  {
    this->Renderer.setMedium(exabricks::makeMedium(property, bricked));
  }
  else
  {
    const exabricks::Range& range = bricked.volume.values->range;
    this->Renderer.setTransferFunction(exabricks::makeTransferFunction(property, range));
  }
  this->Renderer.setGradientOpacity(exabricks::makeGradientOpacity(property, bricked.volume));
  // Asked afterwards, as discretised functions make tables when they are evaluated, and are
  // modified by that.
  this->PropertyTime = property->GetMTime();
}

// The one that was chosen, or that of the property's interpolation type.
exabricks::Reconstruction vtkExaBricksVolumeMapper::vtkInternals::FindReconstruction(
  vtkVolumeProperty* property) const
{
  return !this->ReconstructionChosen &&
      property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
    ? exabricks::Reconstruction::Nearest
    : static_cast<exabricks::Reconstruction>(this->Self->Reconstruction);
}

exabricks::View vtkExaBricksVolumeMapper::vtkInternals::MakeView(vtkRenderer* ren, vtkVolume* vol,
  const exabricks::BrickedVolume& bricked, int width, int height) const
{
  exabricks::View view = exabricks::makeView(ren, vol, bricked, width, height);
  view.quality.reconstruction = this->FindReconstruction(vol->GetProperty());
  view.quality.stepScale = this->Self->StepScale;
  view.quality.sampleDistance = this->Self->SampleDistance;
  view.quality.jittered = this->Self->UseJittering;
  view.quality.errorTolerance = this->Self->ErrorTolerance;
  view.cutaway = exabricks::makeCutaway(this->Self, vol, bricked);
  view.opacityUnitDistance = vol->GetProperty()->GetScalarOpacityUnitDistance(0);
  view.quality.terminationOpacity = this->Self->EarlyTerminationOpacity;
  view.blending = exabricks::findBlending(this->Self);
  view.averageRanges = exabricks::findAverageRanges(this->Self, bricked.volume);
  view.slicePlane = exabricks::findSlicePlane(vol, bricked);
  view.isoValues = exabricks::findIsoValues(vol->GetProperty(), bricked.volume.values->range);
  view.lighting = exabricks::makeLighting(ren, vol, bricked);
  return view;
}

// Renders the picture and puts it into the window, or what a selector wants to know of it.
std::optional<std::string> vtkExaBricksVolumeMapper::vtkInternals::Composite(
  vtkRenderer* ren, vtkVolume* vol, const exabricks::BrickedVolume& bricked)
{
  const auto makeView = [&](int width, int height)
  { return this->MakeView(ren, vol, bricked, width, height); };
  if (ren->GetSelector())
  {
    return this->Compositor.drawSelection(ren, makeView, this->Renderer);
  }
  const auto progress = [&](double done)
  {
    this->Self->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &done);
    this->Aborted = ren->GetRenderWindow()->CheckAbortStatus() != 0;
    return !this->Aborted;
  };
  return this->Compositor.draw(this->Self, ren, vol, makeView,
    { this->Self->FinalColorWindow, this->Self->FinalColorLevel }, this->Renderer, progress);
}

// Gives back what was held of the former volume.
void vtkExaBricksVolumeMapper::vtkInternals::DropVolume()
{
  this->Renderer.setVolume({});
  this->Bricked.reset();
}

// Warns, once, of what the volume is drawn without; returns what is refused.
std::string vtkExaBricksVolumeMapper::vtkInternals::Report(const exabricks::Requests& requests)
{
  for (const std::string& what : requests.drawnWithout)
  {
    if (this->ReportedWarnings.insert(what).second)
    {
      vtkWarningWithObjectMacro(this->Self, << what);
    }
  }
  return requests.refused;
}

// Reports a fault, unless the last picture had it too; or that there is none any more.
void vtkExaBricksVolumeMapper::vtkInternals::ReportFault(const std::string& fault)
{
  if (!fault.empty() && fault != this->ReportedFault)
  {
    vtkErrorWithObjectMacro(this->Self, "The volume is not drawn: " << fault << ".");
  }
  this->ReportedFault = fault;
}

vtkExaBricksVolumeMapper::vtkExaBricksVolumeMapper()
  : Internals(new vtkInternals(this))
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
  const auto bricked = internals.GetBrickedVolume(); // an observer may have changed it
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
  const auto bricked = internals.GetBrickedVolume();
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
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "Traversal: " << this->GetTraversalAsString() << "\n";
  os << indent << "EarlyTerminationOpacity: " << this->EarlyTerminationOpacity << "\n";
  os << indent << "VectorMode: " << vtkExaBricksBuilder::GetVectorModeAsString(this->VectorMode)
     << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "LevelRange: " << this->LevelRange[0] << ", " << this->LevelRange[1] << "\n";
  os << indent << "FinalColorWindow: " << this->FinalColorWindow << "\n";
  os << indent << "FinalColorLevel: " << this->FinalColorLevel << "\n";
  os << indent << "Device: " << (this->Device ? this->Device : "(best)") << "\n";
  os << indent << "Drawn: " << this->GetDrawn() << "\n";
  os << indent << "DeviceName: " << this->GetDeviceName() << "\n";
  os << indent << "TraversalUsed: " << this->GetTraversalUsed() << "\n";
  os << indent << "NumberOfActiveRegions: " << this->GetNumberOfActiveRegions() << "\n";
  os << indent << "LevelsLeftOut: " << this->GetLevelsLeftOut() << "\n";
  os << indent << "DeviceMemory: " << this->GetDeviceMemory() << " bytes\n";
}
