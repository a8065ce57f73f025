// SPDX-License-Identifier: BSD-3-Clause
// The steps of a picture by VolumeRenderer, in their order, and what it keeps from one picture to
// the next.
#ifndef ExaBricksVulkanVolumeRendererInternals_h
#define ExaBricksVulkanVolumeRendererInternals_h

#include "Core/PredictedRays.h"
#include "Core/Stopwatch.h"
#include "Vulkan/DeviceSession.h"
#include "Vulkan/LevelsOfDetail.h"
#include "Vulkan/MarchPipelines.h"
#include "Vulkan/PictureJob.h"
#include "Vulkan/SamplingChoice.h"
#include "Vulkan/TransferBuffers.h"
#include "Vulkan/VolumeRenderer.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
/// Whether light is scattered by the medium.
inline bool scattersIn(const View& view)
{
  return view.blending == Blending::Composite && view.lighting &&
    view.lighting->scattering.has_value();
}

struct VolumeRenderer::Internals
{
  // What the caller set.
  Traversal RequestedTraversal = Traversal::Automatic;
  exabricks::Appearance Appearance;
  std::vector<float> GradientOpacity;
  exabricks::Visibility Visibility; // by the last view
  Extreme PassedBy = Extreme::None; // with it what a selection is made of
  bool UndefinedShown = false;

  // What is on the device. Rebuilt from the above when the device was lost.
  vulkan::DeviceSession Session;
  vulkan::LevelsOfDetail Levels;
  std::optional<vulkan::TransferBuffers> Colors;
  std::shared_ptr<vulkan::MarchPipelines> Pipelines;
  std::unique_ptr<vulkan::PictureJob> Job;
  std::unique_ptr<vulkan::SamplingChoice> Choice;

  std::optional<vulkan::ShadowCause> SteadyShadows; // of the last view that stood still
  std::optional<StepWeights> Weights;               // of steps, where an error is asked for
  bool SceneFailed = false; // the volume is too much for an acceleration structure
  View LostView;            // in which the device was lost twice
  Statistics Measured;

  vulkan::Selection MakeSelection() const
  {
    return { this->Visibility, this->Weights ? &*this->Weights : nullptr,
      { this->Measured.traversal == Traversal::RayQuery, this->PassedBy, this->UndefinedShown } };
  }

  // What was chosen for an error no longer holds.
  void ForgetChoice()
  {
    if (this->Choice)
    {
      this->Choice->forget();
    }
  }

  void InvalidateSelection()
  {
    this->ForgetChoice();
    this->Levels.invalidateSelection();
  }

  void Release()
  {
    this->SceneFailed = false;
    this->Levels.dropDevice();
    this->Colors.reset();
    this->Job.reset();
    this->Choice.reset();
    this->Pipelines.reset();
    this->Session.release();
  }

  void UpdateDevice()
  {
    const std::shared_ptr<vulkan::Device>& device = this->Session.device();
    this->Measured.device = this->Session.name();
    if (!this->Pipelines)
    {
      this->Pipelines = vulkan::MarchPipelines::ofDevice(device);
    }
    Traversal traversal = this->RequestedTraversal;
    if (traversal == Traversal::RayQuery && !device->hasRayQuery())
    {
      throw vulkan::Failure("expected a device with VK_KHR_ray_query for this traversal, " +
        device->name() + " lacks it. Use the k-d tree traversal, or the automatic one");
    }
    if (traversal == Traversal::Automatic)
    {
      // A CPU's ray query walks boxes in software, and slower than the k-d tree.
      traversal = device->hasRayQuery() && !device->isCpu() && !this->SceneFailed
        ? Traversal::RayQuery
        : Traversal::KdTree;
    }
    this->UseTraversal(traversal);
  }

  void UseTraversal(Traversal traversal)
  {
    if (traversal != this->Measured.traversal)
    {
      this->InvalidateSelection(); // each traversal has its own form of it
      this->Measured.traversal = traversal;
    }
  }

  void UpdateColors()
  {
    if (!this->Colors)
    {
      const Stopwatch watch;
      this->Colors.emplace(this->Session.device(), this->Appearance.makeTables(),
        this->GradientOpacity, this->Appearance.medium().planar);
      this->Measured.colorTime = watch.seconds();
    }
  }

  void UpdateFinestLevel()
  {
    const auto update = [&]
    {
      const vulkan::DeviceVolume& volume =
        *this->Levels.updateFinest(this->Session.device(), this->MakeSelection()).onDevice;
      this->Measured.activeRegions = volume.activeRegions();
      this->Measured.activeBoxes = volume.activeBoxes();
    };
    try
    {
      update();
    }
    catch (const vulkan::Failure&)
    {
      if (this->Measured.traversal == Traversal::KdTree ||
        this->RequestedTraversal != Traversal::Automatic)
      {
        throw;
      }
      // Too many boxes, or no memory for them: the k-d tree takes a fifth of it.
      this->SceneFailed = true;
      this->UseTraversal(Traversal::KdTree);
      update();
    }
  }

  void Update()
  {
    this->UpdateDevice();
    if (!this->Levels.empty())
    {
      this->UpdateColors();
      this->UpdateFinestLevel();
    }
    this->Count();
  }

  void Count()
  {
    this->Measured.deviceBytes = this->Levels.bytes() + (this->Colors ? this->Colors->bytes() : 0);
    this->Measured.uploadTime = this->Levels.uploadTime();
    this->Measured.opacityTime = this->Levels.selectionTime();
    this->Measured.structureUploads = this->Levels.structureUploads();
    this->Measured.valueUploads = this->Levels.valueUploads();
  }

  vulkan::MarchPass FindPass(const View& view, bool beginsAtDepth)
  {
    return vulkan::MarchPass(
      *this->Pipelines, this->FindVariant(view, beginsAtDepth), this->Measured.pipelineBuilds);
  }

  vulkan::MarchVariant FindVariant(const View& view, bool beginsAtDepth) const
  {
    vulkan::MarchVariant variant;
    variant.traversal = this->Measured.traversal;
    variant.reconstruction = view.quality.reconstruction;
    variant.blending = view.blending;
    variant.beginsAtDepth = beginsAtDepth;
    variant.shaded = isOfPlaces(view.blending) && view.lighting.has_value();
    variant.scattering = scattersIn(view);
    variant.normalsOfOpacity = variant.shaded && view.lighting->normalsOfOpacity;
    variant.hasGradientOpacity = isOfPlaces(view.blending) && !this->GradientOpacity.empty();
    variant.clipped = !view.cutaway.clippingPlanes.empty();
    variant.cropped = view.cutaway.cropping.has_value();
    variant.jittered =
      view.quality.jittered && view.quality.reconstruction != Reconstruction::Nearest;
    variant.showsUndefined = this->Appearance.showsUndefined();
    variant.isPart = this->Levels.volume().structure->hierarchy.whole != nullptr;
    variant.components = static_cast<std::uint32_t>(this->Levels.volume().components());
    variant.mixing =
      this->Appearance.isMixed() ? this->Appearance.medium().mixing : Mixing::Independent;
    return variant;
  }

  layout::Frame MakeFrame(const vulkan::LevelsOfDetail::Level& level, const View& view) const
  {
    layout::Frame frame{};
    level.onDevice->fill(frame);
    if (level.shadows)
    {
      level.shadows->fill(frame);
    }
    this->Colors->fill(frame);
    const Medium& medium = this->Appearance.medium();
    frame.componentWeights = medium.weights;
    frame.colorScale = medium.colorScale;
    frame.colorOffset = medium.colorOffset;
    frame.transmittanceExponent = this->Weights ? StepWeights::TransmittanceExponent : 0.0f;
    vulkan::fillView(frame, view, level.fromHalfCells);
    return frame;
  }

  // Levels and steps for the view's error tolerance. None: `progress` gave it up.
  std::optional<Sampling> Choose(const View& view, const Progress& progress)
  {
    if (!this->Choice)
    {
      this->Choice = std::make_unique<vulkan::SamplingChoice>(this->Session.device());
    }
    bool goesOn = true;
    const Sampling sampling = this->Choice->find(view, this->FindPass(view, false),
      [&](const View& sparse, const Sampling& tried) -> std::optional<layout::Frame>
      {
        vulkan::LevelsOfDetail::Level* level = this->Levels.findCoarser(
          tried.levelsLeftOut, this->Session.device(), this->MakeSelection());
        goesOn = goesOn && (!level || this->UpdateShadows(*level, view, progress));
        if (!goesOn || !level || level->onDevice->activeBoxes() == 0)
        {
          return std::nullopt;
        }
        View scaled = sparse;
        scaled.quality.stepScale = tried.stepScale;
        return this->MakeFrame(*level, scaled);
      });
    this->Measured.samplingTime = this->Choice->seconds();
    if (!goesOn)
    {
      this->Choice->forget();
      return std::nullopt;
    }
    return sampling;
  }

  // The view's own steps, without the levels that it leaves out, as many as there are.
  Sampling TakeRequested(const View& view)
  {
    Sampling sampling{ view.quality.levelsLeftOut.value_or(0), view.quality.stepScale };
    while (!this->Levels.findCoarser(
      sampling.levelsLeftOut, this->Session.device(), this->MakeSelection()))
    {
      --sampling.levelsLeftOut;
    }
    return sampling;
  }

  // Steps are weighted where an error is asked for.
  void UpdateWeights(bool weighted)
  {
    if (weighted != this->Weights.has_value())
    {
      this->Weights.reset();
      if (weighted)
      {
        this->Weights.emplace(TransferTable(this->Appearance.transferFunction()));
      }
      this->InvalidateSelection();
      this->Levels.dropCoarser();
    }
  }

  // What is looked up and what shows, for the view's way of blending.
  void UpdateAppearance(const View& view)
  {
    if (this->Appearance.setView(view))
    {
      this->Colors.reset();
      this->ForgetChoice();
      this->UpdateVisibility();
    }
  }

  // Whenever anything of the appearance has changed.
  void UpdateVisibility()
  {
    exabricks::Visibility visibility = this->Appearance.findVisibility();
    const Extreme extreme = this->Appearance.extreme();
    const bool undefined = this->Appearance.showsUndefined();
    if (this->Weights || !showTheSame(visibility, this->Visibility) || extreme != this->PassedBy ||
      undefined != this->UndefinedShown)
    {
      this->InvalidateSelection();
    }
    this->Visibility = std::move(visibility);
    this->PassedBy = extreme;
    this->UndefinedShown = undefined;
  }

  void Draw(View view, std::vector<glm::vec4>& picture, const Progress& progress)
  {
    this->UpdateAppearance(view);
    if (this->Appearance.showsUndefined())
    {
      view.quality.levelsLeftOut = 0; // means of cells are of those with a value
    }
    const bool searched =
      view.quality.errorTolerance > 0.0 && view.quality.reconstruction != Reconstruction::Nearest;
    if (searched)
    {
      view.quality.sampleDistance = 0.0;
    }
    // Weights are those of absorption by one function, wherever it is lit alike: else all steps are
    // equal.
    const bool weighted = searched && view.blending == Blending::Composite &&
      !this->Appearance.isMixed() && !scattersIn(view);
    this->UpdateWeights(weighted);
    this->Update();
    if (this->Levels.empty() || this->Measured.activeBoxes == 0)
    {
      this->Measured.marchTime = 0.0;
      this->Measured.rays = 0;
      this->Measured.levelsLeftOut = 0;
      this->ClearPicture(view, picture);
      return;
    }
    if (weighted)
    {
      view.quality.terminationOpacity =
        StepWeights::terminationOpacity(view.quality.errorTolerance);
    }
    const std::optional<Sampling> sampling =
      searched ? this->Choose(view, progress) : this->TakeRequested(view);
    vulkan::LevelsOfDetail::Level* const level = sampling
      ? this->Levels.findCoarser(
          sampling->levelsLeftOut, this->Session.device(), this->MakeSelection())
      : nullptr;
    if (!level || !this->UpdateShadows(*level, view, progress))
    {
      picture.clear();
      return;
    }
    view.quality.stepScale = view.quality.stepGrowth * sampling->stepScale;
    view.quality.sampleDistance *= view.quality.stepGrowth;
    this->Measured.stepScale = view.quality.stepScale;
    this->Measured.levelsLeftOut = sampling->levelsLeftOut;
    this->Count();
    const Stopwatch watch;
    this->March(*level, view, picture, progress);
    this->Measured.marchTime = watch.seconds();
  }

  // How much of each light comes to each cell. False: `progress` gave it up.
  bool UpdateShadows(
    vulkan::LevelsOfDetail::Level& level, const View& view, const Progress& progress)
  {
    if (!view.lighting || level.onDevice->activeBoxes() == 0)
    {
      return true;
    }
    if (!scattersIn(view) || !(view.lighting->scattering->reach > 0.0) ||
      view.lighting->lights.empty())
    {
      this->Levels.dropShadows();
      return true;
    }
    vulkan::ShadowCause cause(view);
    const bool lags =
      view.quality.lagsShadows && this->SteadyShadows && this->SteadyShadows->isOfSameMedium(cause);
    if (lags)
    {
      cause = *this->SteadyShadows;
    }
    else
    {
      this->SteadyShadows = cause;
    }
    if (level.shadows && level.shadows->serve(cause, lags))
    {
      return true;
    }
    const Stopwatch watch;
    const View steady = cause.steady(view);
    vulkan::Selection selection = this->MakeSelection();
    selection.form = { false, Extreme::None, this->UndefinedShown };
    const std::size_t lights =
      std::min<std::size_t>(view.lighting->lights.size(), layout::MOST_LIGHTS);
    if (!level.shadows || level.shadows->lights() != lights)
    {
      level.shadows.reset(); // before there is another one
      level.shadows = std::make_unique<vulkan::CellShadows>(this->Session.device(), *level.onDevice,
        level.volume, vulkan::LevelsOfDetail::select(level.volume, selection), lights);
    }
    vulkan::MarchVariant variant = this->FindVariant(steady, /*beginsAtDepth=*/false);
    variant.ofCells = true;
    variant.shaded = variant.scattering = variant.normalsOfOpacity = variant.jittered = false;
    const bool found = level.shadows->find(cause, this->MakeFrame(level, steady),
      vulkan::MarchPass(*this->Pipelines, variant, this->Measured.pipelineBuilds),
      [&] { return !progress || progress(0.0); });
    this->Measured.shadowTime = watch.seconds();
    ++this->Measured.shadowSearches;
    return found;
  }

  // Why the volume cannot be drawn in that view; empty: it can.
  std::string Check(const View& view) const
  {
    const std::string unfit = this->CheckMedium();
    if (!unfit.empty() || !this->Appearance.isMixed())
    {
      return unfit;
    }
    const Mixing mixing = this->Appearance.medium().mixing;
    return view.blending == Blending::Isosurface && mixing != Mixing::Planar &&
        mixing != Mixing::ColorAndOpacity
      ? "independent components, and red, green and blue, have no iso-surfaces together"
      : "";
  }

  std::string CheckMedium() const
  {
    return this->Levels.empty() ? std::string() : this->Appearance.checkMedium();
  }

  void ClearPicture(const View& view, std::vector<glm::vec4>& picture) const
  {
    picture.assign(
      static_cast<std::size_t>(view.target.width) * view.target.height, glm::vec4(0.0f));
  }

  void March(const vulkan::LevelsOfDetail::Level& level, const View& view,
    std::vector<glm::vec4>& picture, const Progress& progress)
  {
    this->Measured.rays = 0;
    if (level.onDevice->activeBoxes() == 0)
    {
      this->ClearPicture(view, picture);
      return;
    }
    if (!this->Job)
    {
      this->Job = std::make_unique<vulkan::PictureJob>(this->Session.device());
    }
    this->Job->begin(this->MakeFrame(level, view), view.target,
      this->FindPass(view, view.target.nearDepth != nullptr), toleranceOfPredictions(view));
    while (this->Job->march())
    {
      if (progress && !progress(this->Job->progress()))
      {
        picture.clear();
        return;
      }
    }
    this->Measured.rays = this->Job->rays();
    const glm::vec4* const pixels = this->Job->pixels();
    picture.assign(
      pixels, pixels + static_cast<std::size_t>(view.target.width) * view.target.height);
  }

  std::string Run(const std::function<void()>& work)
  {
    return this->Session.run(work, { [this] { this->Release(); }, [this] { this->Job.reset(); } });
  }
};
}

#endif
