// SPDX-License-Identifier: BSD-3-Clause
// Pictures that are not by absorption: of the greatest and least value along each ray, of the mean
// and of the sum, beside brute force in double precision.
#include "SceneRenderer.h"
#include "Traversals.h"

#include "Reference/Projection.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
constexpr int Pixels = 48;

// Of every value something shows, and no two look alike.
TransferFunction slopes()
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.2 } }, { 0.4, { 0.2, 0.9, 0.3, 0.5 } },
    { 0.7, { 0.9, 0.8, 0.1, 0.3 } }, { 1.0, { 1.0, 0.1, 0.0, 0.9 } } });
}

std::vector<reference::Scene> scenes()
{
  return { reference::twoLevels(), reference::ratio4(), reference::anisotropic(),
    reference::holes() };
}

struct Projected
{
  const char* name;
  Blending blending;
  glm::dvec2 averageRange;
  double basis;   // dB over drawn pixels
  double nearest; // the same
};

// Takes pixels out that one picture alone shows, and returns how many: rays that pass the corner of
// a cell that counts show all or nothing.
int dropLonely(reference::Image& a, reference::Image& b)
{
  int lonely = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
  {
    if ((a.pixels[i].a > 0.0) != (b.pixels[i].a > 0.0))
    {
      a.pixels[i] = b.pixels[i] = glm::dvec4(0.0);
      ++lonely;
    }
  }
  return lonely;
}

void PrintTo(const Projected& mode, std::ostream* out) { *out << mode.name; }

class ProjectsValues : public testing::TestWithParam<Projected>
{
protected:
  void SetUp(SceneRenderer& subject, Reconstruction reconstruction) const
  {
    subject.blending = this->GetParam().blending;
    subject.averageRanges[0] = this->GetParam().averageRange;
    subject.opacityUnitDistance = 24.0;
    subject.reconstruction = reconstruction;
    subject.setTransfer(slopes());
  }

  reference::Image Project(const SceneRenderer& subject, const reference::View& view) const
  {
    const reference::Oracle oracle(
      subject.scene.hierarchy, findLeafBoxes(subject.scene.hierarchy), subject.scene.cells);
    reference::ProjectionSettings settings;
    settings.blending = subject.blending;
    const bool nearest = subject.reconstruction == Reconstruction::Nearest;
    // Corners of cells, that rays pass through on a short length, count as much as others.
    settings.step = nearest ? 1.0 / 256 : 1.0 / 32;
    settings.opacityUnitDistance = subject.opacityUnitDistance;
    settings.averageRange = subject.averageRanges[0];
    return reference::project(
      reference::fieldOf(
        oracle, nearest ? reference::Reconstruction::Nearest : reference::Reconstruction::Basis),
      subject.structure.tree.bounds, view, subject.transfer, settings);
  }
};
}

TEST_P(ProjectsValues, AsBruteForceDoes)
{
  for (const reference::Scene& scene : scenes())
  {
    for (const Reconstruction reconstruction : { Reconstruction::Basis, Reconstruction::Nearest })
    {
      SceneRenderer subject(scene);
      this->SetUp(subject, reconstruction);
      const reference::View view = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Pixels);
      const reference::Image projected = this->Project(subject, view);
      for (const Traversal traversal : traversalsOfDevice())
      {
        subject.renderer.selectTraversal(traversal);
        reference::Image truth = projected;
        reference::Image picture = subject.render(view);
        EXPECT_LE(dropLonely(picture, truth), 2);
        const double quality = reference::psnrOfDrawn(picture, truth);
        const bool isNearest = reconstruction == Reconstruction::Nearest;
        std::cout << this->GetParam().name << ", " << scene.name
                  << (isNearest ? ", nearest: " : ", basis: ") << quality << " dB, coverage "
                  << coverage(truth) << "\n";
        EXPECT_GE(quality, isNearest ? this->GetParam().nearest : this->GetParam().basis);
        EXPECT_GT(coverage(truth), 0.05);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ProjectsValues,
  testing::Values(Projected{ "maximum", Blending::Maximum, { 0.0, 1.0 }, 55.0, 55.0 },
    Projected{ "minimum", Blending::Minimum, { 0.0, 1.0 }, 80.0, 80.0 },
    Projected{ "average", Blending::Average, { 0.0, 1.0 }, 80.0, 75.0 },
    Projected{ "average of a range", Blending::Average, { 0.3, 0.6 }, 70.0, 65.0 },
    Projected{ "additive", Blending::Additive, { 0.0, 1.0 }, 85.0, 75.0 }));
