// SPDX-License-Identifier: BSD-3-Clause
// One picture by vtkExaBricksVolumeMapper: how coarse it may be, what overlaps the volume, and the
// way of both into the window.
#include "vtkExaBricksVolumeMapperInternals.h"

#include "Adapters/CutawayInput.h"
#include "Adapters/LightingInput.h"
#include "Adapters/OpenGLFramebuffer.h"
#include "Adapters/ViewInput.h"
#include "Core/CellsInPicture.h"
#include "Core/Stopwatch.h"
#include "Vulkan/JointPicture.h"

#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <iterator>

namespace
{
// Of the bounds, half cells.
glm::dvec3 sizeOf(const exabricks::BrickedVolume& bricked)
{
  return glm::dvec3(bricked.volume.structure->tree.size);
}

// All that the renderer shows, parts of assemblies too; VTK makes the list anew when it is asked.
std::vector<vtkVolume*> listVolumes(vtkRenderer* ren)
{
  std::vector<vtkVolume*> all;
  vtkVolumeCollection* volumes = ren->GetVolumes();
  vtkCollectionSimpleIterator place;
  volumes->InitTraversal(place);
  while (vtkVolume* volume = volumes->GetNextVolume(place))
  {
    all.push_back(volume);
  }
  return all;
}

// Whether nothing was uploaded, compiled, selected or searched for a picture.
bool madeNothing(const exabricks::VolumeRenderer::Statistics& before,
  const exabricks::VolumeRenderer::Statistics& after)
{
  return before.structureUploads == after.structureUploads &&
    before.valueUploads == after.valueUploads && before.pipelineBuilds == after.pipelineBuilds &&
    before.shadowSearches == after.shadowSearches && before.colorTime == after.colorTime &&
    before.opacityTime == after.opacityTime &&
    (before.samplingTime == after.samplingTime || after.samplingTime == 0.0);
}
}

exabricks::View vtkExaBricksVolumeMapper::vtkInternals::MakeView(vtkRenderer* ren, vtkVolume* vol,
  const exabricks::BrickedVolume& bricked, int width, int height) const
{
  exabricks::View view = exabricks::makeView(ren, vol, bricked, width, height);
  view.quality.reconstruction = this->FindReconstruction(vol->GetProperty());
  view.quality.stepScale = this->Self->StepScale;
  view.quality.sampleDistance = this->Self->SampleDistance;
  view.quality.jittered = this->Self->UseJittering;
  view.quality.errorTolerance =
    bricked.volume.structure->hierarchy.whole ? 0.0 : this->Self->ErrorTolerance;
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
  if (view.lighting)
  {
    view.lighting->normalsOfOpacity = exabricks::takesNormalsFromOpacity(this->Self);
  }
  if (view.lighting && view.blending == exabricks::Blending::Composite &&
    this->Self->VolumetricScatteringBlending > 0.0f)
  {
    view.lighting->scattering = exabricks::Scattering{ this->Self->VolumetricScatteringBlending,
      exabricks::findScatteringAnisotropy(vol->GetProperty()),
      this->Self->GlobalIlluminationReach };
  }
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
    auto* amr = vtkOverlappingAMR::SafeDownCast(this->Self->GetDataObjectInput());
    return this->Compositor.drawSelection(ren, makeView, this->Renderer, amr, bricked);
  }
  if (this->Self->RenderToImage)
  {
    const exabricks::Viewport viewport = exabricks::findViewport();
    if (viewport.width <= 0 || viewport.height <= 0)
    {
      return std::string();
    }
    return this->Images.draw(this->Renderer,
      this->MakeView(ren, vol, bricked, viewport.width, viewport.height), sizeOf(bricked),
      { this->Self->FinalColorWindow, this->Self->FinalColorLevel });
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
    this->RaysOfPasses = others.empty() && !this->Compositor.isPeeling()
      ? static_cast<double>(this->Renderer.statistics().rays)
      : rays;
    this->Rays = static_cast<vtkIdType>(this->RaysOfPasses);
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
      other.internals->Coarseness = this->Coarseness;
    }
  }
  return fault;
}

// Whether a volume that overlaps this one can be drawn with it: it is the renderer's own, and not a
// part of another prop, which has a place and a visibility of its own; no other one has its mapper;
// and it has not been drawn alone yet.
bool vtkExaBricksVolumeMapper::vtkInternals::MayJoin(
  vtkRenderer* ren, vtkVolume* candidate, const std::vector<vtkVolume*>& all) const
{
  auto* mapper = vtkExaBricksVolumeMapper::SafeDownCast(candidate->GetMapper());
  if (!mapper || !candidate->GetVisibility() || mapper->GetNumberOfInputConnections(0) == 0 ||
    mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND || mapper->GetRenderToImage() ||
    mapper->GetFinalColorWindow() != this->Self->FinalColorWindow ||
    mapper->GetFinalColorLevel() != this->Self->FinalColorLevel ||
    ren->GetViewProps()->IsItemPresent(candidate) == 0)
  {
    return false;
  }
  const auto volumesOfMapper = std::count_if(
    all.begin(), all.end(), [&](vtkVolume* volume) { return volume->GetMapper() == mapper; });
  const vtkInternals& internals = *mapper->Internals;
  const bool drawnAlone =
    mapper != this->Self && internals.Drawn.is(ren) && !internals.DrawnWithOther.is(ren);
  return volumesOfMapper == 1 && !drawnAlone;
}

// The renderer's other volumes that overlap this one, or one of them, brought up to date. Those
// that cannot be drawn are left to say so themselves.
std::vector<vtkExaBricksVolumeMapper::vtkInternals::Overlapping>
vtkExaBricksVolumeMapper::vtkInternals::FindOverlapping(vtkRenderer* ren, vtkVolume* vol)
{
  std::vector<Overlapping> found;
  const std::vector<vtkVolume*> all = listVolumes(ren);
  if (!this->MayJoin(ren, vol, all))
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
  std::vector<vtkVolume*> candidates;
  std::copy_if(all.begin(), all.end(), std::back_inserter(candidates),
    [&](vtkVolume* other)
    {
      return other != vol && this->MayJoin(ren, other, all) && other->GetBounds() &&
        vtkMath::AreBoundsInitialized(other->GetBounds());
    });
  while (true)
  {
    const auto next = std::find_if(candidates.begin(), candidates.end(),
      [&](vtkVolume* other) { return overlaps(vtkBoundingBox(other->GetBounds())); });
    if (next == candidates.end())
    {
      return found;
    }
    vtkVolume* const other = *next;
    candidates.erase(next);
    vtkInternals& internals =
      *vtkExaBricksVolumeMapper::SafeDownCast(other->GetMapper())->Internals;
    if (auto bricked = internals.MakeReady(other))
    {
      boxes.emplace_back(other->GetBounds());
      found.push_back({ other, &internals, std::move(bricked) });
    }
  }
}

// Brings a volume up to date to be drawn with another one. Null: it cannot be drawn, and will say
// why when it is to be drawn itself.
std::shared_ptr<const exabricks::BrickedVolume> vtkExaBricksVolumeMapper::vtkInternals::MakeReady(
  vtkVolume* vol)
{
  this->Self->Update();
  auto bricked = this->GetBrickedVolume();
  if (!bricked || !exabricks::checkWithoutData(this->Self, vol).refused.empty() ||
    !this->CheckData(vol->GetProperty(), *bricked).empty())
  {
    return nullptr;
  }
  try
  {
    this->UpdateRenderer(vol->GetProperty(), bricked);
    return this->Renderer.prepare().empty() ? bricked : nullptr;
  }
  catch (const std::bad_alloc&)
  {
    this->Bricked.reset();
    return nullptr;
  }
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
    beside.quality.lagsShadows = view.quality.lagsShadows;
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
  exabricks::InteractiveSampling::Limits limits{ this->Self->MinimumImageSampleDistance,
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
        static_cast<double>(this->Renderer.statistics().rays),
        this->Renderer.statistics().marchTime, 0.0);
      this->InteractiveTime = this->Self->GetMTime();
    }
  }
  // Means of cells are no cells, nor categories; of cells without a value none is left out.
  const bool mayLeaveOut = !(this->Self->ErrorTolerance > 0.0) &&
    this->FindReconstruction(vol->GetProperty()) != exabricks::Reconstruction::Nearest &&
    !this->UsesNanColor(vol->GetProperty(), bricked);
  if (this->Interactive.knows() && mayLeaveOut)
  {
    // Levels that are to be left out are made while the picture is drawn without.
    limits.cells =
      this->FindCellsInPixels(this->MakeView(ren, vol, bricked, width, height), sizeOf(bricked));
    const int wanted = this->Interactive.choose(seconds, pixels, limits).levelsLeftOut;
    const int ready = wanted > 0 ? this->Renderer.makeCoarserAhead(wanted) : 0;
    limits.cells.resize(
      std::min(limits.cells.size(), 1 + static_cast<std::size_t>(std::min(wanted, ready))));
  }
  const exabricks::Coarseness chosen = this->Interactive.choose(seconds, pixels, limits);
  // What brings levels to the device is done in the same time.
  const double update = this->Renderer.secondsToUpdate(chosen.levelsLeftOut);
  limits.cells.resize(
    std::min(limits.cells.size(), 1 + static_cast<std::size_t>(chosen.levelsLeftOut)));
  return update > 0.0 ? this->Interactive.choose(seconds - update, pixels, limits) : chosen;
}

// [levels left out] of the largest of the finest cells in a picture, pixels along a side; infinite
// where the eye is within the bounds.
std::vector<double> vtkExaBricksVolumeMapper::vtkInternals::FindCellsInPixels(
  const exabricks::View& view, const glm::dvec3& size) const
{
  std::vector<double> cells = this->Renderer.finestCells();
  const double halfCell = cells.size() > 1 ? exabricks::findLargestHalfCell(view, size) : 0.0;
  for (double& cell : cells)
  {
    cell *= halfCell;
  }
  return cells;
}

// A view of so many pixels with the rays and steps that were chosen.
exabricks::View vtkExaBricksVolumeMapper::vtkInternals::MakeCoarseView(vtkRenderer* ren,
  vtkVolume* vol, const exabricks::BrickedVolume& bricked, int width, int height) const
{
  const double distance = this->Coarseness.imageSampleDistance;
  exabricks::View view = this->MakeView(ren, vol, bricked, exabricks::thinnedSize(width, distance),
    exabricks::thinnedSize(height, distance));
  view.quality.stepGrowth = this->Coarseness.stepGrowth;
  if (this->Coarseness.levelsLeftOut > 0)
  {
    view.quality.levelsLeftOut = this->Coarseness.levelsLeftOut;
  }
  view.quality.keepsSampling = this->AdjustsSampleDistances(ren);
  // Only where a picture comes that stands still.
  view.quality.lagsShadows =
    view.quality.keepsSampling && this->Self->InteractiveAdjustSampleDistances != 0;
  return view;
}
