// SPDX-License-Identifier: BSD-3-Clause
// The renderer of vtkExaBricksVolumeMapper, without a window, by itself or with another march.
#ifndef ExaBricksBenchmarksDirectMethods_h
#define ExaBricksBenchmarksDirectMethods_h

#include "Method.h"
#include "VariantRenderer.h"

namespace exabricks
{
namespace benchmarks
{
struct DirectSettings
{
  Reconstruction reconstruction = Reconstruction::Basis;
  Traversal traversal = Traversal::KdTree;
  /// Another march (Variants.h); none: our own.
  std::function<std::shared_ptr<const MarchProgram>(const Volume&)> makeProgram = {};
  /// Scenes with more finest cells along an axis are not drawn: that would take too long.
  int mostFinestCells = std::numeric_limits<int>::max();
  /// What the value of the parameter is in the view; none: the step scale.
  std::function<void(double value, View&)> apply = {};
};

/// Draws by the k-d tree with the error tolerance that the parameter is; `levelsLeftOut` as in
/// View.
DirectSettings toleranceSettings(std::optional<int> levelsLeftOut);

class DirectMethod : public Method
{
public:
  DirectMethod(const Scene& scene, const DirectSettings& settings);

  SetUp setUp(double value) override;
  void draw(const Size& size, double value) override;
  reference::Image picture() override;
  bool hasOpacity() const override { return true; }
  double marchSeconds() const override;
  /// Counted by another march over the same, by the k-d tree; of our own basis and completed.
  double samples(const Size& size, double value) override;

  /// Uploads, and prepares the renderer.
  void setTransferFunction(const TransferFunction& transfer);
  void draw(const View& view);
  const VolumeRenderer::Statistics& statistics() const;

private:
  View viewOf(const Size& size, double value) const;

  const Scene& Subject;
  const DirectSettings Settings;
  VolumeRenderer Renderer;
  std::unique_ptr<VariantRenderer> Other; // with another march; null: our own
  std::unique_ptr<VariantRenderer> Counter;
  SetUp Ready; // the same for all values
  Size Drawn{};
  std::vector<glm::vec4> Pixels;
};
}
}

#endif
