// SPDX-License-Identifier: BSD-3-Clause
#include "MarchCounts.h"

#include "VariantRenderer.h"
#include "Variants.h"

#include <cstdio>
#include <stdexcept>

namespace exabricks
{
namespace benchmarks
{
namespace
{
std::vector<glm::vec4> draw(const Scene& scene, const Variant& variant, const View& view)
{
  const Volume volume = scene.volume(Reconstruction::Basis);
  VariantRenderer renderer(variant.makeProgram(volume));
  renderer.setVolume(volume);
  renderer.setTransferFunction(scene.transfer());
  std::vector<glm::vec4> picture;
  const std::string fault = renderer.render(view, picture);
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
  return picture;
}

glm::dvec4 sumOf(const std::vector<glm::vec4>& pixels)
{
  glm::dvec4 sum(0.0);
  for (const glm::vec4& pixel : pixels)
  {
    sum += glm::dvec4(pixel);
  }
  return sum;
}
}

const char* const MarchCountsHeader =
  "scene,width,height,step_scale,rays,samples,halves_that_show_nothing,intervals,regions,"
  "tree_steps,lanes_on_in_rounds,lanes_on_in_tree_steps";

void printMarchCounts(const Scene& scene, const Size& size, double stepScale)
{
  View view = scene.view(size, Reconstruction::Basis);
  view.quality.stepScale = stepScale;
  const std::vector<glm::vec4> counts = draw(scene, countingVariant(), view);
  const glm::dvec4 all = sumOf(counts);
  const glm::dvec4 lanes = sumOf(draw(scene, laneCountingVariant(), view));
  double rays = 0.0;
  for (const glm::vec4& count : counts)
  {
    rays += count.r > 0.0f ? 1.0 : 0.0;
  }
  std::printf("\"%s\",%d,%d,%g,%.0f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f\n", scene.name().c_str(),
    size[0], size[1], stepScale, rays, all.r / rays, lanes.r / rays, all.g / rays, all.b / rays,
    all.a / rays, lanes.b / lanes.g, all.a / lanes.a);
  std::fflush(stdout);
}
}
}
