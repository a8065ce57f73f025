// SPDX-License-Identifier: BSD-3-Clause
// The other methods draw the same picture as ours where they claim to, and converge to it, or not,
// as what was taken away from them has it.
#include "CellLocation/BrickTree.h"
#include "MarchKdTreeSpirv.h"
#include "Variants.h"
#include "Vulkan/SceneRenderer.h"

#include <gtest/gtest.h>
#include <iostream>
#include <stdexcept>

using namespace exabricks;
using namespace exabricks::benchmarks;

namespace
{
/// The picture of a program, and what the renderer says of it.
reference::Image draw(const SceneRenderer& subject, std::shared_ptr<const MarchProgram> program,
  const reference::View& view, VolumeRenderer::Statistics* statistics = nullptr)
{
  VariantRenderer renderer(std::move(program));
  renderer.setVolume({ subject.plain.structure,
    subject.reconstruction == Reconstruction::Completed ? subject.completed
                                                        : subject.plain.values });
  renderer.setTransferFunction(subject.transfer);
  std::vector<glm::vec4> pixels;
  const std::string fault = renderer.render(subject.toView(view), pixels);
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
  if (statistics)
  {
    *statistics = renderer.statistics();
  }
  return { view.width, view.height, { pixels.begin(), pixels.end() } };
}

/// The picture of a variant.
reference::Image draw(SceneRenderer& subject, const std::string& name, const reference::View& view)
{
  const auto program = findVariant(name).makeProgram(subject.plain);
  return program ? draw(subject, program, view) : subject.render(view);
}

std::vector<reference::Scene> scenes()
{
  std::vector<reference::Scene> all = reference::allScenes();
  for (std::uint32_t seed = 0; seed < 5; ++seed)
  {
    all.push_back(reference::randomScene(seed));
  }
  return all;
}

/// PSNR in dB of a variant's picture against another's.
double compare(SceneRenderer& subject, const std::string& name, const std::string& truth)
{
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image expected = draw(subject, truth, view);
  EXPECT_GT(coverage(expected), 0.02) << subject.scene.name;
  return reference::psnr(draw(subject, name, view), expected);
}
}

TEST(Variants, CellLocationDrawsTheSame)
{
  for (const reference::Scene& scene : scenes())
  {
    SceneRenderer subject(scene);
    const double quality = compare(subject, "cell location", "ours");
    std::cout << scene.name << ": " << quality << " dB\n";
    EXPECT_GT(quality, 100.0) << scene.name;
  }
}

TEST(Variants, CellLocationNeedsWholeSupports)
{
  // A tree over the bricks without the half cells around them misses bricks: it has to show.
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image whole = draw(subject, "cell location", view);
  auto program =
    std::make_shared<MarchProgram>(*findVariant("cell location").makeProgram(subject.plain));
  const std::vector<layout::BrickTreeNode> cells = buildBrickTree(subject.structure.bricks,
    subject.structure.hierarchy.cellWidth, subject.structure.tree.bounds.lo, BrickExtent::Cells);
  ASSERT_EQ(cells.size() * sizeof(cells[0]), program->data.size() * sizeof(program->data[0]));
  std::copy_n(reinterpret_cast<const std::uint32_t*>(cells.data()), program->data.size(),
    program->data.begin());
  EXPECT_LT(reference::psnr(draw(subject, program, view), whole), 80.0);
}

TEST(Variants, NaiveWalkDrawsTheSameAsFinestSteps)
{
  for (const reference::Scene& scene : scenes())
  {
    SceneRenderer subject(scene);
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
    // Intervals have to begin at the same places: no region is cut.
    auto finest =
      std::make_shared<MarchProgram>(*findVariant("finest steps").makeProgram(subject.plain));
    finest->skipsSpace = false;
    const reference::Image expected = draw(subject, finest, view);
    EXPECT_GT(coverage(expected), 0.02) << scene.name;
    const double quality = reference::psnr(draw(subject, "naive walk", view), expected);
    std::cout << scene.name << ": " << quality << " dB\n";
    EXPECT_GT(quality, 100.0) << scene.name;
  }
  // Which is closer than ours with other steps.
  SceneRenderer subject(reference::twoLevels());
  EXPECT_LT(compare(subject, "naive walk", "ours"), 90.0);
}

TEST(Variants, FinestStepsDrawAboutTheSameAsOurs)
{
  SceneRenderer subject(reference::twoLevels());
  const double quality = compare(subject, "finest steps", "ours");
  EXPECT_GT(quality, 40.0);
  EXPECT_LT(quality, 90.0);
}

TEST(Variants, NoSkippingMarchesMoreRegionsToTheSamePicture)
{
  SceneRenderer subject(reference::mixedRatios());
  subject.reconstruction = Reconstruction::Nearest; // exact, wherever intervals begin
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  VolumeRenderer::Statistics all;
  const reference::Image picture =
    draw(subject, findVariant("no skipping").makeProgram(subject.plain), view, &all);
  const reference::Image ours = subject.render(view);
  EXPECT_GT(coverage(ours), 0.02);
  EXPECT_GT(reference::psnr(picture, ours), 100.0);
  std::size_t withBricks = 0;
  for (const layout::Region& region : subject.structure.tree.regions)
  {
    withBricks += region.brickCount > 0;
  }
  EXPECT_EQ(all.activeRegions, withBricks);
  EXPECT_EQ(all.activeBoxes, withBricks); // each as a whole
  EXPECT_LT(subject.renderer.statistics().activeRegions, withBricks);
}

TEST(Variants, ConvergeAsTheirRulesSay)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image truth = subject.renderOracle(view);
  const auto quality = [&](const std::string& name, double stepScale)
  {
    subject.stepScale = stepScale;
    const double decibel = reference::psnr(draw(subject, name, view), truth);
    std::cout << name << ", step " << stepScale << ": " << decibel << " dB\n";
    return decibel;
  };
  // Each halving of the step gains 12 dB by second order, 6 dB by first.
  const double ours = quality("ours", 0.25);
  const double midpoint = quality("midpoint", 0.25);
  const double leftEnd = quality("left end", 0.25);
  EXPECT_GT(ours, midpoint);
  EXPECT_GT(midpoint, leftEnd);
  EXPECT_GT(quality("midpoint", 0.0625) - midpoint, 18.0);
  const double gain = quality("left end", 0.0625) - leftEnd;
  EXPECT_GT(gain, 9.0);
  EXPECT_LT(gain, 18.0);
  EXPECT_GT(quality("unfitted steps", 0.0625) - quality("unfitted steps", 0.25), 18.0);
  EXPECT_GT(quality("finest steps", 0.0625) - quality("finest steps", 0.25), 18.0);
  // Finer steps make it more opaque.
  EXPECT_LT(quality("no opacity correction", 0.0625), quality("no opacity correction", 1.0));
}

TEST(Variants, CountsAreThoseOfTheMarch)
{
  SceneRenderer subject(reference::uniform()); // one region, the whole tree
  const auto counter = countingVariant().makeProgram(subject.plain);
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  int hits = 0;
  for (const glm::dvec4& count : draw(subject, counter, view).pixels)
  {
    const bool hit = count.g > 0.0;
    hits += hit;
    EXPECT_EQ(count.b, hit ? 1.0 : 0.0);
    EXPECT_EQ(count.a, 0.0);
    // A first point, and two for each interval; one where a single one does for the region.
    EXPECT_TRUE(count.r == (hit ? 2.0 * count.g + 1.0 : 0.0) || (count.g == 1.0 && count.r == 2.0))
      << count.r << " samples, " << count.g << " intervals";
  }
  EXPECT_GT(hits, 1000);
}

TEST(Variants, CountsOfRegionsDoNotDependOnTheStep)
{
  SceneRenderer subject(reference::twoLevels());
  const auto counter = countingVariant().makeProgram(subject.plain);
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  glm::dvec4 sums[2] = { glm::dvec4(0.0), glm::dvec4(0.0) };
  for (int i = 0; i < 2; ++i)
  {
    subject.stepScale = i == 0 ? 0.125 : 0.0625;
    for (const glm::dvec4& count : draw(subject, counter, view).pixels)
    {
      sums[i] += count;
    }
  }
  EXPECT_GT(sums[0].b, 0.0);
  EXPECT_GT(sums[0].a, sums[0].b);
  EXPECT_EQ(sums[0].b, sums[1].b);
  EXPECT_EQ(sums[0].a, sums[1].a);
  EXPECT_NEAR(sums[1].r / sums[0].r, 2.0, 0.3);
}

TEST(Variants, CountsOfCompletedToo)
{
  SceneRenderer subject(reference::twoLevels());
  subject.complete();
  const reference::Image counts = draw(subject, countingVariant().makeProgram(subject.plain),
    subject.look({ -0.6, 0.5, -0.4 }, 30.0, 32));
  for (const glm::dvec4& count : counts.pixels)
  {
    EXPECT_EQ(count.g > 0.0, count.r > 0.0);
    EXPECT_GE(count.g, count.b);
  }
  EXPECT_GT(coverage(counts), 1.0);
}

TEST(Variants, LanesShareWhatASubgroupDoes)
{
  SceneRenderer subject(reference::twoLevels());
  const auto counter = laneCountingVariant().makeProgram(subject.plain);
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  glm::dvec4 sum(0.0);
  for (const glm::dvec4& count : draw(subject, counter, view).pixels)
  {
    EXPECT_LE(count.g, count.b + 1e-3); // no more than one subgroup a round
    sum += count;
  }
  const double lanesOn = sum.b / sum.g;
  std::cout << lanesOn << " lanes on in the loop of intervals\n";
  EXPECT_GT(lanesOn, 2.0);
  EXPECT_LT(lanesOn, 64.0);
  EXPECT_GT(sum.a, 0.0);

  // Halves that show nothing are there where the function leaves some.
  const auto countNothings = [&](const TransferFunction& transfer)
  {
    subject.transfer = transfer;
    double count = 0.0;
    for (const glm::dvec4& pixel : draw(subject, counter, view).pixels)
    {
      count += pixel.r;
    }
    return count;
  };
  const glm::dvec4 mist(1.0, 1.0, 1.0, 0.1);
  EXPECT_EQ(countNothings(TransferFunction({ { 0.0, mist } })), 0.0);
  EXPECT_GT(countNothings(TransferFunction({ { 0.5, glm::dvec4(0.0) }, { 0.5, mist } })), 100.0);
}

TEST(Variants, OursIsTheSameWithoutIntegersOf64Bits)
{
  // Compiled for devices that lack them, and drawn by one that may have them.
  auto program = std::make_shared<MarchProgram>();
  program->shader.spirv.assign(std::begin(MarchKdTreeSpirv), std::end(MarchKdTreeSpirv));
  program->shader.int64Spirv = program->shader.spirv;
  SceneRenderer subject(reference::holes());
  subject.renderer.selectTraversal(Traversal::KdTree);
  for (const Reconstruction reconstruction : { Reconstruction::Basis, Reconstruction::Nearest })
  {
    subject.reconstruction = reconstruction;
    const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
    EXPECT_EQ(largestDifference(draw(subject, program, view), subject.render(view)), 0.0);
  }
}

TEST(Variants, AreFoundByName)
{
  for (const Variant& variant : variants())
  {
    EXPECT_EQ(&findVariant(variant.name), &variant);
  }
  EXPECT_THROW(findVariant("none"), std::out_of_range);
}
