// SPDX-License-Identifier: BSD-3-Clause
// Whatever goes wrong with the device comes back as a message with what to do, and the renderer can
// be used again.
#include "SceneRenderer.h"

#include "Vulkan/Device.h"
#include "Vulkan/Faults.h"
#include <gtest/gtest.h>

using namespace exabricks;

namespace
{
bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

std::string select(VolumeRenderer& renderer, const std::string& device)
{
  renderer.selectDevice(device);
  return renderer.prepare();
}

class ReportsFaults : public testing::Test
{
protected:
  void TearDown() override { vulkan::faults() = {}; }
};
}

TEST_F(ReportsFaults, NamesTheDevicesWhenTheWantedOneIsNotThere)
{
  VolumeRenderer renderer;
  const std::string fault = select(renderer, "no such device");
  EXPECT_TRUE(contains(fault, "'no such device'")) << fault;
  EXPECT_TRUE(contains(fault, "[0] ")) << fault;
  EXPECT_TRUE(contains(fault, "EXABRICKS_DEVICE")) << fault;
  EXPECT_EQ(select(renderer, ""), "");
  EXPECT_NE(select(renderer, "999"), "");
}

TEST_F(ReportsFaults, FindsADeviceByIndexByNameAndByEnvironment)
{
  ASSERT_FALSE(VolumeRenderer::listDevices().empty());
  VolumeRenderer byIndex;
  EXPECT_EQ(select(byIndex, "0"), "");
  VolumeRenderer byName;
  EXPECT_EQ(select(byName, byIndex.statistics().device.substr(0, 6)), "");
  EXPECT_EQ(byName.statistics().device, byIndex.statistics().device);

  setenv("EXABRICKS_DEVICE", "nothing like this", 1);
  VolumeRenderer byEnvironment;
  EXPECT_TRUE(contains(select(byEnvironment, ""), "nothing like this"));
  EXPECT_EQ(select(byEnvironment, "0"), ""); // the property comes first
  unsetenv("EXABRICKS_DEVICE");
}

TEST_F(ReportsFaults, SaysHowManyBytesAreNeededAndAvailable)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  vulkan::faults().availableMemory = 1000;
  subject.renderer.release();
  std::vector<glm::vec4> pixels;
  const std::string fault = subject.renderer.render(subject.toView(view), pixels);
  EXPECT_TRUE(contains(fault, "out of device memory")) << fault;
  EXPECT_TRUE(contains(fault, "1000 bytes")) << fault;
  // It is tried again only when something was set anew, not for every picture.
  vulkan::faults() = {};
  EXPECT_EQ(subject.renderer.render(subject.toView(view), pixels), fault);
  subject.renderer.release();
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}

TEST_F(ReportsFaults, ALostDeviceIsRebuiltOnceAndThenGivenUp)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  vulkan::faults().lostSubmits = 1;
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);

  vulkan::faults().lostSubmits = 2;
  std::vector<glm::vec4> pixels;
  const std::string fault = subject.renderer.render(subject.toView(view), pixels);
  EXPECT_TRUE(contains(fault, "lost twice")) << fault;
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}

TEST_F(ReportsFaults, AnotherRendererOfALostDeviceGoesOn)
{
  SceneRenderer a(reference::twoLevels());
  SceneRenderer b(reference::twoLevels());
  const reference::View view = a.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = b.render(view);
  vulkan::faults().lostSubmits = 1;
  a.render(view);
  EXPECT_EQ(largestDifference(before, b.render(view)), 0.0);
}

TEST_F(ReportsFaults, OneDeviceIsSharedAndGoneWithTheLastUser)
{
  std::weak_ptr<vulkan::Device> watched;
  {
    const auto first = vulkan::Device::acquire("");
    const auto second = vulkan::Device::acquire("0");
    EXPECT_EQ(first, second);
    watched = first;
  }
  EXPECT_TRUE(watched.expired());
}

TEST_F(ReportsFaults, NothingIsDrawnWithoutAVolume)
{
  VolumeRenderer renderer;
  View view;
  view.width = view.height = 4;
  std::vector<glm::vec4> pixels;
  EXPECT_EQ(renderer.render(view, pixels), "");
  EXPECT_EQ(pixels, std::vector<glm::vec4>(16, glm::vec4(0.0f)));
}

TEST_F(ReportsFaults, ManyValueBuffersMakeOneVolume)
{
  // As on devices that allow only small allocations, and for data past their limit.
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
  const reference::Image before = subject.render(view);
  vulkan::faults().largestValueBuffer = 40000;
  subject.renderer.release();
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}
