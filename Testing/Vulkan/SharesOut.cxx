// SPDX-License-Identifier: BSD-3-Clause
// What several processes draw of a volume, each a part with the cells around it, is together what
// one draws: as numbers, which no picture rounds.
#include "SceneRenderer.h"
#include "Traversals.h"

#include "Core/Parts.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace exabricks;

namespace
{
constexpr int Pixels = 64;

TransferFunction slopes()
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.0 } }, { 0.4, { 0.2, 0.9, 0.3, 0.1 } },
    { 0.7, { 0.9, 0.8, 0.1, 0.3 } }, { 1.0, { 1.0, 0.1, 0.0, 0.7 } } });
}

// The cells of a hierarchy that another one has of it, block by block.
class CellsInReach : public CellSource
{
public:
  CellsInReach(const CellSource& all, std::vector<int> blocks, Range range)
    : All(all)
    , Blocks(std::move(blocks))
    , Whole(range)
  {
  }
  void read(int block, const Box& cells, double* values) const override
  {
    this->All.read(this->Blocks[static_cast<std::size_t>(block)], cells, values);
  }
  std::optional<Range> wholeRange() const override { return this->Whole; }

private:
  const CellSource& All;
  const std::vector<int> Blocks; // of all, of each one
  const Range Whole;
};

struct Request
{
  const char* name;
  Reconstruction reconstruction = Reconstruction::Basis;
  Blending blending = Blending::Composite;
  bool shaded = false;
  double stepScale = 1.0;
  double leastDecibel = 140.0; // over drawn pixels
};

void PrintTo(const Request& request, std::ostream* out) { *out << request.name; }

class SharesOut : public testing::TestWithParam<Request>
{
protected:
  // Draws one part as a process would that has the cells in its reach.
  static std::vector<glm::vec4> DrawPart(const SceneRenderer& subject, const View& view,
    const Box& part, const LeafBoxes& leaves, Traversal traversal)
  {
    const bool completes = view.quality.reconstruction == Reconstruction::Completed;
    Hierarchy hierarchy = subject.scene.hierarchy;
    const std::vector<std::int64_t>& width = hierarchy.cellWidth;
    auto whole = std::make_shared<WholeHierarchy>();
    whole->blocks = hierarchy.blocks;
    whole->reach = findReach(leaves, width, part, completes);
    hierarchy.blocks.clear();
    std::vector<int> numbers;
    for (std::size_t b = 0; b < whole->blocks.size(); ++b)
    {
      const Block& block = whole->blocks[b];
      const auto level = static_cast<std::size_t>(block.level);
      const Box near = intersection(
        subject.scene.hierarchy.logicalBox(block), cellsInReach(part, whole->reach[level]));
      if (!near.empty())
      {
        hierarchy.blocks.push_back({ block.level, outwardToCells(near, width[level]) });
        numbers.push_back(static_cast<int>(b));
      }
    }
    hierarchy.shown = part;
    hierarchy.whole = whole;
    const CellsInReach cells(subject.scene.cells, numbers, subject.plain.values->range);
    auto structure = std::make_shared<const Structure>(buildStructure(hierarchy));
    std::shared_ptr<const Values> values = makeValues(*structure, cells);
    values = completes ? exabricks::complete(*structure, *values) : values;
    VolumeRenderer renderer;
    renderer.selectTraversal(traversal);
    renderer.setVolume({ structure, values });
    renderer.setTransferFunction(subject.transfer);
    std::vector<glm::vec4> picture;
    EXPECT_EQ(renderer.render(view, picture), "");
    return picture;
  }
};
}

TEST_P(SharesOut, AsOneDraws)
{
  const Request& request = this->GetParam();
  for (const reference::Scene& scene : { reference::twoLevels(), reference::ratio4(),
         reference::anisotropic(), reference::mixedRatios(), reference::holes() })
  {
    SceneRenderer subject(scene);
    subject.setTransfer(slopes());
    if (request.reconstruction == Reconstruction::Completed)
    {
      subject.complete();
    }
    subject.reconstruction = request.reconstruction;
    subject.blending = request.blending;
    subject.opacityUnitDistance = 4.0;
    subject.stepScale = request.stepScale;
    if (request.shaded)
    {
      subject.lighting = Lighting();
      subject.lighting->lights.emplace_back();
      subject.lighting->lights.back().direction = glm::normalize(glm::dvec3(-0.6, 0.5, -0.4));
    }
    const reference::View from = subject.look({ -0.6, 0.5, -0.4 }, 30.0, Pixels);
    View view = subject.toView(from);
    view.isoValues = { 0.3, 0.6 };
    const LeafBoxes leaves = findLeafBoxes(scene.hierarchy);
    const Parts parts = cutIntoParts(
      leaves, buildBricks(leaves, scene.hierarchy.cellWidth), scene.hierarchy.cellWidth, 5);
    // From where all rays come.
    const glm::dvec4 through = from.ndcToLogical * glm::dvec4(0.0, 0.0, 1.0, 0.0);
    const glm::dvec3 eye = 2.0 * glm::dvec3(through) / through.w;
    for (const Traversal traversal : traversalsOfDevice())
    {
      subject.renderer.selectTraversal(traversal);
      std::vector<glm::vec4> alone;
      ASSERT_EQ(subject.renderer.render(view, alone), "");
      std::vector<glm::dvec4> blended(alone.size(), glm::dvec4(0.0));
      for (const int number : parts.frontToBack({ eye, 1.0 }))
      {
        const std::vector<glm::vec4> picture =
          DrawPart(subject, view, parts.boxes[static_cast<std::size_t>(number)], leaves, traversal);
        ASSERT_EQ(picture.size(), alone.size());
        for (std::size_t i = 0; i < picture.size(); ++i)
        {
          blended[i] += (1.0 - blended[i].a) * glm::dvec4(picture[i]);
        }
      }
      const reference::Image found{ Pixels, Pixels, blended };
      const reference::Image expected{ Pixels, Pixels, { alone.begin(), alone.end() } };
      const double quality = reference::psnrOfDrawn(found, expected);
      std::cout << request.name << ", " << scene.name << ": " << quality << " dB, coverage "
                << coverage(expected) << ", largest difference "
                << largestDifference(found, expected) << "\n";
      EXPECT_GE(quality, request.leastDecibel) << scene.name;
      EXPECT_GT(coverage(expected), 0.05) << scene.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, SharesOut,
  // Surfaces and cells are where they are. Regions that a part cuts may be cut elsewhere by what of
  // them shows nothing; gradients jump between cells; long steps end with the part.
  testing::Values(Request{ "basis", Reconstruction::Basis, Blending::Composite, false, 1.0, 78.0 },
    Request{ "nearest", Reconstruction::Nearest },
    Request{ "completed", Reconstruction::Completed, Blending::Composite, false, 1.0, 75.0 },
    Request{ "shaded", Reconstruction::Basis, Blending::Composite, true, 1.0, 60.0 },
    Request{ "surfaces", Reconstruction::Basis, Blending::Isosurface },
    Request{ "surfaces of cells", Reconstruction::Nearest, Blending::Isosurface },
    Request{ "long steps", Reconstruction::Basis, Blending::Composite, false, 3.0, 45.0 }));
