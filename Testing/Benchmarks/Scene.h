// SPDX-License-Identifier: BSD-3-Clause
// What is drawn, by all methods alike, and what it ought to look like. Free of VTK: what VTK's
// mappers need is made when one of them asks for it (VTKScene).
#ifndef ExaBricksBenchmarksScene_h
#define ExaBricksBenchmarksScene_h

#include "Core/Volume.h"
#include "Reference/Oracle.h"
#include "Surface.h"
#include "Vulkan/VolumeRenderer.h"

#include <array>
#include <map>
#include <memory>

namespace exabricks
{
namespace benchmarks
{
struct VTKScene;
class Scene;

using Size = std::array<int, 2>;

/// What a scene is made of. To add one: fill this in, and name it in SceneTable.cxx.
struct Model
{
  std::string name; // in tables
  Hierarchy hierarchy;
  std::shared_ptr<const CellSource> cells;
  /// On values normalised to the range of the cells.
  std::function<TransferFunction(const Range&)> transfer;
  double opacityUnitDistance = 1.0; // world
  reference::Camera camera;

  /// Greatest error of the reference picture, in a channel of any pixel: less takes long where rays
  /// cross many cells.
  double tolerance = 1e-7;
  Surface surface; // empty: there is none
  /// The AMR, where it came from VTK; else it is made from the hierarchy and its cells.
  std::function<std::shared_ptr<VTKScene>(const Scene&)> makeVTK;
  /// The picture of the field that the cells were sampled from; else pictures are compared with
  /// the integral of the basis reconstruction.
  std::function<reference::Image(const Size&)> truth;
};

/// A model, with all that is built from it on the host.
class Scene
{
public:
  explicit Scene(Model from);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const std::string& name() const { return this->Made.name; }
  const Model& model() const { return this->Made; }
  const Structure& structure() const { return *this->Plain.structure; }
  const Values& values() const { return *this->Plain.values; }
  const TransferFunction& transfer() const { return this->Transfer; }

  /// Completed values are made when first asked for.
  Volume volume(Reconstruction reconstruction) const;
  View view(const Size& size, Reconstruction reconstruction) const;
  reference::View referenceView(const Size& size) const;
  /// `error`: estimate of the greatest one.
  reference::Image renderReference(
    const Size& size, reference::Reconstruction reconstruction, double& error) const;
  /// What all pictures of this scene are compared with.
  reference::Image renderTruth(const Size& size, double& error) const;

  const VTKScene& vtk() const;

  // Seconds it took to make them.
  double structureTime = 0.0;
  double gatherTime = 0.0; // values from the source, which for scenes made by code computes them
  double rangesTime = 0.0;
  double buildTime(Reconstruction reconstruction) const;
  std::uint64_t hostBytes(Reconstruction reconstruction) const;

private:
  const Model Made;
  Volume Plain;
  TransferFunction Transfer;
  mutable std::shared_ptr<const Values> Completed;
  mutable double CompletionTime = 0.0;
  mutable std::shared_ptr<const VTKScene> ForVTK;
  mutable std::map<Size, std::vector<float>> Depths; // of the surface
};
}
}

#endif
