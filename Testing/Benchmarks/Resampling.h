// SPDX-License-Identifier: BSD-3-Clause
// A scene as one grid, for mappers that draw nothing else.
#ifndef ExaBricksBenchmarksResampling_h
#define ExaBricksBenchmarksResampling_h

#include "VTKScene.h"

class vtkImageData;

namespace exabricks
{
namespace benchmarks
{
struct ResampledGrid
{
  vtkSmartPointer<vtkImageData> image; // values at points in the middle of `cells`^3 equal boxes
  double seconds = 0.0;                // that vtkResampleToImage took
  double bytes = 0.0;
  bool estimated = false; // the seconds: by the number of points, from a smaller grid
};

/// vtkResampleToImage, which finds the finest cell at each point. Made once for each scene and
/// size. Where it would take longer than LongestSetUp, the same values are filled in block by block
/// instead, and the seconds are estimated.
const ResampledGrid& resampled(const Scene& scene, int cells);
/// Frees the grids of a scene.
void forgetResampled(const Scene& scene);
}
}

#endif
