// SPDX-License-Identifier: BSD-3-Clause
// How near the renderer's pictures come to those of analytic fields, and what they cost: basis and
// completed across levels, for some step scales. `CompareReconstructions [rounds [pixels]]`
#include "Accuracy/PictureAccuracy.h"
#include "Core/Completion.h"
#include "Core/Structure.h"
#include "Timing.h"
#include "Vulkan/VolumeRenderer.h"

#include <cstdio>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <stdexcept>
#include <string>

using namespace exabricks;
using namespace exabricks::accuracy;
using namespace exabricks::benchmarks;

namespace
{
struct Variant
{
  Variant(
    Reconstruction how, const Volume& volume, const TransferFunction& transfer, Traversal traversal)
    : reconstruction(how)
  {
    this->renderer.selectTraversal(traversal);
    this->renderer.setVolume(volume);
    this->renderer.setTransferFunction(transfer);
    this->check(this->renderer.prepare());
  }

  reference::Image draw(View view, double stepScale)
  {
    view.reconstruction = this->reconstruction;
    view.stepScale = stepScale;
    this->check(this->renderer.render(view, this->pixels));
    return { view.width, view.height, { this->pixels.begin(), this->pixels.end() } };
  }

  void measure(View view, double stepScale)
  {
    view.reconstruction = this->reconstruction;
    view.stepScale = stepScale;
    this->costs.measure([&] { this->check(this->renderer.render(view, this->pixels)); });
  }

  static void check(const std::string& fault)
  {
    if (!fault.empty())
    {
      throw std::runtime_error(fault);
    }
  }

  Reconstruction reconstruction;
  VolumeRenderer renderer;
  std::vector<glm::vec4> pixels;
  Costs costs;
};

double load()
{
  double average = -1.0;
  getloadavg(&average, 1);
  return average;
}

double milliseconds(const std::vector<double>& seconds) { return 1e3 * median(seconds); }
TransferFunction normalized(const TransferFunction& transfer, const Range& range)
{
  std::vector<TransferFunction::Point> points = transfer.points();
  for (TransferFunction::Point& point : points)
  {
    point.value = range.normalize(point.value);
  }
  return TransferFunction(points);
}

Grid makeGrid(Hierarchy hierarchy, int coarseCells)
{
  Grid grid{ std::move(hierarchy), {}, coarseCells, 1.0 };
  grid.leaves = findLeafBoxes(grid.hierarchy);
  grid.cellShare = 1.0 / static_cast<double>(coarseCells * grid.hierarchy.cellWidth[0]);
  return grid;
}

struct Drawn
{
  const char* name;
  const TransferFunction transfer;
  reference::Image truth;
};

void compare(const char* name, const Grid& grid, const Field& field, std::vector<Drawn>& pictures,
  const PictureSettings& settings, int rounds)
{
  const Structure structure = buildStructure(grid.hierarchy);
  const std::vector<std::int64_t>& width = structure.hierarchy.cellWidth;
  const reference::ArraySource source =
    reference::fillCells(grid.hierarchy, atCenters(grid, field));
  Scalars scalars;
  Completion completion;
  ValueRanges ranges;
  ValueRanges completedRanges;
  Costs gathering;
  Costs completing;
  for (int i = 0; i < 3; ++i)
  {
    gathering.measure(
      [&] { scalars = gatherScalars(structure.hierarchy, structure.bricks, source); });
    completing.measure(
      [&] { completion = complete(structure.tree, structure.bricks, width, scalars); });
  }
  ranges = findValueRanges(structure.tree, structure.bricks, width, scalars);
  completedRanges = findValueRanges(structure.tree, completion.bricks, width, completion.scalars);
  std::printf("\n%s: %zu leaf cells, %zu bricks; values %.2f MiB, completed %.2f; CPU ms: gather "
              "%.0f, complete %.0f\n\n",
    name, static_cast<std::size_t>(structure.leafCells), structure.bricks.size(),
    static_cast<double>(scalars.values.size()) / 262144.0,
    static_cast<double>(completion.scalars.values.size()) / 262144.0, milliseconds(gathering.cpu),
    milliseconds(completing.cpu));
  std::printf("| transfer | step | dB basis | dB completed | CPU ms basis, k-d tree | completed | "
              "ratio | basis, ray query | completed | ratio | load |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");

  Hierarchy cube;
  const reference::View seen = reference::lookAt(
    cube, { Int3(0), Int3(1) }, { 1.0, 0.7, -0.4 }, 0.0, settings.pixels, settings.pixels);
  View view;
  view.ndcToWorld = seen.ndcToWorld;
  view.ndcToHalfCells =
    glm::scale(glm::dmat4(1.0), glm::dvec3(2.0 / grid.cellShare)) * seen.ndcToWorld;
  view.width = view.height = settings.pixels;
  view.opacityUnitDistance = settings.unitDistance;
  view.terminationOpacity = 1.0;
  for (Drawn& picture : pictures)
  {
    if (picture.truth.pixels.empty())
    {
      picture.truth = renderField(field.value, picture.transfer, settings);
    }
    const TransferFunction transfer = normalized(picture.transfer, scalars.range);
    const Volume plain{ &structure.tree, &structure.bricks, &width, &scalars, &ranges };
    const Volume completed{ &structure.tree, &completion.bricks, &width, &completion.scalars,
      &completedRanges };
    for (const double step : { 1.0, 0.5, 0.25 })
    {
      Variant variants[] = { { Reconstruction::Basis, plain, transfer, Traversal::KdTree },
        { Reconstruction::Completed, completed, transfer, Traversal::KdTree },
        { Reconstruction::Basis, plain, transfer, Traversal::RayQuery },
        { Reconstruction::Completed, completed, transfer, Traversal::RayQuery } };
      for (int round = -1; round < rounds; ++round)
      {
        for (Variant& variant : variants)
        {
          round < 0 ? void(variant.draw(view, step)) : variant.measure(view, step);
        }
      }
      double ms[4];
      for (int i = 0; i < 4; ++i)
      {
        ms[i] = milliseconds(variants[i].costs.cpu);
      }
      std::printf("| %s | %g | %.1f | %.1f | %.1f | %.1f | %.2f | %.1f | %.1f | %.2f | %.1f |\n",
        picture.name, step, reference::psnr(variants[0].draw(view, step), picture.truth),
        reference::psnr(variants[1].draw(view, step), picture.truth), ms[0], ms[1], ms[1] / ms[0],
        ms[2], ms[3], ms[3] / ms[2], load());
      std::fflush(stdout);
    }
  }
}
}

int main(int argc, char** argv)
{
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
  PictureSettings settings;
  settings.pixels = argc > 2 ? std::max(8, std::atoi(argv[2])) : 160;
  settings.step = 1.0 / 1024;
  const auto pictures = [] {
    return std::vector<Drawn>{ { "ramp", rampTransfer(), {} }, { "veils", veilTransfer(), {} } };
  };
  std::printf("%d^2 pixels, %d rounds\n", settings.pixels, rounds);
  {
    std::vector<Drawn> shell = pictures();
    compare("shell, 2 levels, 32 coarse cells, blocks of 4", makeShellGrid({ 2 }, 32),
      shellAndBlobs(), shell, settings, rounds);
    compare("shell, 3 levels, 32 coarse cells, blocks of 4", makeShellGrid({ 2, 2 }, 32),
      shellAndBlobs(), shell, settings, rounds);
    compare("shell, ratio 4, 32 coarse cells, blocks of 4", makeShellGrid({ 4 }, 32),
      shellAndBlobs(), shell, settings, rounds);
    compare("shell, 3 levels, 64 coarse cells, blocks of 16",
      makeGrid(reference::refinedAtShell({ 2, 2 }, 64, 16), 64), shellAndBlobs(), shell, settings,
      rounds);
  }
  {
    std::vector<Drawn> bell = pictures();
    const Field field = gaussian({ 0.4, 0.45, 0.55 }, 0.3);
    compare("Gaussian through the faces of a box, ratio 2, 32 coarse cells", makeBoxGrid(2, 32),
      field, bell, settings, rounds);
    compare("Gaussian through the faces of a box, ratio 4, 16 coarse cells", makeBoxGrid(4, 16),
      field, bell, settings, rounds);
  }
  {
    // about a fine cell wide: no reconstruction is good for it
    std::vector<Drawn> front = pictures();
    const Field steep = movingFront(0.35, 0.02);
    compare("front 0.02 wide through a box, ratio 2, 32 coarse cells", makeBoxGrid(2, 32), steep,
      front, settings, rounds);
    compare(
      "the same, ratio 4, 16 coarse cells", makeBoxGrid(4, 16), steep, front, settings, rounds);
  }
  return 0;
}
