// SPDX-License-Identifier: BSD-3-Clause
// The Vulkan layer as the rest of the program sees it: no Vulkan types, nothing is thrown.
//
// Order of calls: setVolume, setTransferFunction, render; each again when its subject changes. What
// is set takes effect with the next prepare() or render(), which return an empty string, or what
// went wrong.
#ifndef ExaBricksVulkanVolumeRenderer_h
#define ExaBricksVulkanVolumeRenderer_h

#include "Core/ActiveRegions.h"
#include "Core/View.h"

#include <memory>
#include <string>

namespace exabricks
{
enum class Traversal
{
  Automatic, // ray query on a GPU that has it, else the k-d tree
  RayQuery,
  KdTree
};

/// Another method of marching over the same buffers, for comparisons (Testing/Benchmarks).
struct MarchProgram
{
  /// Shader with the interface of Shaders/March.comp, for the k-d tree traversal; none: our own.
  std::vector<std::uint32_t> spirv;
  /// False: regions that the transfer function does not show are marched too.
  bool skipsSpace = true;
  /// The method's own data about the volume, at the device address Frame.extra.
  std::vector<std::uint32_t> extra;
};

class VolumeRenderer
{
public:
  VolumeRenderer();
  ~VolumeRenderer();
  VolumeRenderer(const VolumeRenderer&) = delete;
  VolumeRenderer& operator=(const VolumeRenderer&) = delete;

  /// `wanted`: index among the devices, or part of a device's name; empty: EXABRICKS_DEVICE, else
  /// the best. A change frees everything on the device used before.
  void selectDevice(const std::string& wanted);
  void selectTraversal(Traversal traversal);
  /// A program marches by the k-d tree, whatever the traversal wanted; null: our own method.
  void selectProgram(std::shared_ptr<const MarchProgram> program);

  /// Shares the volume; without one nothing is drawn.
  void setVolume(Volume volume);
  /// Costs an upload of colours; and when it shows other values than before, or pictures are drawn
  /// with an error tolerance, a new selection of the active regions.
  void setTransferFunction(const TransferFunction& transfer);

  /// Brings everything on the device up to date.
  std::string prepare();
  /// `picture`: [height][width] of premultiplied red, green, blue, opacity, row 0 at the bottom.
  std::string render(const View& view, std::vector<glm::vec4>& picture);
  /// Frees everything on the device.
  void release();

  struct Statistics
  {
    std::string device;
    Traversal traversal = Traversal::Automatic; // the one used
    std::size_t activeRegions = 0;
    std::size_t activeBoxes = 0; // regions and parts of regions that the traversal is left with
    std::uint64_t deviceBytes = 0;
    double stepScale = 1.0; // of the last picture
    int levelsLeftOut = 0;  // of the finest, in the last picture
    // seconds, of the last time each was done
    double uploadTime = 0.0;  // bricks, regions, values
    double colorTime = 0.0;   // transfer function tables
    double opacityTime = 0.0; // active regions, acceleration structure or pruned tree
    double marchTime = 0.0;
    double pilotTime = 0.0; // choosing levels and steps for an error tolerance
  };
  const Statistics& statistics() const;

  /// One line for each device: index, name, what it lacks.
  static std::vector<std::string> listDevices();

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
