// SPDX-License-Identifier: BSD-3-Clause
#include "Vulkan/VolumeRenderer.h"

#include "Core/TransferTable.h"
#include "Vulkan/DeviceVolume.h"
#include "Vulkan/MarchPass.h"

#include <chrono>
#include <cmath>
#include <optional>

namespace exabricks
{
namespace
{
class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

// About as many pixels tell the error of a picture.
constexpr double PilotPixels = 3000.0;

// Each region with bricks, as a whole.
ActiveRegions selectAllRegions(Volume volume, bool boxes)
{
  ValueRanges whole;
  whole.regions.assign(volume.tree->regions.size(), { 0.0f, 1.0f });
  volume.ranges = &whole;
  return selectActiveRegions(
    volume, TransferFunction({ { 0.0, glm::dvec4(1.0) } }), nullptr, boxes);
}
}

struct VolumeRenderer::Internals
{
  // What the caller set.
  std::string Wanted;
  Traversal WantedTraversal = Traversal::Automatic;
  std::shared_ptr<const MarchProgram> Program;
  Volume Subject;
  TransferFunction Transfer;

  // What is on the device. Rebuilt from the above when the device was lost.
  std::shared_ptr<vulkan::Device> Device;
  std::unique_ptr<vulkan::DeviceVolume> OnDevice; // the subject
  vulkan::Buffer Bins;
  vulkan::Buffer Knots;
  float IntegralUnit = 1.0f;
  vulkan::Buffer Extra;
  std::unique_ptr<vulkan::MarchPass> Pass;
  bool ColorsReady = false;
  bool OpacityReady = false;
  bool Weighted = false;   // steps are, by what they err
  double PilotScale = 1.0; // found last
  bool ProgramReady = false;
  bool SceneFailed = false; // the volume is too much for an acceleration structure
  std::string Fault;        // does not go away until something is set anew

  Statistics Figures;

  void DropVolume()
  {
    this->SceneFailed = false;
    this->OnDevice.reset();
    this->OpacityReady = false;
  }

  void DropProgram()
  {
    this->ProgramReady = false;
    this->Extra = {};
    this->Pass.reset();
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
      this->OpacityReady = false; // each traversal has its own form of them
      this->Figures.traversal = traversal;
    }
  }

  void UpdateVolume()
  {
    if (this->OnDevice)
    {
      return;
    }
    const Stopwatch watch;
    this->DropVolume();
    this->OnDevice = std::make_unique<vulkan::DeviceVolume>(this->Device, this->Subject);
    this->Figures.uploadTime = watch.seconds();
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

  ActiveRegions SelectActiveRegions(bool boxes) const
  {
    if (this->Program && !this->Program->skipsSpace)
    {
      return selectAllRegions(this->Subject, boxes);
    }
    std::optional<StepWeights> weights;
    if (this->Weighted)
    {
      weights.emplace(TransferTable(this->Transfer));
    }
    return selectActiveRegions(this->Subject, this->Transfer, weights ? &*weights : nullptr, boxes);
  }

  void UpdateActiveRegions()
  {
    if (this->OpacityReady)
    {
      return;
    }
    const Stopwatch watch;
    try
    {
      this->OnDevice->setActive(
        this->SelectActiveRegions(this->Figures.traversal == Traversal::RayQuery));
    }
    catch (const vulkan::Failure&)
    {
      if (this->Figures.traversal == Traversal::KdTree ||
        this->WantedTraversal != Traversal::Automatic)
      {
        throw;
      }
      // Too many boxes, or no memory for them: the k-d tree takes a fifth of it.
      this->SceneFailed = true;
      this->Figures.traversal = Traversal::KdTree;
      this->OnDevice->setActive(this->SelectActiveRegions(false));
    }
    this->Figures.activeRegions = this->OnDevice->activeRegions();
    this->Figures.activeBoxes = this->OnDevice->activeBoxes();
    this->OpacityReady = true;
    this->Figures.opacityTime = watch.seconds();
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
    if (this->Subject.tree)
    {
      this->UpdateVolume();
      this->UpdateColors();
      this->UpdateActiveRegions();
    }
    this->Figures.deviceBytes = this->Bins.bytes() + this->Knots.bytes() + this->Extra.bytes() +
      (this->OnDevice ? this->OnDevice->bytes() : 0);
  }

  // Draws some of the view's pixels until it knows which steps err as much as they may; more of
  // them where few show anything.
  double FindStepScale(const layout::Frame& frame, const View& view)
  {
    const Stopwatch watch;
    std::optional<double> scale;
    const double pixels = static_cast<double>(view.width) * view.height;
    for (double some = PilotPixels; !scale; some *= 8.0)
    {
      const double sparse = std::max(1.0, std::sqrt(pixels / some));
      View pilot = view;
      pilot.width = std::max(1, static_cast<int>(view.width / sparse));
      pilot.height = std::max(1, static_cast<int>(view.height / sparse));
      std::vector<float> depth;
      if (view.depth)
      {
        // of the pixel that a pilot's ray goes through
        for (std::int64_t y = 0; y < pilot.height; ++y)
        {
          const std::int64_t row = (2 * y + 1) * view.height / (2 * pilot.height);
          for (std::int64_t x = 0; x < pilot.width; ++x)
          {
            depth.push_back(
              view.depth[(2 * x + 1) * view.width / (2 * pilot.width) + view.width * row]);
          }
        }
        pilot.depth = depth.data();
      }
      scale = findStepScale(view.errorTolerance, this->PilotScale,
        [&](double stepScale, std::vector<glm::vec4>& picture)
        {
          pilot.stepScale = stepScale;
          this->Pass->run(frame, pilot, picture);
        });
      if (!scale && some >= pixels)
      {
        scale = std::min(this->PilotScale, 1.0); // next to nothing is drawn
      }
    }
    this->PilotScale = *scale; // the next picture is likely to be much like this one
    this->Figures.pilotTime = watch.seconds();
    return *scale;
  }

  void March(View view, std::vector<glm::vec4>& picture)
  {
    const bool weighted =
      view.errorTolerance > 0.0 && view.reconstruction != Reconstruction::Nearest;
    if (weighted != this->Weighted)
    {
      this->Weighted = weighted;
      this->OpacityReady = false;
    }
    this->Update();
    if (!this->Pass || this->Pass->traversal() != this->Figures.traversal ||
      this->Pass->reconstruction() != view.reconstruction)
    {
      this->Pass = std::make_unique<vulkan::MarchPass>(
        this->Device, this->Figures.traversal, view.reconstruction, this->Program.get());
    }
    if (!this->Subject.tree || this->Figures.activeBoxes == 0)
    {
      picture.assign(static_cast<std::size_t>(view.width) * view.height, glm::vec4(0.0f));
      return;
    }
    layout::Frame frame{};
    this->OnDevice->fill(frame);
    frame.transferBins = this->Bins.address();
    frame.transferKnots = this->Knots.address();
    frame.integralUnit = this->IntegralUnit;
    frame.extra = this->Extra.address();
    if (weighted)
    {
      frame.veiled = 1.0f / 3.0f; // as StepWeights has it
      view.terminationOpacity = std::max(1.0 - 0.25 * view.errorTolerance, 0.5);
      // What another program draws may be no picture.
      view.stepScale = this->Program ? view.stepScale : this->FindStepScale(frame, view);
    }
    this->Figures.stepScale = view.stepScale;
    const Stopwatch watch;
    this->Pass->run(frame, view, picture);
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
        return "out of memory on the host";
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
    this->Data->OpacityReady = false; // a program may skip other regions
    this->Data->Program = std::move(program);
  }
}

void VolumeRenderer::setVolume(const Volume& volume)
{
  this->Data->Fault.clear();
  this->Data->DropVolume();
  this->Data->Subject = volume;
}

void VolumeRenderer::setTransferFunction(const TransferFunction& transfer)
{
  this->Data->Fault.clear();
  this->Data->ColorsReady = false;
  this->Data->OpacityReady = this->Data->OpacityReady && !this->Data->Weighted &&
    transfer.showsTheSame(this->Data->Transfer);
  this->Data->Transfer = transfer;
}

std::string VolumeRenderer::prepare()
{
  return this->Data->Guard([&] { this->Data->Update(); });
}

std::string VolumeRenderer::render(const View& view, std::vector<glm::vec4>& picture)
{
  const Scalars* scalars = this->Data->Subject.scalars;
  if (scalars && (view.reconstruction == Reconstruction::Completed) != (scalars->layer == 1))
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
