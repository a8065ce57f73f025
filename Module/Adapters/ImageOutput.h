// SPDX-License-Identifier: BSD-3-Clause
// What is seen of a volume as images of its own, of colours and of depths, instead of in the
// window.
#ifndef ExaBricksAdaptersImageOutput_h
#define ExaBricksAdaptersImageOutput_h

#include "Adapters/ColorWindow.h"
#include "Vulkan/VolumeRenderer.h"

#include <vector>

class vtkImageData;

namespace exabricks
{
class ImageOutput
{
public:
  /// Draws what `view` sees, without regard to a depth. `size`: of the bounds, half cells. Returns
  /// what went wrong; the images stay as they were then.
  std::string draw(
    VolumeRenderer& renderer, View view, const glm::dvec3& size, const ColorWindow& colors);

  /// Red, green and blue, premultiplied, and opacity: as bytes, white without opacity beyond the
  /// bounds, or as floats, as they are. Without points before anything was drawn.
  void getColors(int scalarType, vtkImageData* image) const;

  /// Window depths of where anything is first seen, in [0, 1], as float, or of unsigned char or
  /// short up to their greatest number. Where nothing is, 1, or where the bounds end.
  void getDepths(int scalarType, bool clampToBackFace, vtkImageData* image) const;

private:
  int Width = 0;
  int Height = 0;
  std::vector<glm::vec4> Colors;
  std::vector<float> FirstDepths; // of each pixel; above 1: nothing is seen
  std::vector<float> BackDepths;  // where its ray leaves the bounds; above 1: it does not pass them
};
}

#endif
