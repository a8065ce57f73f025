// SPDX-License-Identifier: BSD-3-Clause
// All devices draw the same picture, whatever their driver makes of the shaders.
#include "SceneRenderer.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

TEST(DriversAgree, OnTheSamePicture)
{
  std::vector<std::string> usable; // indices
  const std::vector<std::string> lines = VolumeRenderer::listDevices();
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    if (lines[i].find("cannot be used") == std::string::npos)
    {
      std::cout << lines[i] << "\n";
      usable.push_back(std::to_string(i));
    }
  }
  if (usable.size() < 2)
  {
    GTEST_SKIP() << "there is one Vulkan device alone: Utilities/test adds a second one";
  }
  for (const reference::Scene& scene : { reference::twoLevels(), reference::mixedRatios(),
         reference::anisotropic(), reference::holes() })
  {
    for (const Reconstruction reconstruction :
      { Reconstruction::Basis, Reconstruction::Nearest, Reconstruction::Completed })
    {
      std::vector<reference::Image> pictures;
      for (const std::string& device : usable)
      {
        SceneRenderer subject(scene);
        subject.renderer.selectDevice(device);
        subject.renderer.selectTraversal(Traversal::KdTree);
        if (reconstruction == Reconstruction::Completed)
        {
          subject.complete();
        }
        subject.reconstruction = reconstruction;
        subject.stepScale = 1.0;
        reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0);
        view.depth.assign(96 * 96, 1.0f);
        std::fill_n(view.depth.begin(), 96 * 30, 0.5f);
        pictures.push_back(subject.render(view));
      }
      EXPECT_GT(coverage(pictures.front()), 0.02) << scene.name;
      for (std::size_t i = 1; i < pictures.size(); ++i)
      {
        const double quality = reference::psnrOfDrawn(pictures[i], pictures.front());
        std::cout << scene.name << ", reconstruction " << static_cast<int>(reconstruction) << ": "
                  << quality << " dB over drawn pixels\n";
        EXPECT_GE(quality, 60.0) << scene.name;
      }
    }
  }
}
