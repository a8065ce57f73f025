// SPDX-License-Identifier: BSD-3-Clause
// Whatever goes wrong with the device comes back as a message with what to do, and the renderer can
// be used again.
#include "FaultyDriver.h"
#include "SceneRenderer.h"
#include "Vulkan/Buffer.h"

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
  FaultyDriver driver;
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
  if (!this->driver.tellsMemory())
  {
    GTEST_SKIP() << "the driver does not tell how much memory is available";
  }
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  this->driver.availableMemory = 1000;
  subject.renderer.release();
  std::vector<glm::vec4> pixels;
  const std::string fault = subject.renderer.render(subject.toView(view), pixels);
  EXPECT_TRUE(contains(fault, "out of device memory")) << fault;
  EXPECT_TRUE(contains(fault, "1000 bytes")) << fault;
  // It is tried again only when something was set anew, not for every picture.
  this->driver.heal();
  EXPECT_EQ(subject.renderer.render(subject.toView(view), pixels), fault);
  subject.renderer.release();
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}

TEST_F(ReportsFaults, TakesAMappingToNowhereForOutOfMemory)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  for (void* const nowhere : { static_cast<void*>(nullptr), reinterpret_cast<void*>(-1) })
  {
    this->driver.mappedAt = nowhere;
    subject.renderer.release();
    std::vector<glm::vec4> pixels;
    const std::string fault = subject.renderer.render(subject.toView(view), pixels);
    EXPECT_TRUE(contains(fault, "out of device memory")) << fault;
    EXPECT_TRUE(contains(fault, "bytes")) << fault;
    this->driver.heal();
    subject.renderer.release();
    EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
  }
}

TEST_F(ReportsFaults, SaysHowToDrawAPictureThatIsTooLarge)
{
  if (!this->driver.tellsMemory())
  {
    GTEST_SKIP() << "the driver does not tell how much memory is available";
  }
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  const std::vector<float> depth(512 * 512, 1.0f);
  std::vector<glm::vec4> pixels;
  View large = subject.toView(view);
  large.target.width = large.target.height = 512;
  const auto expectAdvice = [&](const std::string& contents, std::uint64_t bytes)
  {
    const std::string fault = subject.renderer.render(large, pixels);
    EXPECT_TRUE(contains(fault, contents + " needs " + std::to_string(bytes) + " bytes")) << fault;
    EXPECT_TRUE(contains(fault, std::to_string(large.target.width) + " x ")) << fault;
    EXPECT_TRUE(contains(fault, "make it smaller, or draw it in tiles")) << fault;
    EXPECT_FALSE(contains(fault, "fewer levels")) << fault;
    // A smaller picture is drawn at once: nothing has to be set anew.
    EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
  };
  this->driver.availableMemory = 1000000;
  expectAdvice("the picture", 512 * 512 * sizeof(glm::vec4));
  this->driver.heal();
  ASSERT_EQ(subject.renderer.render(large, pixels), ""); // this buffer is kept
  this->driver.availableMemory = 1000000;
  large.target.depth = depth.data();
  expectAdvice("the depth buffer", 512 * 512 * sizeof(float));

  // Mesa's CPU driver has no buffers of 2^32 bytes: the real thing.
  this->driver.heal();
  if (vulkan::Device::acquire("")->isCpu())
  {
    large.target.width = large.target.height = 16384;
    large.target.depth = nullptr;
    expectAdvice("the picture", std::uint64_t(1) << 32);
  }
}

TEST_F(ReportsFaults, SaysWhatToDoWhereTheDeviceHasNoMemoryToWorkWith)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  this->driver.submitsWithoutMemory = 1;
  std::vector<glm::vec4> pixels;
  const std::string fault = subject.renderer.render(subject.toView(view), pixels);
  EXPECT_TRUE(contains(fault, "out of device memory on ")) << fault;
  EXPECT_TRUE(contains(fault, "fewer levels")) << fault;
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}

TEST_F(ReportsFaults, ALostDeviceIsRebuiltOnce)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  this->driver.lostSubmits = 1;
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}

TEST_F(ReportsFaults, AnotherRendererOfALostDeviceGoesOn)
{
  SceneRenderer a(reference::twoLevels());
  SceneRenderer b(reference::twoLevels());
  const reference::View view = a.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = b.render(view);
  this->driver.lostSubmits = 1;
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
  view.target.width = view.target.height = 4;
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
  vulkan::Device::acquire("")->limitValueBuffers(40000);
  subject.renderer.setVolume({});
  subject.renderer.setVolume(subject.plain);
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}

TEST_F(ReportsFaults, DrawsTheSameWithMemoryOfItsOwn)
{
  // A driver that says it is a GPU's: constants, depth and picture are copied.
  const auto draw = [](const reference::Scene& scene, double tolerance)
  {
    SceneRenderer subject(scene);
    subject.renderer.selectTraversal(Traversal::KdTree);
    subject.errorTolerance = tolerance;
    reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
    view.depth.assign(96 * 96, 1.0f);
    std::fill_n(view.depth.begin(), 96 * 40, 0.5f);
    return subject.render(view);
  };
  const reference::Scene scene = reference::twoLevels();
  for (const double tolerance : { 0.0, 0.01 })
  {
    this->driver.deviceType.reset();
    const reference::Image shared = draw(scene, tolerance);
    EXPECT_GT(coverage(shared), 0.02);
    this->driver.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
    EXPECT_FALSE(vulkan::Device::acquire("")->sharesMemory());
    EXPECT_EQ(largestDifference(shared, draw(scene, tolerance)), 0.0);
  }
}

TEST_F(ReportsFaults, StagesLargeUploadsInTurns)
{
  // More than two stages hold.
  this->driver.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
  const auto device = vulkan::Device::acquire("");
  std::vector<std::uint32_t> words(12 << 20);
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    words[i] = static_cast<std::uint32_t>(i * 2654435761u);
  }
  const vulkan::Buffer buffer = vulkan::makeBuffer(device, words, "words");
  ASSERT_EQ(buffer.mapped(), nullptr);
  const vulkan::Buffer back(
    device, buffer.bytes(), vulkan::Residence::Readback, "what was uploaded");
  device->submit(
    [&](const vk::raii::CommandBuffer& commands)
    {
      commands.copyBuffer(*buffer.handle(), *back.handle(), vk::BufferCopy(0, 0, buffer.bytes()));
      const vk::MemoryBarrier toHost(
        vk::AccessFlagBits::eTransferWrite, vk::AccessFlagBits::eHostRead);
      commands.pipelineBarrier(
        vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eHost, {}, toHost, {}, {});
    });
  EXPECT_TRUE(
    std::equal(words.begin(), words.end(), static_cast<const std::uint32_t*>(back.mapped())));
}

TEST_F(ReportsFaults, APictureThatLosesTheDeviceTwiceIsNotTriedAgain)
{
  SceneRenderer subject(reference::twoLevels());
  const reference::View view = subject.look({ 1, 0, 0 }, 0.0, 16);
  const reference::Image before = subject.render(view);
  this->driver.lostSubmits = 1000;
  std::vector<glm::vec4> pixels;
  const std::string fault = subject.renderer.render(subject.toView(view), pixels);
  EXPECT_TRUE(contains(fault, "lost twice")) << fault;
  EXPECT_EQ(this->driver.lostSubmits, 998);
  EXPECT_EQ(subject.renderer.render(subject.toView(view), pixels), fault);
  EXPECT_EQ(this->driver.lostSubmits, 998);
  // Another picture is tried, and then this one.
  this->driver.heal();
  EXPECT_EQ(subject.renderer.render(subject.toView(view), pixels), fault);
  EXPECT_EQ(
    subject.renderer.render(subject.toView(subject.look({ 0, 1, 0 }, 0.0, 16)), pixels), "");
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
  // As it is when something was set anew.
  this->driver.lostSubmits = 2;
  EXPECT_NE(subject.renderer.render(subject.toView(view), pixels), "");
  subject.setTransfer(subject.transfer);
  EXPECT_EQ(largestDifference(before, subject.render(view)), 0.0);
}
