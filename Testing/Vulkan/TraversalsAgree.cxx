// SPDX-License-Identifier: BSD-3-Clause
// Ray query and k-d tree are two ways to find the same regions: the pictures are the same.
#include "SceneRenderer.h"
#include "Traversals.h"

#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
class TraversalsAgree : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!deviceHasRayQuery())
    {
      const std::string name = vulkan::Device::acquire("")->name();
      // Where lavapipe seems to lack it, it is us who fail to find it.
      ASSERT_EQ(name.find("llvmpipe"), std::string::npos) << name << " has it from Mesa 24.1 on";
      GTEST_SKIP() << name << " has no ray query to compare with";
    }
  }
};

void expectSamePicture(SceneRenderer& subject, const reference::View& view)
{
  subject.renderer.selectTraversal(Traversal::KdTree);
  const reference::Image byTree = subject.render(view);
  EXPECT_EQ(subject.renderer.statistics().traversal, Traversal::KdTree);
  subject.renderer.selectTraversal(Traversal::RayQuery);
  const reference::Image byQuery = subject.render(view);
  EXPECT_EQ(subject.renderer.statistics().traversal, Traversal::RayQuery);
  EXPECT_LE(largestDifference(byTree, byQuery), 1e-5) << subject.scene.name;
  EXPECT_GT(coverage(byTree), 0.01);
}
}

TEST_F(TraversalsAgree, OnEveryScene)
{
  for (const reference::Scene& scene : reference::allScenes())
  {
    SceneRenderer subject(scene);
    for (const double stepScale : { 0.25, 1.0 })
    {
      subject.stepScale = stepScale;
      expectSamePicture(subject, subject.look({ -0.6, 0.5, -0.4 }, 30.0));
      expectSamePicture(subject, subject.look({ 0, 0, 1 }, 0.0, 64));
    }
  }
}

TEST_F(TraversalsAgree, OnRandomHierarchies)
{
  for (std::uint32_t seed = 1; seed <= 12; ++seed)
  {
    SceneRenderer subject(reference::randomScene(seed));
    expectSamePicture(subject, subject.look({ 0.7, -0.4, 0.5 }, 30.0));
  }
}
