// SPDX-License-Identifier: BSD-3-Clause
// The Vulkan layer as the rest of the program sees it: no Vulkan types, nothing is thrown.
//
// Order of calls: setVolume, setTransferFunction, render; each again when its subject changes. What
// is set takes effect with the next prepare() or render(), which return an empty string, or what
// went wrong.
#ifndef ExaBricksVulkanVolumeRenderer_h
#define ExaBricksVulkanVolumeRenderer_h

#include "Core/ActiveRegions.h"
#include "Core/Medium.h"
#include "Core/View.h"
#include "Core/Volume.h"
#include "Vulkan/Traversal.h"

#include <functional>
#include <memory>
#include <string>

namespace exabricks
{
class VolumeRenderer
{
public:
  VolumeRenderer();
  ~VolumeRenderer();
  VolumeRenderer(const VolumeRenderer&) = delete;
  VolumeRenderer& operator=(const VolumeRenderer&) = delete;

  /// `requested`: index among the devices, or part of a device's name; empty: EXABRICKS_DEVICE,
  /// else the best. A change frees everything on the device used before.
  void selectDevice(const std::string& requested);
  void selectTraversal(Traversal traversal);
  /// Makes ready the device alone.
  std::string findDevice();

  /// Shares the volume; without one nothing is drawn. Another array or time step on the same
  /// structure costs an upload of its values, and a new selection of the active regions.
  void setVolume(const Volume& volume);
  /// Costs an upload of colours; and when it shows other values than before, or pictures are drawn
  /// with an error tolerance, a new selection of the active regions. Other opacities cast other
  /// shadows.
  void setTransferFunction(const TransferFunction& transfer);

  /// The same for a volume of several components, for which it takes the place of
  /// setTransferFunction(). Its functions have to be as many as its mixing takes; there are no
  /// iso-surfaces of independent components, and of red, green and blue.
  void setMedium(const Medium& medium);

  /// By what the extinction of Blending::Composite, and the opacity of surfaces and slices, is
  /// multiplied, for GRADIENT_OPACITIES gradients from 0 to GREATEST_GRADIENT (Layout.h), of each
  /// function of opacity that a medium has; empty: by nothing.
  void setGradientOpacity(const std::vector<float>& table);

  /// Brings everything on the device up to date.
  std::string prepare();

  /// Widths of the finest cells without so many levels, [levels left out], in half cells; of a
  /// volume of which a part is drawn those of all levels alone.
  std::vector<double> finestCells() const;
  /// Starts to make the volume without up to so many levels, on a thread of its own, and tells how
  /// many may be left out of what was made so far.
  int makeCoarserAhead(int levelsLeftOut);
  /// About how many seconds more than others the next picture without so many levels takes, as they
  /// are not on the device yet.
  double secondsToUpdate(int levelsLeftOut) const;

  /// Called between the pieces of a picture, about each 30 ms, with the part of it that is done, in
  /// [0, 1]; false: give it up.
  using Progress = std::function<bool(double done)>;
  /// `picture`: [height][width] of premultiplied red, green, blue, opacity, row 0 at the bottom;
  /// empty, if `progress` gave it up.
  std::string render(
    const View& view, std::vector<glm::vec4>& picture, const Progress& progress = {});
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
    std::size_t rays = 0;   // of its pixels, those that were marched and not predicted
    // seconds, of the last time each was done
    double uploadTime = 0.0;  // bricks, regions, values
    double colorTime = 0.0;   // transfer function tables
    double opacityTime = 0.0; // active regions, acceleration structure or pruned tree
    double marchTime = 0.0;
    double samplingTime = 0.0; // choosing levels and steps for an error tolerance
    double shadowTime = 0.0;   // how much of each light comes to each cell
    // how often, since the renderer was made
    std::size_t structureUploads = 0; // of a volume, whole or without some levels
    std::size_t valueUploads = 0;
    std::size_t pipelineBuilds = 0;
    std::size_t shadowSearches = 0; // of the cells' shares of light
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
