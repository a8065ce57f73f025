// SPDX-License-Identifier: BSD-3-Clause
// Ways to draw a subject, timed in turn and compared with the oracle's picture.
#ifndef ExaBricksBenchmarksMethods_h
#define ExaBricksBenchmarksMethods_h

#include "Subject.h"
#include "Timing.h"

#include <functional>

namespace exabricks
{
namespace benchmarks
{
struct Method
{
  std::string name;
  double setUp = 0.0; // seconds until the first picture can be drawn, without the reading
  std::function<void()> draw;
  std::function<reference::Image()> picture; // of the size for accuracy
  bool hasOpacity = false;                   // the picture has; windows are opaque
  std::function<double()> march;             // seconds of the last; may be empty

  Costs costs;
  std::vector<double> marches;
  double decibelRGBA = std::numeric_limits<double>::quiet_NaN();
  double decibelDrawn = std::numeric_limits<double>::quiet_NaN(); // of drawn pixels, RGBA
  double decibelRGB = std::numeric_limits<double>::quiet_NaN();
};

/// Draws each once, then so many times in turn, A B C A B C, so that a load on the machine falls on
/// all of them.
void measureInTurn(std::vector<Method>& methods, int rounds);

/// Fills in the decibels. Pictures are written if `prefix` is not empty.
void judge(std::vector<Method>& methods, const reference::Image& oracle, const std::string& prefix);

/// The renderer that vtkExaBricksVolumeMapper uses, without a window: float pictures.
struct DirectRenderer
{
  DirectRenderer(const Subject& subject, Traversal traversal);

  void setTransferFunction(const TransferFunction& transfer);
  void render(const View& view);
  reference::Image image(const View& view);

  VolumeRenderer renderer;
  std::vector<glm::vec4> pixels;
  double setUp = 0.0; // seconds: upload, colours, opacity
};

/// That renderer at a step scale. `direct` has to live as long as the method.
Method makeDirectMethod(const Subject& subject, const Request& request, DirectRenderer& direct,
  const std::string& name, double stepScale, double buildTime);

/// vtkExaBricksVolumeMapper in the subject's window, as it comes.
Method makeMapperMethod(const Subject& subject, const Request& request, double buildTime);

/// The ways VTK offers by itself, each in a window of its own:
///   vtkMultiBlockVolumeMapper on all blocks, and on blocks whose covered cells are blanked;
///   vtkResampleToImage to 256^3 (the finest cell's value at each of them, no interpolation), drawn
///   by vtkGPUVolumeRayCastMapper with steps of the finest cell's least width.
std::vector<Method> makePeers(const Subject& subject, const Request& request);
}
}

#endif
