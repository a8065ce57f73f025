// SPDX-License-Identifier: BSD-3-Clause
// What vtkHardwareSelector asks of a volume: it renders the window once for each kind of number, of
// props, blocks and cells, and takes them from the colours of the pixels.
#ifndef ExaBricksAdaptersSelectionPasses_h
#define ExaBricksAdaptersSelectionPasses_h

#include "Adapters/BlockSearch.h"
#include "Adapters/FirstSeen.h"
#include "Adapters/OpenGLFramebuffer.h"

#include <functional>

class vtkRenderer;

namespace exabricks
{
class SelectionPasses
{
public:
  using Pixels = std::vector<glm::vec4>;
  using MakeView = std::function<View(int width, int height)>;

  /// The colours of the pass that the renderer's selector is at, premultiplied red, green, blue,
  /// opacity, [viewport's height][width]; empty: nothing is selected. Where props are selected, all
  /// pixels count with more than 3/255 of opacity; where cells are, those in which `cellOpacity` is
  /// reached, and the cells are those where it is; of points a volume has none. Returns an empty
  /// string, or what went wrong.
  std::string color(vtkRenderer* ren, vtkOpenGLRenderWindow* window, const Viewport& viewport,
    const MakeView& makeView, VolumeRenderer& renderer, vtkOverlappingAMR* amr,
    const BrickedVolume& bricked, Pixels& colors);

  static constexpr double cellOpacity = 0.05; // as vtkExaBricksPicker's, unless one sets it

private:
  struct SelectedPixel
  {
    std::size_t number; // in the viewport
    CellOfBlock cell;
  };

  // Of the pixels of a view, whose numbers these are at first.
  std::string Select(const View& view, VolumeRenderer& renderer);
  std::string SelectCells(const View& view, VolumeRenderer& renderer, vtkOverlappingAMR* amr,
    const BrickedVolume& bricked);

  std::vector<SelectedPixel> Selected;
};
}

#endif
