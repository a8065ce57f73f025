// SPDX-License-Identifier: BSD-3-Clause
// A change costs what it must: a camera nothing, another array or time step an upload of values,
// other boxes all of it. And a picture can be given up on its way.
#include "SceneRenderer.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

using namespace exabricks;

namespace
{
// The scene at another time: its values upside down, with some absent that were not.
std::shared_ptr<const Values> nextTimeStep(const SceneRenderer& subject)
{
  const reference::Scene& scene = subject.scene;
  return makeValues(subject.structure,
    reference::fillCells(scene.hierarchy,
      [](int level, const Int3& cell)
      {
        return cell.x % 7 == 3 && cell.y % 5 == 2 ? std::numeric_limits<double>::quiet_NaN()
                                                  : 1.0 - reference::noise(level, cell, 3);
      }));
}

// The picture of a renderer that has drawn nothing before.
reference::Image drawAnew(
  const SceneRenderer& subject, std::shared_ptr<const Values> values, const reference::View& view)
{
  SceneRenderer other(subject.scene);
  other.levelsLeftOut = subject.levelsLeftOut;
  other.errorTolerance = subject.errorTolerance;
  other.renderer.setVolume({ other.plain.structure, std::move(values) });
  return other.render(view);
}
}

TEST(ChangesCost, NothingForTheCamera)
{
  SceneRenderer subject(reference::twoLevels());
  subject.render(subject.look({ 1, 0, 0 }, 0.0));
  const VolumeRenderer::Statistics before = subject.renderer.statistics();
  subject.render(subject.look({ 0, 1, 0 }, 30.0, 64));
  const VolumeRenderer::Statistics& after = subject.renderer.statistics();
  EXPECT_EQ(after.structureUploads, before.structureUploads);
  EXPECT_EQ(after.valueUploads, before.valueUploads);
  EXPECT_EQ(after.pipelineBuilds, before.pipelineBuilds);
}

TEST(ChangesCost, NoPipelineForAnotherRendererOfTheDevice)
{
  SceneRenderer first(reference::twoLevels());
  const reference::View view = first.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image picture = first.render(view);
  SceneRenderer second(reference::twoLevels());
  EXPECT_EQ(largestDifference(second.render(view), picture), 0.0);
  EXPECT_EQ(second.renderer.statistics().pipelineBuilds, 0u);
}

TEST(ChangesCost, ValuesAloneForATimeStep)
{
  SceneRenderer subject(reference::twoLevels());
  const std::shared_ptr<const Values> next = nextTimeStep(subject);
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  // Of the whole volume, and of what is left of it without a level.
  for (const int levels : { 0, 1 })
  {
    SCOPED_TRACE(levels);
    subject.levelsLeftOut = levels;
    subject.renderer.setVolume(subject.plain);
    const reference::Image first = subject.render(view);
    const VolumeRenderer::Statistics before = subject.renderer.statistics();
    subject.renderer.setVolume({ subject.plain.structure, next });
    const reference::Image second = subject.render(view);
    const VolumeRenderer::Statistics after = subject.renderer.statistics();
    EXPECT_EQ(after.structureUploads, before.structureUploads);
    EXPECT_EQ(after.valueUploads, before.valueUploads + 1u + levels);
    EXPECT_EQ(after.pipelineBuilds, before.pipelineBuilds);
    EXPECT_EQ(after.levelsLeftOut, levels);
    EXPECT_GT(largestDifference(first, second), 0.01);
    EXPECT_EQ(largestDifference(second, drawAnew(subject, next, view)), 0.0);
  }
}

TEST(ChangesCost, ValuesAloneAlsoWhereAnErrorIsAskedFor)
{
  SceneRenderer subject(reference::twoLevels());
  subject.errorTolerance = 0.01;
  const std::shared_ptr<const Values> next = nextTimeStep(subject);
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.render(view);
  subject.renderer.setVolume({ subject.plain.structure, next });
  EXPECT_EQ(largestDifference(subject.render(view), drawAnew(subject, next, view)), 0.0);
}

// What a picture while something moves has to leave time for.
TEST(ChangesCost, WhatIsSaidBeforeForALevelThatIsMadeAhead)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.levelsLeftOut = 0;
  subject.render(view);
  EXPECT_EQ(subject.renderer.secondsToUpdate(0), 0.0);
  EXPECT_EQ(subject.renderer.secondsToUpdate(1), 0.0); // nobody has made it
  while (subject.renderer.makeCoarserAhead(1) < 1)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const double whole = subject.renderer.statistics().uploadTime;
  EXPECT_GT(subject.renderer.secondsToUpdate(1), 0.0);
  EXPECT_LT(subject.renderer.secondsToUpdate(1), 2.0 * whole + 0.1);
  subject.levelsLeftOut = 1;
  subject.render(view);
  EXPECT_EQ(subject.renderer.secondsToUpdate(1), 0.0);
}

TEST(ChangesCost, NoStructureForCompletedLevels)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image before = subject.render(view);
  const std::size_t uploads = subject.renderer.statistics().structureUploads;
  subject.complete();
  subject.render(view);
  subject.renderer.setVolume(subject.plain);
  subject.reconstruction = Reconstruction::Basis;
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
  EXPECT_EQ(subject.renderer.statistics().structureUploads, uploads);
}

TEST(ChangesCost, AllForOtherBoxes)
{
  SceneRenderer subject(reference::twoLevels());
  const SceneRenderer other(reference::mixedRatios());
  const reference::View view = other.look({ -0.6, 0.5, -0.4 }, 30.0);
  subject.render(subject.look({ -0.6, 0.5, -0.4 }, 30.0));
  subject.renderer.setVolume(other.plain);
  std::vector<glm::vec4> pixels;
  ASSERT_EQ(subject.renderer.render(other.toView(view), pixels), "");
  EXPECT_EQ(subject.renderer.statistics().structureUploads, 2u);
}

TEST(ChangesCost, LittleWhereAPictureIsGivenUp)
{
  SceneRenderer subject(reference::twoLevels());
  subject.stepScale = 1.0;
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, 256);
  const reference::Image whole = subject.render(view);
  std::vector<glm::vec4> pixels;
  std::vector<double> heard;
  const auto listen = [&](double done)
  {
    heard.push_back(done);
    return true;
  };
  ASSERT_EQ(subject.renderer.render(subject.toView(view), pixels, listen), "");
  EXPECT_EQ(pixels.size(), whole.pixels.size());
  ASSERT_GT(heard.size(), 0u);
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
  EXPECT_EQ(heard.back(), 1.0);
  int calls = 0;
  const auto giveUp = [&](double) { return ++calls < 1; };
  ASSERT_EQ(subject.renderer.render(subject.toView(view), pixels, giveUp), "");
  EXPECT_TRUE(pixels.empty());
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(largestDifference(whole, subject.render(view)), 0.0);
}
