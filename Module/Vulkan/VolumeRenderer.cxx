// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/VolumeRenderer.h"

#include "Core/Coarsening.h"
#include "Core/Stopwatch.h"
#include "Core/TransferTable.h"
#include "Vulkan/DeviceVolume.h"
#include "Vulkan/KnownEffort.h"
#include "Vulkan/MarchPass.h"

#include <cmath>
#include <optional>

namespace exabricks
{
namespace
{
// About as many pixels tell the error of a picture; at most so many are drawn where few of them
// show anything. Where still few do, they cost little: they get steps that suit all.
constexpr double PilotPixels = 3000.0;
constexpr double MostPilotPixels = 64.0 * PilotPixels;
constexpr double StepScaleOfFew = 0.25;

// The subject, or what is left of it without some of its finest levels.
struct Detail
{
  Volume volume;
  glm::dmat4 fromHalfCells{ 1.0 };                // of the subject
  std::unique_ptr<vulkan::DeviceVolume> onDevice; // none: not yet, or no longer
  bool opacityReady = false;
};
}

struct VolumeRenderer::Internals
{
  // What the caller set.
  std::string Wanted;
  Traversal WantedTraversal = Traversal::Automatic;
  std::shared_ptr<const MarchProgram> Program;
  TransferFunction Transfer;

  std::vector<Detail>
    Details;                 // the subject, and then one level less each; none: there is no subject
  bool CoarsestMade = false; // and there are no more levels to leave out

  // What is on the device, beside what each Detail has there. Rebuilt from the above when the
  // device was lost.
  std::shared_ptr<vulkan::Device> Device;
  vulkan::Buffer Bins;
  vulkan::Buffer Knots;
  float IntegralUnit = 1.0f;
  vulkan::Buffer Extra;
  std::shared_ptr<vulkan::MarchPipelines> Pipelines;
  std::unique_ptr<vulkan::MarchPass> Pass;
  bool ColorsReady = false;
  bool Weighted = false; // steps are, by what they err
  KnownEffort Known;
  bool ProgramReady = false;
  bool SceneFailed = false; // the volume is too much for an acceleration structure
  std::string Fault;        // does not go away until something is set anew

  Statistics Figures;

  void DropVolume()
  {
    this->SceneFailed = false;
    this->Known = {};
    for (Detail& detail : this->Details)
    {
      detail.onDevice.reset();
      detail.opacityReady = false;
    }
  }

  void DropOpacity()
  {
    this->Known = {};
    for (Detail& detail : this->Details)
    {
      detail.opacityReady = false;
    }
  }

  void DropProgram()
  {
    this->ProgramReady = false;
    this->Extra = {};
    this->Pass.reset();
    this->Pipelines.reset();
  }

  void DropAll()
  {
    this->DropVolume();
    this->DropProgram();
    this->ColorsReady = false;
    this->Bins = {};
    this->Knots = {};
    this->Device.reset();
  }

  void UpdateDevice()
  {
    if (!this->Device)
    {
      this->Device = vulkan::Device::acquire(this->Wanted);
      this->Figures.device = this->Device->name();
    }
    Traversal traversal = this->Program ? Traversal::KdTree : this->WantedTraversal;
    if (traversal == Traversal::RayQuery && !this->Device->hasRayQuery())
    {
      throw vulkan::Failure("expected a device with VK_KHR_ray_query for this traversal, " +
        this->Device->name() + " lacks it. Use the k-d tree traversal, or the automatic one");
    }
    if (traversal == Traversal::Automatic)
    {
      // A CPU's ray query walks boxes in software, and slower than the k-d tree.
      traversal = this->Device->hasRayQuery() && !this->Device->isCpu() && !this->SceneFailed
        ? Traversal::RayQuery
        : Traversal::KdTree;
    }
    if (traversal != this->Figures.traversal)
    {
      this->DropOpacity(); // each traversal has its own form of them
      this->Figures.traversal = traversal;
    }
  }

  void UpdateColors()
  {
    if (this->ColorsReady)
    {
      return;
    }
    const Stopwatch watch;
    const TransferTable table(this->Transfer);
    this->Bins = vulkan::makeBuffer(this->Device, table.bins, "the transfer function");
    this->Knots = vulkan::makeBuffer(this->Device, table.knots, "the transfer function");
    this->IntegralUnit = table.integralUnit;
    this->ColorsReady = true;
    this->Figures.colorTime = watch.seconds();
  }

  ActiveRegions SelectActiveRegions(const Volume& volume, bool boxes) const
  {
    if (this->Program && !this->Program->skipsSpace)
    {
      return selectAllRegions(volume, boxes);
    }
    std::optional<StepWeights> weights;
    if (this->Weighted)
    {
      weights.emplace(TransferTable(this->Transfer));
    }
    return selectActiveRegions(volume, this->Transfer, weights ? &*weights : nullptr, boxes);
  }

  bool IsSubject(const Detail& detail) const { return &detail == this->Details.data(); }

  // Brings a detail up to date on the device.
  void UpdateDetail(Detail& detail)
  {
    if (!detail.onDevice)
    {
      const Stopwatch watch;
      detail.opacityReady = false;
      detail.onDevice = std::make_unique<vulkan::DeviceVolume>(this->Device, detail.volume);
      if (this->IsSubject(detail))
      {
        this->Figures.uploadTime = watch.seconds();
      }
    }
    if (detail.opacityReady)
    {
      return;
    }
    const Stopwatch watch;
    try
    {
      detail.onDevice->setActive(
        this->SelectActiveRegions(detail.volume, this->Figures.traversal == Traversal::RayQuery));
    }
    catch (const vulkan::Failure&)
    {
      if (this->Figures.traversal == Traversal::KdTree ||
        this->WantedTraversal != Traversal::Automatic || !this->IsSubject(detail))
      {
        throw;
      }
      // Too many boxes, or no memory for them: the k-d tree takes a fifth of it.
      this->SceneFailed = true;
      this->Figures.traversal = Traversal::KdTree;
      detail.onDevice->setActive(this->SelectActiveRegions(detail.volume, false));
    }
    detail.opacityReady = true;
    if (this->IsSubject(detail))
    {
      this->Figures.opacityTime = watch.seconds();
    }
  }

  // The subject without so many levels, up to date; null: it has not so many to leave out, or there
  // is no memory to do so.
  Detail* FindDetail(int levelsLeftOut)
  {
    if (levelsLeftOut <= 0)
    {
      return &this->Details.front(); // Update() has seen to it
    }
    try
    {
      while (levelsLeftOut >= static_cast<int>(this->Details.size()))
      {
        const Detail& finer = this->Details.back();
        Detail detail;
        const std::optional<CoarserStructure> coarser =
          this->CoarsestMade ? std::nullopt : coarsen(*finer.volume.structure);
        if (!coarser)
        {
          this->CoarsestMade = true;
          return nullptr;
        }
        detail.volume = { coarser->structure, coarsen(finer.volume, *coarser->structure) };
        detail.fromHalfCells = coarser->fromHalfCells * finer.fromHalfCells;
        this->Details.push_back(std::move(detail));
      }
      this->UpdateDetail(this->Details[levelsLeftOut]);
      return &this->Details[levelsLeftOut];
    }
    catch (const std::bad_alloc&)
    {
    }
    catch (const vulkan::Failure&)
    {
    }
    catch (const vk::OutOfDeviceMemoryError&)
    {
    }
    this->DropCoarser(levelsLeftOut);
    this->CoarsestMade = true;
    return nullptr;
  }

  // Leaves details with fewer levels left out than that, at least the subject.
  void DropCoarser(int levelsLeftOut)
  {
    const auto most = static_cast<std::size_t>(std::max(levelsLeftOut, 1));
    if (this->Details.size() > most)
    {
      this->Details.erase(this->Details.begin() + most, this->Details.end());
    }
  }

  void UpdateProgram()
  {
    if (!this->ProgramReady && this->Program)
    {
      this->Extra = vulkan::makeBuffer(this->Device, this->Program->extra, "a program's own data");
    }
    this->ProgramReady = true;
  }

  void Update()
  {
    this->UpdateDevice();
    this->UpdateProgram();
    if (!this->Details.empty())
    {
      this->UpdateColors();
      Detail& subject = this->Details.front();
      this->UpdateDetail(subject);
      this->Figures.activeRegions = subject.onDevice->activeRegions();
      this->Figures.activeBoxes = subject.onDevice->activeBoxes();
    }
    this->CountBytes();
  }

  void CountBytes()
  {
    this->Figures.deviceBytes = this->Bins.bytes() + this->Knots.bytes() + this->Extra.bytes();
    for (const Detail& detail : this->Details)
    {
      this->Figures.deviceBytes += detail.onDevice ? detail.onDevice->bytes() : 0;
    }
  }

  // Draws some of the pixels of the view, or of the whole that it is a part of, until it knows
  // which levels and steps err as much as they may; more of them where few show anything.
  Effort FindEffort(View view)
  {
    if (view.target.whole)
    {
      view.camera = view.target.whole->camera;
      view.target.width = view.target.whole->width;
      view.target.height = view.target.whole->height;
      view.target.depth = nullptr;
    }
    view.target.nearDepth = nullptr;
    if (this->Known.is(view))
    {
      this->Figures.pilotTime = 0.0;
      return this->Known.effort;
    }
    const Stopwatch watch;
    std::optional<Effort> effort;
    const double pixels = static_cast<double>(view.target.width) * view.target.height;
    for (double some = PilotPixels; !effort; some *= 8.0)
    {
      const double sparse = std::max(1.0, std::sqrt(pixels / some));
      View pilot = view;
      pilot.target.width = std::max(1, static_cast<int>(view.target.width / sparse));
      pilot.target.height = std::max(1, static_cast<int>(view.target.height / sparse));
      std::vector<float> depth;
      if (view.target.depth)
      {
        // of the pixel that a pilot's ray goes through
        for (std::int64_t y = 0; y < pilot.target.height; ++y)
        {
          const std::int64_t row = (2 * y + 1) * view.target.height / (2 * pilot.target.height);
          for (std::int64_t x = 0; x < pilot.target.width; ++x)
          {
            depth.push_back(
              view.target.depth[(2 * x + 1) * view.target.width / (2 * pilot.target.width) +
                view.target.width * row]);
          }
        }
        pilot.target.depth = depth.data();
      }
      effort = findEffort(view.quality.errorTolerance,
        [&](int levelsLeftOut, double stepScale, std::vector<glm::vec4>& picture)
        {
          const Detail* detail = levelsLeftOut <= view.quality.levelsLeftOut.value_or(levelsLeftOut)
            ? this->FindDetail(levelsLeftOut)
            : nullptr;
          if (detail)
          {
            pilot.quality.stepScale = stepScale;
            this->Draw(*detail, pilot, picture);
          }
          return detail != nullptr;
        });
      if (!effort && some >= std::min(pixels, MostPilotPixels))
      {
        effort = Effort{ 0, StepScaleOfFew };
      }
    }
    this->Known = KnownEffort(view, *effort);
    this->Figures.pilotTime = watch.seconds();
    return *effort;
  }

  void Draw(const Detail& detail, View view, std::vector<glm::vec4>& picture)
  {
    if (detail.onDevice->activeBoxes() == 0)
    {
      picture.assign(
        static_cast<std::size_t>(view.target.width) * view.target.height, glm::vec4(0.0f));
      return;
    }
    if (!this->Pipelines)
    {
      this->Pipelines = std::make_shared<vulkan::MarchPipelines>(this->Device, this->Program);
    }
    if (!this->Pass)
    {
      this->Pass = std::make_unique<vulkan::MarchPass>(this->Device, this->Pipelines);
    }
    vulkan::MarchVariant variant;
    variant.traversal = this->Figures.traversal;
    variant.reconstruction = view.quality.reconstruction;
    variant.beginsAtDepth = view.target.nearDepth != nullptr;
    layout::Frame frame{};
    detail.onDevice->fill(frame);
    frame.transferBins = this->Bins.address();
    frame.transferKnots = this->Knots.address();
    frame.integralUnit = this->IntegralUnit;
    frame.extra = this->Extra.address();
    frame.transmittanceExponent = this->Weighted ? 1.0f / 3.0f : 0.0f; // as StepWeights has it
    view.camera.ndcToHalfCells = detail.fromHalfCells * view.camera.ndcToHalfCells;
    this->Pass->run(variant, frame, view, picture);
  }

  void March(View view, std::vector<glm::vec4>& picture)
  {
    const bool weighted =
      view.quality.errorTolerance > 0.0 && view.quality.reconstruction != Reconstruction::Nearest;
    if (weighted != this->Weighted)
    {
      this->Weighted = weighted;
      this->DropOpacity();
      this->DropCoarser(1);
      this->CoarsestMade = false;
    }
    this->Update();
    if (this->Details.empty())
    {
      picture.assign(
        static_cast<std::size_t>(view.target.width) * view.target.height, glm::vec4(0.0f));
      return;
    }
    if (weighted)
    {
      view.quality.terminationOpacity = std::max(1.0 - 0.25 * view.quality.errorTolerance, 0.5);
    }
    Effort effort;
    if (weighted && !this->Program) // another program's output need not be a picture
    {
      effort = this->FindEffort(view);
    }
    else
    {
      effort.stepScale = view.quality.stepScale;
      effort.levelsLeftOut = view.quality.levelsLeftOut.value_or(0);
      while (!this->FindDetail(effort.levelsLeftOut))
      {
        --effort.levelsLeftOut;
      }
    }
    this->CountBytes();
    this->Figures.stepScale = view.quality.stepScale = effort.stepScale;
    this->Figures.levelsLeftOut = effort.levelsLeftOut;
    const Stopwatch watch;
    this->Draw(this->Details[effort.levelsLeftOut], view, picture);
    this->Figures.marchTime = watch.seconds();
  }

  // Runs `work`, and turns what is thrown into a message. A lost device is given one more try, with
  // everything built anew.
  template <typename Work>
  std::string Guard(const Work& work)
  {
    if (!this->Fault.empty())
    {
      return this->Fault;
    }
    for (int attempt = 0;; ++attempt)
    {
      try
      {
        work();
        return {};
      }
      catch (const vk::DeviceLostError& error)
      {
        if (this->Device)
        {
          this->Device->markLost();
        }
        this->DropAll();
        if (attempt == 1)
        {
          return std::string("the Vulkan device was lost twice (") + error.what() +
            "). Its driver's log may say why; choose another device by the property Device or "
            "EXABRICKS_DEVICE";
        }
      }
      catch (const std::bad_alloc&)
      {
        this->DropAll();
        return "out of memory on the host. Read fewer levels, or make the window smaller";
      }
      catch (const vk::OutOfHostMemoryError& error)
      {
        this->DropAll();
        return "out of memory on the host, in the driver of " + this->Figures.device + " (" +
          error.what() + "). Read fewer levels, or make the window smaller";
      }
      catch (const vk::OutOfDeviceMemoryError& error)
      {
        this->DropAll();
        return "out of device memory on " + this->Figures.device + " (" + error.what() +
          "). Use fewer levels, make the window smaller, or use a device with more memory";
      }
      catch (const std::length_error& error)
      {
        this->DropAll();
        this->Fault = error.what(); // the volume has too many regions, and Core has words for it
        return this->Fault;
      }
      catch (const vulkan::PictureFailure& failure)
      {
        this->Pass.reset(); // all the rest can draw a smaller picture
        return failure.what();
      }
      catch (const vulkan::Failure& failure)
      {
        this->DropAll();
        this->Fault = failure.what();
        return this->Fault;
      }
      catch (const std::exception& error)
      {
        this->DropAll();
        return std::string("Vulkan failed: ") + error.what();
      }
    }
  }
};

VolumeRenderer::VolumeRenderer()
  : Data(new Internals)
{
}

VolumeRenderer::~VolumeRenderer() = default;

void VolumeRenderer::selectDevice(const std::string& wanted)
{
  if (wanted != this->Data->Wanted)
  {
    this->Data->Fault.clear();
    this->Data->DropAll();
    this->Data->Wanted = wanted;
  }
}

void VolumeRenderer::selectTraversal(Traversal traversal)
{
  if (traversal != this->Data->WantedTraversal)
  {
    this->Data->Fault.clear();
    this->Data->WantedTraversal = traversal;
  }
}

void VolumeRenderer::selectProgram(std::shared_ptr<const MarchProgram> program)
{
  if (program != this->Data->Program)
  {
    this->Data->Fault.clear();
    this->Data->DropProgram();
    this->Data->DropOpacity(); // a program may skip other regions
    this->Data->Program = std::move(program);
  }
}

void VolumeRenderer::setVolume(Volume volume)
{
  this->Data->Fault.clear();
  this->Data->DropVolume();
  this->Data->Details.clear();
  this->Data->CoarsestMade = false;
  if (volume)
  {
    this->Data->Details.emplace_back();
    this->Data->Details.back().volume = std::move(volume);
  }
}

void VolumeRenderer::setTransferFunction(const TransferFunction& transfer)
{
  this->Data->Fault.clear();
  this->Data->ColorsReady = false;
  if (this->Data->Weighted || !transfer.showsTheSame(this->Data->Transfer))
  {
    this->Data->DropOpacity();
  }
  this->Data->Transfer = transfer;
}

std::string VolumeRenderer::prepare()
{
  return this->Data->Guard([&] { this->Data->Update(); });
}

std::string VolumeRenderer::render(const View& view, std::vector<glm::vec4>& picture)
{
  const std::vector<Detail>& details = this->Data->Details;
  if (!details.empty() &&
    (view.quality.reconstruction == Reconstruction::Completed) !=
      (details.front().volume.values->layer == 1))
  {
    return "the volume's scalars do not fit the reconstruction: completed ones, with a layer "
           "around "
           "each brick, are for Completed alone";
  }
  return this->Data->Guard([&] { this->Data->March(view, picture); });
}

void VolumeRenderer::release()
{
  this->Data->Fault.clear();
  this->Data->DropAll();
}

const VolumeRenderer::Statistics& VolumeRenderer::statistics() const { return this->Data->Figures; }

std::vector<std::string> VolumeRenderer::listDevices()
{
  try
  {
    return vulkan::Device::list();
  }
  catch (const std::exception&)
  {
    return {};
  }
}
}
