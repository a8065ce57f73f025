// SPDX-License-Identifier: BSD-3-Clause
// Iso-surfaces beside brute force in double precision: exact, and by an error asked for.
#include "SceneRenderer.h"
#include "Traversals.h"

#include "Reference/Surfaces.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
// Of every value something shows through what is before it.
TransferFunction slopes()
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.2 } }, { 0.4, { 0.2, 0.9, 0.3, 0.5 } },
    { 0.7, { 0.9, 0.8, 0.1, 0.3 } }, { 1.0, { 1.0, 0.1, 0.0, 0.9 } } });
}

struct Case
{
  SceneRenderer subject;
  reference::View view;

  Case(const reference::Scene& scene, int pixels)
    : subject(scene)
    , view(subject.look({ -0.6, 0.5, -0.4 }, 30.0, pixels))
  {
    this->subject.setTransfer(slopes());
    this->subject.blending = Blending::Isosurface;
    this->subject.isoValues = { 0.3, 0.5, 0.65 };
  }

  reference::Image truth(double step = 1.0 / 64.0) const
  {
    const reference::Oracle oracle(this->subject.scene.hierarchy,
      findLeafBoxes(this->subject.scene.hierarchy), this->subject.scene.cells);
    return reference::drawSurfaces(reference::fieldOf(oracle), this->subject.structure.tree.bounds,
      this->view, this->subject.transfer, this->subject.isoValues, step);
  }

  reference::Image picture() { return this->subject.render(this->view); }
};
}

TEST(DrawsSurfaces, AsBruteForceDoes)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::ratio4(),
         reference::anisotropic(), reference::mixedRatios(), reference::holes() })
  {
    Case test(scene, 96);
    const reference::Image truth = test.truth();
    EXPECT_GT(coverage(truth), 0.1) << scene.name;
    for (const Traversal traversal : traversalsOfDevice())
    {
      test.subject.renderer.selectTraversal(traversal);
      test.subject.stepScale = 1.0;
      const reference::Image picture = test.picture();
      const double quality = reference::psnrOfDrawn(picture, truth);
      std::cout << scene.name << ": " << quality << " dB\n";
      // Where cells are absent, brute force begins up to a step behind them.
      EXPECT_GE(quality, scene.name == "holes" ? 45.0 : 55.0) << scene.name;
      test.subject.stepScale = 4.0; // whatever the step
      EXPECT_EQ(largestDifference(test.picture(), picture), 0.0) << scene.name;
    }
  }
}

// Noise: rays graze surfaces everywhere, and brute force takes short steps to find the short ways
// behind them.
TEST(DrawsSurfaces, ThatRaysGraze)
{
  reference::Scene scene;
  scene.name = "brick";
  scene.hierarchy.cellWidth = { 1 };
  scene.hierarchy.blocks = { { 0, { Int3(0), Int3(12) } } };
  scene.cells = reference::fillCells(
    scene.hierarchy, [](int level, const Int3& cell) { return reference::noise(level, cell, 7); });
  Case test(scene, 48);
  const double quality = reference::psnrOfDrawn(test.picture(), test.truth(1.0 / 1024.0));
  std::cout << quality << " dB\n";
  EXPECT_GE(quality, 80.0);
}

TEST(DrawsSurfaces, WithTheErrorAskedFor)
{
  for (const reference::Scene& scene : { reference::twoLevels(), reference::mixedRatios() })
  {
    // Of enough pixels for some to be predicted.
    Case test(scene, 256);
    const reference::Image truth = test.picture();
    for (const double tolerance : { 0.02, 0.005 })
    {
      test.subject.errorTolerance = tolerance;
      const double error = errorOfDrawn(test.picture(), truth);
      std::cout << scene.name << ", tolerance " << tolerance << ": " << error << ", step "
                << test.subject.renderer.statistics().stepScale << "\n";
      EXPECT_LE(error, 2.0 * tolerance) << scene.name;
    }
  }
}
