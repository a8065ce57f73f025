// SPDX-License-Identifier: BSD-3-Clause
// Draws with another method of marching than the renderer's, over the same buffers and rays, by the
// k-d tree.
#ifndef ExaBricksBenchmarksVariantRenderer_h
#define ExaBricksBenchmarksVariantRenderer_h

#include "Vulkan/MarchPipelines.h"
#include "Vulkan/VolumeRenderer.h"

namespace exabricks
{
namespace benchmarks
{
/// A method of marching.
struct MarchProgram
{
  vulkan::MarchShader shader; // for the k-d tree traversal; none: our own
  /// False: regions that the transfer function does not show are marched too.
  bool skipsSpace = true;
  /// The method's own data about the volume, at the device address Frame.activeBoxes, for which the
  /// k-d tree traversal has no other use.
  std::vector<std::uint32_t> data;
};

/// As VolumeRenderer. With an error tolerance, steps are weighted as there, but the view's own step
/// scale and levels are taken.
class VariantRenderer
{
public:
  explicit VariantRenderer(std::shared_ptr<const MarchProgram> program);
  ~VariantRenderer();

  void setVolume(const Volume& volume);
  void setTransferFunction(const TransferFunction& transfer);
  std::string prepare();
  std::string render(const View& view, std::vector<glm::vec4>& picture);
  const VolumeRenderer::Statistics& statistics() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}
}

#endif
