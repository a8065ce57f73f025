// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExaBricksVolumeMapperInternals.h"

#include "Adapters/ArraySelection.h"
#include "Adapters/CutawayInput.h"
#include "Adapters/LightingInput.h"
#include "Adapters/MediumInput.h"
#include "Adapters/ViewInput.h"
#include "Core/Completion.h"
#include "Core/Stopwatch.h"
#include "Vulkan/JointPicture.h"
#include "vtkExaBricksData.h"

#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
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

namespace
{
// Of the bounds, half cells.
glm::dvec3 sizeOf(const exabricks::BrickedVolume& bricked)
{
  return glm::dvec3(bricked.volume.structure->tree.size);
}

// Whether nothing was uploaded, compiled, selected or searched for a picture.
bool madeNothing(const exabricks::VolumeRenderer::Statistics& before,
  const exabricks::VolumeRenderer::Statistics& after)
{
  return before.structureUploads == after.structureUploads &&
    before.valueUploads == after.valueUploads && before.pipelineBuilds == after.pipelineBuilds &&
    before.colorTime == after.colorTime && before.opacityTime == after.opacityTime &&
    (before.samplingTime == after.samplingTime || after.samplingTime == 0.0);
}
}

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
  builder->SetSecondComponent(planar ? 0 : this->Self->OpacityComponent);
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
    (this->Self->OpacityArrayName || !exabricks::isPlanar(this->Self, property, bricked)))
  {
    return "expected a 2-D transfer function, blend mode composite and no OpacityArrayName for the "
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
      { "UseNanColor counts with blend mode composite, one component and a color function of three "
        "channels: cells without a value are left out." } });
  }
  this->Report({ {},
    exabricks::checkCategories(property, static_cast<int>(bricked.volume.components()),
      this->FindReconstruction(property)) });
  return this->Report(exabricks::checkMedium(this->Self, property, bricked));
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
  const bool planar = exabricks::isPlanar(this->Self, property, *bricked);
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
      exabricks::makeTransferFunction(property, range, this->Colors);
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
  if (this->UsesNanColor(vol->GetProperty(), bricked))
  {
    view.undefinedColor = exabricks::findNanColor(vol->GetProperty());
  }
  view.lighting = exabricks::makeLighting(ren, vol, bricked);
  return view;
}

// Renders the picture and puts it into the window, or what a selector wants to know of it.
std::optional<std::string> vtkExaBricksVolumeMapper::vtkInternals::Composite(
  vtkRenderer* ren, vtkVolume* vol, const exabricks::BrickedVolume& bricked)
{
  if (ren->GetSelector())
  {
    const auto makeView = [&](int width, int height)
    { return this->MakeView(ren, vol, bricked, width, height); };
    return this->Compositor.drawSelection(ren, makeView, this->Renderer);
  }
  double rays = 0.0;
  const auto makeView = [&](int width, int height)
  {
    if (this->Compositor.isFirstPass())
    {
      this->MeasurePasses(); // those of the picture before, of which none is known to be the last
      this->Coarseness = this->ChooseCoarseness(ren, vol, bricked, width, height);
    }
    const exabricks::View view = this->MakeCoarseView(ren, vol, bricked, width, height);
    rays = static_cast<double>(view.target.width) * view.target.height;
    return view;
  };
  const auto progress = [&](double done)
  {
    this->Self->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &done);
    this->Aborted = ren->GetRenderWindow()->CheckAbortStatus() != 0;
    return !this->Aborted;
  };
  const std::vector<Overlapping> others = this->FindOverlapping(ren, vol);
  const exabricks::VolumeRenderer::Statistics before = this->Renderer.statistics();
  const exabricks::Stopwatch watch;
  double marching = 0.0;
  const std::optional<std::string> fault = this->Compositor.draw(this->Self, ren, vol, makeView,
    { this->Self->FinalColorWindow, this->Self->FinalColorLevel },
    [&](const exabricks::View& view, exabricks::Pixels& picture)
    { return this->RenderPicture(ren, bricked, others, view, picture, marching, progress); });
  if (fault && fault->empty())
  {
    // What is made once does not count for the pictures after this one.
    const bool steady = madeNothing(before, this->Renderer.statistics());
    this->RaysOfPasses = rays;
    this->MarchingOfPasses += marching;
    this->OtherOfPasses += steady ? watch.seconds() - marching : 0.0;
    if (!this->Compositor.isPeeling())
    {
      this->MeasurePasses();
    }
    this->InteractiveTime = this->Self->GetMTime();
    for (const Overlapping& other : others)
    {
      other.internals->DrawnWithOther.set(ren, true);
    }
  }
  return fault;
}

// The renderer's other volumes that overlap this one, or one of them, brought up to date. Those
// that cannot be drawn are left to say so themselves.
std::vector<vtkExaBricksVolumeMapper::vtkInternals::Overlapping>
vtkExaBricksVolumeMapper::vtkInternals::FindOverlapping(vtkRenderer* ren, vtkVolume* vol)
{
  std::vector<Overlapping> found;
  if (this->Self->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return found;
  }
  std::vector<vtkBoundingBox> boxes{ vtkBoundingBox(vol->GetBounds()) };
  const auto overlaps = [&](const vtkBoundingBox& box)
  {
    return std::any_of(boxes.begin(), boxes.end(),
      [&](const vtkBoundingBox& other)
      {
        vtkBoundingBox common = box;
        return common.IntersectBox(other) != 0 && common.GetLength(0) > 0.0 &&
          common.GetLength(1) > 0.0 && common.GetLength(2) > 0.0;
      });
  };
  std::set<vtkVolume*> members{ vol };
  vtkVolumeCollection* volumes = ren->GetVolumes();
  for (bool grows = true; grows;)
  {
    grows = false;
    vtkCollectionSimpleIterator place;
    volumes->InitTraversal(place);
    while (vtkVolume* other = volumes->GetNextVolume(place))
    {
      auto* mapper = vtkExaBricksVolumeMapper::SafeDownCast(other->GetMapper());
      if (!mapper || !other->GetVisibility() || members.count(other) > 0 ||
        mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND ||
        mapper->GetFinalColorWindow() != this->Self->FinalColorWindow ||
        mapper->GetFinalColorLevel() != this->Self->FinalColorLevel || !other->GetBounds() ||
        !vtkMath::AreBoundsInitialized(other->GetBounds()) ||
        !overlaps(vtkBoundingBox(other->GetBounds())))
      {
        continue;
      }
      members.insert(other);
      mapper->Update();
      vtkInternals& internals = *mapper->Internals;
      auto bricked = internals.GetBrickedVolume();
      if (bricked && exabricks::checkWithoutData(mapper, other).refused.empty() &&
        internals.CheckData(other->GetProperty(), *bricked).empty())
      {
        internals.UpdateRenderer(other->GetProperty(), bricked);
        boxes.emplace_back(other->GetBounds());
        found.push_back({ other, &internals, std::move(bricked) });
        grows = true;
      }
    }
  }
  return found;
}

// The volume's picture, with all that overlaps it.
std::string vtkExaBricksVolumeMapper::vtkInternals::RenderPicture(vtkRenderer* ren,
  const exabricks::BrickedVolume& bricked, const std::vector<Overlapping>& others,
  const exabricks::View& view, exabricks::Pixels& picture, double& marching,
  const exabricks::VolumeRenderer::Progress& progress)
{
  if (others.empty())
  {
    const std::string fault = this->Renderer.render(view, picture, progress);
    marching += this->Renderer.statistics().marchTime;
    return fault;
  }
  std::vector<exabricks::JointVolume> volumes{ { &this->Renderer, view, sizeOf(bricked) } };
  for (const Overlapping& other : others)
  {
    exabricks::View beside = other.internals->MakeView(
      ren, other.volume, *other.bricked, view.target.width, view.target.height);
    beside.quality.stepGrowth = view.quality.stepGrowth;
    beside.quality.keepsSampling = view.quality.keepsSampling;
    volumes.push_back({ &other.internals->Renderer, beside, sizeOf(*other.bricked) });
  }
  return exabricks::renderJointly(volumes, view.target, picture, marching, progress);
}

void vtkExaBricksVolumeMapper::vtkInternals::MeasurePasses()
{
  this->Interactive.measured(
    this->Coarseness, this->RaysOfPasses, this->MarchingOfPasses, this->OtherOfPasses);
  this->RaysOfPasses = this->MarchingOfPasses = this->OtherOfPasses = 0.0;
}

// Whether sample distances are chosen for the time allocated to the picture.
bool vtkExaBricksVolumeMapper::vtkInternals::AdjustsSampleDistances(vtkRenderer* ren) const
{
  return this->Self->InteractiveAdjustSampleDistances
    ? ren->GetRenderWindow()->GetDesiredUpdateRate() >= this->Self->InteractiveUpdateRate
    : this->Self->AutoAdjustSampleDistances != 0;
}

exabricks::Coarseness vtkExaBricksVolumeMapper::vtkInternals::ChooseCoarseness(
  vtkRenderer* ren, vtkVolume* vol, const exabricks::BrickedVolume& bricked, int width, int height)
{
  if (!this->AdjustsSampleDistances(ren))
  {
    return { this->Self->ImageSampleDistance, 1.0 };
  }
  const double seconds = vol->GetAllocatedRenderTime();
  const double pixels = static_cast<double>(width) * height;
  const exabricks::InteractiveSampling::Limits limits{ this->Self->MinimumImageSampleDistance,
    this->Self->MaximumImageSampleDistance };
  if (this->Self->GetMTime() > this->InteractiveTime)
  {
    this->Interactive.forget();
  }
  if (!this->Interactive.knows())
  {
    // Few of its pixels tell how long the picture takes.
    this->Coarseness = this->Interactive.choose(seconds, pixels, limits);
    const exabricks::View view = this->MakeCoarseView(ren, vol, bricked, width, height);
    std::vector<glm::vec4> picture;
    if (this->Renderer.render(view, picture).empty())
    {
      this->Interactive.measured(this->Coarseness,
        static_cast<double>(view.target.width) * view.target.height,
        this->Renderer.statistics().marchTime, 0.0);
      this->InteractiveTime = this->Self->GetMTime();
    }
  }
  return this->Interactive.choose(seconds, pixels, limits);
}

// A view of so many pixels with the rays and steps that were chosen.
exabricks::View vtkExaBricksVolumeMapper::vtkInternals::MakeCoarseView(vtkRenderer* ren,
  vtkVolume* vol, const exabricks::BrickedVolume& bricked, int width, int height) const
{
  const double distance = this->Coarseness.imageSampleDistance;
  exabricks::View view = this->MakeView(ren, vol, bricked, exabricks::thinnedSize(width, distance),
    exabricks::thinnedSize(height, distance));
  view.quality.stepGrowth = this->Coarseness.stepGrowth;
  view.quality.keepsSampling = this->AdjustsSampleDistances(ren);
  return view;
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
