// SPDX-License-Identifier: BSD-3-Clause
// What is drawn, by all methods alike: an AMR data set with its camera, colours and opacity, as the
// program exabricks-render sets it up; and what it ought to look like.
#ifndef ExaBricksBenchmarksSubject_h
#define ExaBricksBenchmarksSubject_h

#include "Adapters/DataContents.h"
#include "Options.h" // of Examples/Render
#include "Reference/Oracle.h"
#include "Vulkan/VolumeRenderer.h"

#include "vtkOverlappingAMR.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

class vtkRenderer;
class vtkVolumeProperty;

namespace render
{
class Picture;
}

namespace exabricks
{
namespace benchmarks
{
struct Request
{
  render::Options draw; // size: of the pictures that are timed
  std::array<int, 2> accuracySize{ { 256, 256 } };
  std::string scene; // JSON file, or empty
  std::string json;
  std::string pictures; // prefix of the pictures' names
  std::vector<double> stepScales{ 1.0, 0.25 };
  int rounds = 7;
  bool peers = false;
};

class Subject
{
public:
  explicit Subject(const Request& request);
  ~Subject();

  vtkOverlappingAMR* amr() const { return this->AMR; }
  /// Name of the cell array, and its component; -1: magnitude.
  const std::string& array() const { return this->Array; }
  int component() const { return this->Component; }

  const vtkExaBricksData::Contents& contents() const { return *this->Contents; }
  double hostBytes() const;
  vtkRenderer* renderer() const;
  vtkVolumeProperty* property() const { return this->Volume->GetProperty(); }
  /// The window with vtkExaBricksVolumeMapper in it.
  vtkRenderWindow* window() const { return this->Window; }

  /// Of the camera as it stands.
  View makeView(const std::array<int, 2>& size, double stepScale) const;
  /// `error`: estimate of its greatest one.
  reference::Image renderOracle(const std::array<int, 2>& size, double& error) const;

  /// Seconds of building all anew from the AMR, several times: structure, scalars.
  void measureBuilds(
    int builds, std::vector<double>& structure, std::vector<double>& scalars) const;

private:
  void ApplyScene(const std::string& path);

  const render::Options Asked;
  vtkSmartPointer<vtkOverlappingAMR> AMR;
  std::string Array;
  int Component = -1;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::unique_ptr<render::Picture> Picture;
  vtkVolume* Volume = nullptr;
  std::shared_ptr<const vtkExaBricksData::Contents> Contents;
};
}
}

#endif
