// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolumeMapperInternals.h"

#include "Adapters/ArraySelection.h"
#include "Adapters/LightingInput.h"
#include "Adapters/MediumInput.h"
#include "Core/Completion.h"
#include "vtkExaBricksData.h"

#include "vtkMultiProcessController.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

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
  // The second variable of a 2-D function, where there is one, or the opacity.
  const bool planar = this->Self->Transfer2DYAxisArray != nullptr;
  builder->SetSecondArrayName(
    planar ? this->Self->Transfer2DYAxisArray : this->Self->OpacityArrayName);
  builder->SetSecondComponent(this->Self->OpacityComponent);
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

// Surfaces of independent components are those of one of them, which is drawn as if it were alone.
std::shared_ptr<const exabricks::BrickedVolume> vtkExaBricksVolumeMapper::vtkInternals::FindShown(
  vtkVolumeProperty* property)
{
  const auto bricked = this->GetBrickedVolume();
  const auto component = bricked ? exabricks::findSurfaceComponent(this->Self, property, *bricked)
                                 : std::optional<int>();
  if (!component)
  {
    this->Surfaces = {};
    return bricked;
  }
  if (this->Surfaces.of != bricked || this->Surfaces.alone->propertyComponent != *component)
  {
    auto alone = std::make_shared<exabricks::BrickedVolume>(*bricked);
    alone->volume.values = bricked->volume.valuesOf(static_cast<std::size_t>(*component));
    alone->volume.furtherValues.clear();
    alone->propertyComponent = *component;
    this->Surfaces = { bricked, std::move(alone) };
  }
  return this->Surfaces.alone;
}

// Checks what is asked for, updates the renderer and draws. Returns as Compositor::draw() does.
std::optional<std::string> vtkExaBricksVolumeMapper::vtkInternals::Draw(
  vtkRenderer* ren, vtkVolume* vol, const std::shared_ptr<const exabricks::BrickedVolume>& bricked)
{
  const vtkSmartPointer<vtkVolumeProperty> property = vol->GetProperty();
  const std::string refused = this->CheckData(property, *bricked);
  if (bricked->volume.values->range.empty() && !this->UsesNanColor(property, *bricked))
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
  if (this->Self->Transfer2DYAxisArray &&
    (this->Self->OpacityArrayName || !exabricks::isPlanar(property, bricked)))
  {
    return "expected a 2-D transfer function and no OpacityArrayName for the "
           "Transfer2DYAxisArray. Call SetTransferFunctionMode() of the volume property, or "
           "SetTransfer2DYAxisArray() without an array";
  }
  const std::string refused = exabricks::checkNumbers(property, settings);
  if (!refused.empty())
  {
    return refused;
  }
  if (this->Self->UseNanColor && !this->UsesNanColor(property, bricked))
  {
    this->Report({ {},
      { "UseNanColor counts with blend modes composite and slice, one component and a color "
        "function of three channels: cells without a value are left out." } });
  }
  this->Report(this->CheckLighting(property, bricked));
  if (bricked.volume.structure->hierarchy.whole)
  {
    // Each process would choose steps and levels of its own; and values of rays end with the part.
    exabricks::Requests ofPart;
    if (this->Self->ErrorTolerance > 0.0)
    {
      ofPart.drawnWithout.emplace_back("One of several processes draws without ErrorTolerance: "
                                       "steps are those of StepScale.");
    }
    if (!exabricks::isOfPlaces(exabricks::findBlending(this->Self)))
    {
      ofPart.drawnWithout.emplace_back(
        "One of several processes draws the greatest, least or mean value, or the sum, of its own "
        "part: pictures put one over the other are not that of one process.");
    }
    if (!bricked.volume.structure->hierarchy.whole->completed &&
      this->FindReconstruction(property) == exabricks::Reconstruction::Completed)
    {
      ofPart.drawnWithout.emplace_back(
        "One of several processes lacks cells to complete levels with, so that its part ends in a "
        "seam. Call SetForCompleted(true) of the vtkExaBricksRedistribute.");
    }
    this->Report(ofPart);
  }
  else if (vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController())
  {
    const int count = processes->GetNumberOfProcesses();
    if (count > 1)
    {
      this->Report({ {},
        { "This is one of " + std::to_string(count) +
          " processes, and the AMR is not shared out among them: what each draws is neither whole "
          "nor in order. Put a vtkExaBricksRedistribute before the mapper." } });
    }
  }
  this->Report(
    { {}, exabricks::checkCategories(property, bricked, this->FindReconstruction(property)) });
  return this->Report(exabricks::checkMedium(this->Self, property, bricked));
}

// Whether what is set of normals, scattering and shadows counts.
exabricks::Requests vtkExaBricksVolumeMapper::vtkInternals::CheckLighting(
  vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked) const
{
  exabricks::Requests requests;
  const bool ofDependent = bricked.volume.components() > 1 &&
    !exabricks::isIndependent(property, bricked) &&
    exabricks::findBlending(this->Self) == exabricks::Blending::Isosurface;
  if (exabricks::takesNormalsFromOpacity(this->Self) &&
    (exabricks::isPlanar(property, bricked) || ofDependent))
  {
    requests.drawnWithout.emplace_back(
      "ComputeNormalFromOpacity has no meaning with a 2-D transfer function, and for iso-surfaces "
      "of one component with the opacity of another: the volume is drawn with normals against the "
      "gradient of values.");
  }
  const bool scatters = this->Self->VolumetricScatteringBlending > 0.0f;
  const bool shadows = this->Self->GlobalIlluminationReach > 0.0f;
  if (shadows && !scatters)
  {
    requests.drawnWithout.emplace_back(
      "GlobalIlluminationReach counts with a VolumetricScatteringBlending above 0: the volume "
      "is drawn without shadows.");
  }
  if (scatters &&
    (exabricks::findBlending(this->Self) != exabricks::Blending::Composite ||
      !exabricks::isShaded(property, bricked)))
  {
    requests.drawnWithout.emplace_back(
      "VolumetricScatteringBlending counts with blend mode composite and the property's Shade: the "
      "volume is drawn without it.");
  }
  else if (scatters && shadows && bricked.volume.structure->hierarchy.whole)
  {
    requests.drawnWithout.emplace_back(
      "One of several processes casts shadows on its own part alone, so that parts meet in seams: "
      "set GlobalIlluminationReach to 0 for pictures without shadows and seams.");
  }
  return requests;
}

// Hands the renderer what has changed. Throws std::bad_alloc.
void vtkExaBricksVolumeMapper::vtkInternals::UpdateRenderer(
  vtkVolumeProperty* property, const std::shared_ptr<const exabricks::BrickedVolume>& bricked)
{
  this->Renderer.selectTraversal(static_cast<exabricks::Traversal>(this->Self->Traversal));
  this->Renderer.selectDevice(this->Self->Device ? this->Self->Device : "");
  const bool newData = bricked != this->Bricked;
  const bool completed = this->FindReconstruction(property) == exabricks::Reconstruction::Completed;
  if (newData || property != this->Property || property->GetMTime() > this->PropertyTime)
  {
    this->Interactive.forget();
  }
  if (newData || this->Completed != completed)
  {
    this->UpdateVolume(bricked, completed);
  }
  const bool planar = exabricks::isPlanar(property, *bricked);
  const exabricks::ColorsOf colors =
    this->FindReconstruction(property) == exabricks::Reconstruction::Nearest
    ? exabricks::ColorsOf::Categories
    : exabricks::ColorsOf::Values;
  // Nodes are normalised to the range of the data, so new data want new tables too.
  if (newData || planar != this->Planar || colors != this->Colors || property != this->Property ||
    property->GetMTime() > this->PropertyTime)
  {
    this->Planar = planar;
    this->Colors = colors;
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
  if (bricked.volume.components() > 1 || this->Planar)
  {
    this->Renderer.setMedium(exabricks::makeMedium(property, bricked, this->Planar, this->Colors));
  }
  else
  {
    const exabricks::Range& range = bricked.volume.values->range;
    const exabricks::TransferFunction transfer =
      exabricks::makeTransferFunction(property, bricked.propertyComponent,
        property->GetScalarOpacity(bricked.propertyComponent), range, this->Colors);
    if (this->Self->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND && !this->SaidTransparent)
    {
      const exabricks::Requests found = exabricks::checkTransparency(property, transfer, bricked);
      this->SaidTransparent = !found.drawnWithout.empty();
      this->Report(found);
    }
    this->Renderer.setTransferFunction(transfer);
  }
  // A function of gradients itself has no other one beside it, as in VTK's mapper.
  this->Renderer.setGradientOpacity(
    this->Planar ? std::vector<float>() : exabricks::makeGradientOpacity(property, bricked));
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

// Whether cells whose value is not a number show.
bool vtkExaBricksVolumeMapper::vtkInternals::UsesNanColor(
  vtkVolumeProperty* property, const exabricks::BrickedVolume& bricked) const
{
  return this->Self->UseNanColor &&
    exabricks::canUseNanColor(this->Self, property, static_cast<int>(bricked.volume.components()));
}

// Gives back what was held of the former volume.
void vtkExaBricksVolumeMapper::vtkInternals::DropVolume()
{
  this->Renderer.setVolume({});
  this->Bricked.reset();
  this->Surfaces = {};
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
    vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
    const int count = processes ? processes->GetNumberOfProcesses() : 1;
    const std::string what = count > 1 ? "The part of process " +
        std::to_string(processes->GetLocalProcessId()) + " of " + std::to_string(count)
                                       : "The volume";
    vtkErrorWithObjectMacro(this->Self, << what << " is not drawn: " << fault << ".");
  }
  this->ReportedFault = fault;
}
