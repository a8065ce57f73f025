// SPDX-License-Identifier: BSD-3-Clause
// Keeps the device, and what was compiled for it, from one test to the next.
#include "Vulkan/Device.h"

#include <gtest/gtest.h>

namespace
{
class KeepDevice : public testing::Environment
{
public:
  void SetUp() override { this->Device = exabricks::vulkan::Device::acquire(""); }
  void TearDown() override { this->Device.reset(); }

private:
  std::shared_ptr<exabricks::vulkan::Device> Device;
};

const testing::Environment* const environment = testing::AddGlobalTestEnvironment(new KeepDevice);
}
