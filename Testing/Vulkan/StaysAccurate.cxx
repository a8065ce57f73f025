// SPDX-License-Identifier: BSD-3-Clause
// float32 on the device stays right on lattices of 2^20 cells and for cameras 10^5 domain sizes
// away.
#include "SceneRenderer.h"
#include "Traversals.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

TEST(StaysAccurate, AtLogicalCoordinatesOfTwoToTheTwenty)
{
  const reference::Scene scene = reference::twoLevels();
  constexpr std::int64_t distance = std::int64_t(1) << 20;
  SceneRenderer near(scene);
  SceneRenderer far(reference::repeatFarAway(scene, distance));
  for (const glm::dvec3 direction : { glm::dvec3(-0.6, 0.5, -0.4), glm::dvec3(1.0, -1.0, 0.1) })
  {
    const reference::View view = near.look(direction, 30.0);
    reference::View shifted = view;
    const glm::dmat4 shift =
      glm::translate(glm::dmat4(1.0), glm::dvec3(static_cast<double>(distance)));
    shifted.ndcToLogical = shift * view.ndcToLogical;
    shifted.ndcToWorld = shift * view.ndcToWorld;
    const reference::Image truth = near.renderOracle(view);
    for (const Traversal traversal : traversalsOfDevice())
    {
      near.renderer.selectTraversal(traversal);
      far.renderer.selectTraversal(traversal);
      const double here = reference::psnr(near.render(view), truth);
      const double there = reference::psnr(far.render(shifted), truth);
      std::cout << here << " dB near, " << there << " dB at 2^20\n";
      EXPECT_GE(there, 50.0);
      EXPECT_GE(there, here - 3.0);
    }
  }
}

TEST(StaysAccurate, ThroughTwoToTheTwentyCellsOfEmptySpace)
{
  // Parallel rays along the diagonal pass the first copy's side, and hit the second 2^20 cells on.
  const reference::Scene scene = reference::twoLevels();
  SceneRenderer pair(reference::repeatFarAway(scene, std::int64_t(1) << 20));
  SceneRenderer one(scene);
  const reference::View view = one.look({ 1.0, 1.0, 1.0 }, 0.0);
  // The same rays, begun at the first copy and ended behind the second: a camera at both.
  reference::View both = view;
  const glm::dmat4 longer = glm::scale(
    glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, 1e7)), glm::dvec3(1.0, 1.0, 1e7 + 1.0));
  both.ndcToLogical = view.ndcToLogical * longer;
  both.ndcToWorld = view.ndcToWorld * longer;
  const reference::Image first = one.render(view);
  const reference::Image picture = pair.render(both);
  reference::Image expected = first;
  for (glm::dvec4& pixel : expected.pixels)
  {
    pixel += (1.0 - pixel.a) * pixel; // two copies, one behind the other
  }
  const double quality = reference::psnr(picture, expected);
  std::cout << quality << " dB\n";
  EXPECT_GE(quality, 50.0);
}

TEST(StaysAccurate, WithTheCameraAHundredThousandDomainsAway)
{
  SceneRenderer subject(reference::twoLevels());
  // A view angle that shows the domain from there.
  const double angle = 30.0 * 1e-5;
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, angle);
  const double quality = reference::psnr(subject.render(view), subject.renderOracle(view));
  std::cout << quality << " dB from far away\n";
  EXPECT_GE(quality, 50.0);
}
