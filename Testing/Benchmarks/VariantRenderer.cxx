// SPDX-License-Identifier: BSD-3-Clause
#include "VariantRenderer.h"

#include "Core/Stopwatch.h"
#include "Vulkan/LevelsOfDetail.h"
#include "Vulkan/PictureJob.h"
#include "Vulkan/TransferBuffers.h"

#include <exception>
#include <optional>

namespace exabricks
{
namespace benchmarks
{
struct VariantRenderer::Internals
{
  explicit Internals(std::shared_ptr<const MarchProgram> program)
    : Program(std::move(program))
  {
    this->Measured.traversal = Traversal::KdTree;
  }

  const std::shared_ptr<const MarchProgram> Program;
  const std::shared_ptr<vulkan::Device> Device = vulkan::Device::acquire("");
  const vulkan::Buffer OwnData =
    vulkan::makeBuffer(this->Device, this->Program->data, "a method's own data");
  vulkan::MarchPipelines Pipelines{ this->Device, this->Program->shader };
  vulkan::PictureJob Job{ this->Device };
  vulkan::LevelsOfDetail Levels;
  std::optional<vulkan::TransferBuffers> Colors;
  TransferFunction Transfer;
  std::optional<StepWeights> Weights;
  VolumeRenderer::Statistics Measured;

  vulkan::Selection MakeSelection() const
  {
    vulkan::Selection selection;
    if (this->Program->skipsSpace)
    {
      selection.visibility = { this->Transfer };
    }
    selection.weights = this->Weights ? &*this->Weights : nullptr;
    return selection;
  }

  void UpdateWeights(bool weighted)
  {
    if (weighted != this->Weights.has_value())
    {
      this->Weights.reset();
      if (weighted)
      {
        this->Weights.emplace(TransferTable(this->Transfer));
      }
      this->Levels.invalidateSelection();
    }
  }

  const vulkan::LevelsOfDetail::Level& Update(int levelsLeftOut)
  {
    if (!this->Colors)
    {
      this->Colors.emplace(this->Device, std::vector{ TransferTable(this->Transfer) });
    }
    const vulkan::LevelsOfDetail::Level* level =
      &this->Levels.updateFinest(this->Device, this->MakeSelection());
    if (levelsLeftOut > 0)
    {
      level = this->Levels.findCoarser(levelsLeftOut, this->Device, this->MakeSelection());
    }
    if (!level)
    {
      throw std::runtime_error("there are not so many levels to leave out");
    }
    this->Measured.activeRegions = level->onDevice->activeRegions();
    this->Measured.activeBoxes = level->onDevice->activeBoxes();
    this->Measured.deviceBytes =
      this->Levels.bytes() + this->Colors->bytes() + this->OwnData.bytes();
    return *level;
  }

  void Draw(View view, std::vector<glm::vec4>& picture)
  {
    this->UpdateWeights(view.quality.errorTolerance > 0.0);
    if (this->Weights)
    {
      view.quality.terminationOpacity =
        StepWeights::terminationOpacity(view.quality.errorTolerance);
    }
    const vulkan::LevelsOfDetail::Level& level =
      this->Update(view.quality.levelsLeftOut.value_or(0));
    const Stopwatch watch;
    layout::Frame frame{};
    level.onDevice->fill(frame);
    this->Colors->fill(frame);
    frame.activeBoxes = this->OwnData.address();
    frame.transmittanceExponent = this->Weights ? StepWeights::TransmittanceExponent : 0.0f;
    vulkan::fillView(frame, view, level.fromHalfCells);
    vulkan::MarchVariant variant;
    variant.reconstruction = view.quality.reconstruction;
    variant.beginsAtDepth = view.target.nearDepth != nullptr;
    std::size_t builds = 0;
    this->Job.begin(frame, view.target, vulkan::MarchPass(this->Pipelines, variant, builds));
    while (this->Job.march())
    {
    }
    const glm::vec4* const pixels = this->Job.pixels();
    picture.assign(
      pixels, pixels + static_cast<std::size_t>(view.target.width) * view.target.height);
    this->Measured.stepScale = view.quality.stepScale;
    this->Measured.marchTime = watch.seconds();
  }
};

VariantRenderer::VariantRenderer(std::shared_ptr<const MarchProgram> program)
  : Data(new Internals(std::move(program)))
{
}

VariantRenderer::~VariantRenderer() = default;

void VariantRenderer::setVolume(const Volume& volume) { this->Data->Levels.setVolume(volume); }

void VariantRenderer::setTransferFunction(const TransferFunction& transfer)
{
  this->Data->Transfer = transfer;
  this->Data->Colors.reset();
  if (this->Data->Weights)
  {
    this->Data->Weights.emplace(TransferTable(transfer));
  }
  this->Data->Levels.invalidateSelection();
}

std::string VariantRenderer::prepare()
{
  try
  {
    this->Data->Update(0);
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

std::string VariantRenderer::render(const View& view, std::vector<glm::vec4>& picture)
{
  try
  {
    this->Data->Draw(view, picture);
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

const VolumeRenderer::Statistics& VariantRenderer::statistics() const
{
  return this->Data->Measured;
}
}
}
