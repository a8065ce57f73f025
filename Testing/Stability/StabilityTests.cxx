// SPDX-License-Identifier: BSD-3-Clause
// Every case keeps its bound, with both reconstructions and by all traversals of the device.
#include "Measure.h"

#include "Vulkan/Traversals.h"

#include <gtest/gtest.h>

#include <iomanip>
#include <memory>

using namespace exabricks;
using namespace exabricks::stability;

namespace exabricks
{
namespace stability
{
// GoogleTest finds it here.
static void PrintTo(const Case& test, std::ostream* out) { *out << test.elsewhere; }
}
}

namespace
{
class Stability : public testing::TestWithParam<Case>
{
protected:
  static void SetUpTestSuite() { renderers = std::make_unique<Renderers>(); }
  static void TearDownTestSuite() { renderers.reset(); }

  static std::unique_ptr<Renderers> renderers;
};

std::unique_ptr<Renderers> Stability::renderers;

std::string describe(Reconstruction reconstruction, Traversal traversal)
{
  return std::string(reconstruction == Reconstruction::Nearest ? "nearest" : "basis") +
    (traversal == Traversal::KdTree ? ", k-d tree" : ", ray query");
}
}

TEST_P(Stability, KeepsItsBound)
{
  const Case& test = this->GetParam();
  const Subject subject(test.make());
  const Structure& structure = *subject.bricked().volume.structure;
  std::cout << test.name << ": " << structure.bricks.size() << " bricks, "
            << structure.tree.regions.size() << " regions\n";
  EXPECT_GE(structure.bricks.size(), subject.setting().leastBricks);
  EXPECT_GE(structure.tree.regions.size(), subject.setting().leastRegions);
  for (const Reconstruction reconstruction : { Reconstruction::Basis, Reconstruction::Nearest })
  {
    const std::vector<reference::Image> truths = subject.truths(reconstruction);
    for (const Traversal traversal : traversalsOfDevice())
    {
      const std::string way = describe(reconstruction, traversal);
      const Errors errors = compare(subject.draw(*renderers, reconstruction, traversal), truths);
      std::cout << test.name << ", " << way << ": " << std::fixed << std::setprecision(1)
                << errors.drawn << " dB where drawn, " << errors.all << " dB, greatest difference "
                << std::scientific << errors.greatest << ", coverage " << std::fixed
                << std::setprecision(3) << errors.coverage << "\n";
      EXPECT_GE(errors.drawn, reconstruction == Reconstruction::Nearest ? test.nearest : test.basis)
        << way << ". The bound's reason: " << test.reason;
      if (test.blank)
      {
        EXPECT_EQ(errors.coverage, 0.0) << way;
      }
      else
      {
        EXPECT_GT(errors.coverage, 0.02) << way << ": the picture has to show something";
      }
    }
  }
}

namespace
{
std::string nameOf(const testing::TestParamInfo<Case>& info) { return info.param.name; }
}

INSTANTIATE_TEST_SUITE_P(Levels, Stability, testing::ValuesIn(levelCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Cells, Stability, testing::ValuesIn(cellCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Geometry, Stability, testing::ValuesIn(geometryCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Rays, Stability, testing::ValuesIn(rayCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Transfer, Stability, testing::ValuesIn(transferCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Values, Stability, testing::ValuesIn(valueCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Sizes, Stability, testing::ValuesIn(sizeCases()), nameOf);
