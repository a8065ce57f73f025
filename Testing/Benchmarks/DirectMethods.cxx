// SPDX-License-Identifier: BSD-3-Clause
#include "DirectMethods.h"

#include "Timing.h"
#include "Variants.h"

#include <cmath>
#include <stdexcept>

namespace exabricks
{
namespace benchmarks
{
namespace
{
void check(const std::string& fault)
{
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
}
}

DirectMethod::DirectMethod(const Scene& scene, const DirectSettings& settings)
  : Subject(scene)
  , Settings(settings)
{
  this->Renderer.selectTraversal(settings.traversal);
  this->Renderer.selectDevice("");
}

SetUp DirectMethod::setUp(double)
{
  SetUp& result = this->Ready;
  if (!std::isnan(result.seconds) || !result.possible)
  {
    return result;
  }
  const glm::ivec3& size = this->Subject.structure().tree.size; // half cells
  const int finestCells = std::max({ size.x, size.y, size.z }) / 2;
  if (finestCells > this->Settings.mostFinestCells)
  {
    result.note = "not drawn: takes too long with " + std::to_string(finestCells) +
      " finest cells along an axis";
    result.possible = false;
    return result;
  }
  const Reconstruction field = this->Settings.reconstruction;
  Costs costs;
  costs.measure(
    [&]
    {
      const Volume volume = this->Subject.volume(field);
      if (this->Settings.makeProgram)
      {
        this->Other = std::make_unique<VariantRenderer>(this->Settings.makeProgram(volume));
        this->Other->setVolume(volume);
      }
      else
      {
        this->Renderer.setVolume(volume);
      }
      this->setTransferFunction(this->Subject.transfer());
    });
  result.seconds = this->Subject.buildTime(field) + costs.wall.front();
  result.hostBytes = static_cast<double>(this->Subject.hostBytes(field));
  result.deviceBytes = static_cast<double>(this->statistics().deviceBytes);
  return result;
}

void DirectMethod::setTransferFunction(const TransferFunction& transfer)
{
  if (this->Other)
  {
    this->Other->setTransferFunction(transfer);
    check(this->Other->prepare());
    return;
  }
  this->Renderer.setTransferFunction(transfer);
  check(this->Renderer.prepare());
}

void DirectMethod::draw(const View& view)
{
  check(this->Other ? this->Other->render(view, this->Pixels)
                    : this->Renderer.render(view, this->Pixels));
  this->Drawn = { view.target.width, view.target.height };
}

const VolumeRenderer::Statistics& DirectMethod::statistics() const
{
  return this->Other ? this->Other->statistics() : this->Renderer.statistics();
}

View DirectMethod::viewOf(const Size& size, double value) const
{
  View view = this->Subject.view(size, this->Settings.reconstruction);
  if (this->Settings.apply)
  {
    this->Settings.apply(value, view);
  }
  else
  {
    view.quality.stepScale = value;
  }
  return view;
}

void DirectMethod::draw(const Size& size, double value) { this->draw(this->viewOf(size, value)); }

reference::Image DirectMethod::picture()
{
  return { this->Drawn[0], this->Drawn[1], { this->Pixels.begin(), this->Pixels.end() } };
}

double DirectMethod::marchSeconds() const { return this->statistics().marchTime; }

double DirectMethod::samples(const Size& size, double value)
{
  const Reconstruction field = this->Settings.reconstruction;
  if (this->Settings.makeProgram || field == Reconstruction::Nearest)
  {
    return NotMeasured;
  }
  if (!this->Counter)
  {
    const Volume volume = this->Subject.volume(field);
    this->Counter = std::make_unique<VariantRenderer>(countingVariant().makeProgram(volume));
    this->Counter->setVolume(volume);
    this->Counter->setTransferFunction(this->Subject.transfer());
  }
  std::vector<glm::vec4> counts;
  View view = this->viewOf(size, value);
  std::size_t rays = 0;
  if (view.quality.errorTolerance > 0.0) // which the counts say nothing of
  {
    this->draw(view);
    view.quality.stepScale = this->statistics().stepScale;
    view.quality.levelsLeftOut = this->statistics().levelsLeftOut;
    rays = this->statistics().rays;
  }
  check(this->Counter->render(view, counts));
  double sum = 0.0;
  std::size_t busy = 0; // pixels that take any sample
  for (const glm::vec4& count : counts)
  {
    sum += count.r;
    busy += count.r > 0.0f ? 1 : 0;
  }
  // Where pixels are predicted, which ones is not known: as if all that are marched were busy ones.
  const double part =
    rays > 0 ? std::min(1.0, static_cast<double>(rays) / std::max<std::size_t>(busy, 1)) : 1.0;
  return part * sum / static_cast<double>(counts.size());
}

DirectSettings toleranceSettings(std::optional<int> levelsLeftOut)
{
  DirectSettings settings;
  settings.apply = [=](double value, View& view)
  {
    view.quality.errorTolerance = value;
    view.quality.levelsLeftOut = levelsLeftOut;
  };
  return settings;
}

namespace
{
std::function<std::unique_ptr<Method>(const Scene&)> maker(const DirectSettings& settings)
{
  return [=](const Scene& scene) { return std::make_unique<DirectMethod>(scene, settings); };
}
}

std::vector<MethodKind> listDirectMethods()
{
  using Field = reference::Reconstruction;
  const auto line = [](const std::string& name, Reconstruction reconstruction, Traversal traversal,
                      std::optional<Field> field)
  {
    MethodKind kind{ name, Role::Ours, StepScale, { 2.0, 1.0, 0.5 }, { 2.0, 1.0, 0.25 }, field,
      maker({ reconstruction, traversal }) };
    if (reconstruction == Reconstruction::Nearest) // takes whole cells, whatever the step
    {
      kind.all = kind.few = { DefaultStepScale };
    }
    if (reconstruction == Reconstruction::Basis && traversal == Traversal::KdTree)
    {
      kind.all = { 4.0, 2.0, 1.2, 1.0, 0.5, 0.25 };
      kind.everywhere = true;
    }
    return kind;
  };
  const MethodKind tolerance{ "basis, by tolerance", Role::Ours, ErrorTolerance,
    { 0.03, 0.02, 0.01, 0.005, 0.002, 0.001 }, { 0.01, 0.005, 0.002 }, Field::Basis,
    maker(toleranceSettings({})), true };
  MethodKind toleranceOfAll = tolerance;
  toleranceOfAll.name = "by tolerance, all levels";
  toleranceOfAll.make = maker(toleranceSettings(0));
  return { line("basis, k-d tree", Reconstruction::Basis, Traversal::KdTree, Field::Basis),
    tolerance, toleranceOfAll,
    line("basis, ray query", Reconstruction::Basis, Traversal::RayQuery, Field::Basis),
    line("nearest, k-d tree", Reconstruction::Nearest, Traversal::KdTree, Field::Nearest),
    line("nearest, ray query", Reconstruction::Nearest, Traversal::RayQuery, Field::Nearest),
    line("completed, k-d tree", Reconstruction::Completed, Traversal::KdTree, std::nullopt),
    line("completed, ray query", Reconstruction::Completed, Traversal::RayQuery, std::nullopt) };
}

std::vector<MethodKind> listVariantMethods()
{
  std::vector<MethodKind> kinds;
  for (const Variant& variant : variants())
  {
    if (&variant == &variants().front()) // ours
    {
      continue;
    }
    DirectSettings settings;
    settings.makeProgram = variant.makeProgram;
    MethodKind kind{ variant.name, Role::Baseline, StepScale, { 2.0, 1.0, 0.5 },
      { DefaultStepScale }, reference::Reconstruction::Basis, {} };
    if (variant.name == "naive walk") // tens of times slower than the others
    {
      settings.mostFinestCells = 512;
      kind.all = { DefaultStepScale };
      kind.few = {};
    }
    else if (variant.name == "finest steps")
    {
      settings.mostFinestCells = 4096;
    }
    kind.make = maker(settings);
    kind.everywhere = variant.name == "cell location";
    kinds.push_back(kind);
  }
  return kinds;
}
}
}
