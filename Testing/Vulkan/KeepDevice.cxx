// SPDX-License-Identifier: BSD-3-Clause
// Keeps the device, and what was compiled for it, from one test to the next.
#include "Vulkan/Device.h"
#include "Vulkan/MarchPipelines.h"

#include <gtest/gtest.h>

namespace
{
class KeepDevice : public testing::Environment
{
public:
  void SetUp() override
  {
    this->Pipelines =
      exabricks::vulkan::MarchPipelines::ofDevice(exabricks::vulkan::Device::acquire(""));
  }
  void TearDown() override { this->Pipelines.reset(); }

private:
  std::shared_ptr<exabricks::vulkan::MarchPipelines> Pipelines; // which keep their device
};

const testing::Environment* const environment = testing::AddGlobalTestEnvironment(new KeepDevice);
}
