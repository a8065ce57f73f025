// SPDX-License-Identifier: BSD-3-Clause
// A scene as VTK's mappers take it.
#ifndef ExaBricksBenchmarksVTKScene_h
#define ExaBricksBenchmarksVTKScene_h

#include "PeerMappers.h" // PeerData
#include "Scene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkOverlappingAMR.h"
#include "vtkVolumeProperty.h"

namespace exabricks
{
namespace benchmarks
{
struct VTKScene
{
  vtkSmartPointer<vtkOverlappingAMR> amr;
  std::string array;  // of its cells
  int component = -1; // -1: magnitude
  vtkSmartPointer<vtkVolumeProperty> property;
};

/// The scene's surface, black and without light: what is in front of it is seen as it is. Null if
/// it has none.
vtkSmartPointer<vtkActor> makeSurfaceActor(const Surface& surface);

/// From the hierarchy, with covered cells marked as VTK's readers do, and float values.
std::shared_ptr<VTKScene> makeVTKScene(const Scene& scene);

vtkSmartPointer<vtkCamera> makeCamera(const Model& model);
PeerData makePeerData(const Scene& scene);
}
}

#endif
