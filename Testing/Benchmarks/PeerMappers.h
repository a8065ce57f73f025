// SPDX-License-Identifier: BSD-3-Clause
// The ways VTK offers by itself to draw an AMR data set as a volume.
#ifndef ExaBricksBenchmarksPeerMappers_h
#define ExaBricksBenchmarksPeerMappers_h

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>
#include <string>

class vtkOverlappingAMR;
class vtkVolumeMapper;

namespace exabricks
{
namespace benchmarks
{
struct PeerData
{
  vtkOverlappingAMR* amr;
  std::string array; // of its cells
  int component;     // -1: magnitude
  glm::dvec3 lo;     // corners of the data's bounds
  glm::dvec3 hi;
  double sampleDistance; // least width of the finest cell in the world
};

/// vtkMultiBlockVolumeMapper on all blocks; or on blocks whose covered cells are blanked, as their
/// ghost arrays say.
vtkSmartPointer<vtkVolumeMapper> makeMultiBlockMapper(const PeerData& data, bool blanked);

/// vtkResampleToImage to so many cells along each axis (the finest cell's value at each of them, no
/// interpolation), drawn by vtkGPUVolumeRayCastMapper.
vtkSmartPointer<vtkVolumeMapper> makeResampledMapper(const PeerData& data, int cells);

/// vtkAMRVolumeMapper as it comes: resamples to 128^3. Null where this VTK was built without it.
vtkSmartPointer<vtkVolumeMapper> makeAMRMapper(const PeerData& data);
}
}

#endif
