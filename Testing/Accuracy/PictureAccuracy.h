// SPDX-License-Identifier: BSD-3-Clause
// How near pictures of reconstructed fields are to the picture of the analytic field itself, all by
// the same fine quadrature along the same rays, so that only the reconstruction makes a difference.
#ifndef ExaBricksAccuracyPictureAccuracy_h
#define ExaBricksAccuracyPictureAccuracy_h

#include "Accuracy/ReconstructionOrder.h"

namespace exabricks
{
namespace accuracy
{
struct PictureSettings
{
  int pixels = 48;           // along each side; parallel projection, all of the cube is seen
  double step = 1.0 / 512;   // in shares of the cube
  double unitDistance = 0.1; // of the opacities, in shares of the cube
};

/// The picture of a field whose `sample` is told the position in the unit cube.
reference::Image renderField(const std::function<double(const glm::dvec3&)>& sample,
  const TransferFunction& transfer, const PictureSettings& settings);

/// A slow ramp of colour and opacity.
TransferFunction rampTransfer();
/// Two thin veils around 0.35 and 0.7, as isosurfaces are shown.
TransferFunction veilTransfer();

struct PictureRow
{
  Method method;
  double finestWidth; // in shares of the cube
  double psnr;        // dB against the analytic field's picture
};
std::vector<PictureRow> measurePictures(const Field& field, const std::vector<Grid>& grids,
  const TransferFunction& transfer, const PictureSettings& settings);
}
}

#endif
