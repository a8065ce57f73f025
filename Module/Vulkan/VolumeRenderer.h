// SPDX-License-Identifier: BSD-3-Clause
// The Vulkan layer as the rest of the program sees it: no Vulkan types, nothing is thrown.
//
// Order of calls: setVolume, setTransferFunction, render; each again when its subject changes. What
// is set takes effect with the next prepare() or render(), which return an empty string, or what
// went wrong.
#ifndef ExaBricksVulkanVolumeRenderer_h
#define ExaBricksVulkanVolumeRenderer_h

#include "Core/ActiveRegions.h"

#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <string>

namespace exabricks
{
enum class Traversal
{
  Automatic, // ray query on a GPU that has it, else the k-d tree
  RayQuery,
  KdTree
};

enum class Reconstruction
{
  Basis,
  Nearest,
  Completed // with scalars that have a layer around each brick (Completion)
};

struct View
{
  glm::dmat4 ndcToHalfCells{ 1.0 }; // from normalised device coordinates, z in [-1, 1]
  glm::dmat4 ndcToData{ 1.0 };      // to the data's own coordinates
  int width = 0;                    // pixels
  int height = 0;
  /// Where rays end, and where they begin, [height][width], row 0 at the bottom, window depth in
  /// [0, 1]; null: at the far plane, and at the near plane. Where the end is not behind the
  /// beginning, nothing is drawn.
  const float* depth = nullptr;
  const float* nearDepth = nullptr;
  Reconstruction reconstruction = Reconstruction::Basis;
  double stepScale = 1.0; // step in cells of the region's finest brick
  /// Root mean square error of the drawn pixels' channels, in (0, 1), that steps are chosen for,
  /// early termination with them, and how many of the finest levels are left out; 0: stepScale and
  /// terminationOpacity alone count, and all levels are drawn.
  double errorTolerance = 0.0;
  /// So many of the finest levels are left out, and with an errorTolerance that steps are chosen
  /// for at most so many; none: as many as it allows.
  std::optional<int> levelsLeftOut;
  /// The whole picture of which this view is a part: a tile, the picture of one eye, or what lies
  /// between two depths. With an errorTolerance, levels and steps are chosen for the whole, without
  /// regard to depth, so that all its parts have the same. None: the view is whole.
  struct Whole
  {
    glm::dmat4 ndcToHalfCells{ 1.0 };
    glm::dmat4 ndcToData{ 1.0 };
    int width = 0; // pixels
    int height = 0;
  };
  std::optional<Whole> whole;
  double opacityUnitDistance = 1.0; // length in the data's coordinates
  double terminationOpacity = 0.999;
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

  void setVolume(const Volume& volume);
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
