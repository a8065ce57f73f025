// SPDX-License-Identifier: BSD-3-Clause
// Draws a scene of Testing/Reference with the Vulkan layer, for comparison with the oracle.
#ifndef ExaBricksTestingSceneRenderer_h
#define ExaBricksTestingSceneRenderer_h

#include "Core/Completion.h"
#include "Layout.h"
#include "Reference/Oracle.h"
#include "Reference/Scenes.h"
#include "Vulkan/VolumeRenderer.h"

#include <functional>
#include <glm/ext/matrix_transform.hpp>
#include <stdexcept>

namespace exabricks
{
using reference::layeredTransfer;

/// A function of the gradient's magnitude as VolumeRenderer::setGradientOpacity() takes it.
inline std::vector<float> tabulateGradients(const std::function<double(double)>& opacity)
{
  std::vector<float> table;
  for (std::uint32_t i = 0; i < layout::GRADIENT_OPACITIES; ++i)
  {
    table.push_back(static_cast<float>(
      opacity(layout::GREATEST_GRADIENT * i / (layout::GRADIENT_OPACITIES - 1.0))));
  }
  return table;
}

struct SceneRenderer
{
  explicit SceneRenderer(const reference::Scene& s)
    : scene(s)
    , plain(MakeVolume(s))
    , structure(*plain.structure)
  {
    this->renderer.setVolume(this->plain);
    this->setTransfer(layeredTransfer());
  }

  /// Draws what is completed across levels from here on.
  void complete()
  {
    this->completed = exabricks::complete(this->structure, *this->plain.values);
    this->renderer.setVolume({ this->plain.structure, this->completed });
    this->Check(this->renderer.prepare());
    this->reconstruction = Reconstruction::Completed;
  }

  void setTransfer(const TransferFunction& function)
  {
    this->transfer = function;
    this->renderer.setTransferFunction(function);
    this->Check(this->renderer.prepare());
  }

  reference::View look(const glm::dvec3& direction, double viewAngle, int size = 96) const
  {
    return reference::lookAt(
      this->scene.hierarchy, this->structure.tree.bounds, direction, viewAngle, size, size);
  }

  /// A slanted view of what lies some cells inside of the bounds: at them slopes go on, which is
  /// not of the field itself.
  reference::View lookInside(int size) const
  {
    const Box& bounds = this->structure.tree.bounds;
    const glm::dvec3 middle = 0.5 * (glm::dvec3(bounds.lo) + glm::dvec3(bounds.hi));
    const glm::dvec3 half = 0.5 * glm::dvec3(bounds.size()) - 4.0;
    reference::View view;
    view.width = view.height = size;
    view.ndcToLogical = glm::translate(glm::dmat4(1.0), middle);
    view.ndcToLogical = glm::scale(view.ndcToLogical, half);
    view.ndcToLogical[0].x = 0.7 * half.x;
    view.ndcToLogical[2].x = 0.3 * half.x;
    view.ndcToLogical[1].y = 0.8 * half.y;
    view.ndcToLogical[2].y = -0.2 * half.y;
    view.ndcToWorld = reference::logicalToWorld(this->scene.hierarchy) * view.ndcToLogical;
    return view;
  }

  /// Window depth, in [0, 1], of the middle of the data.
  double middleDepth(const reference::View& view) const
  {
    const Box& bounds = this->structure.tree.bounds;
    const glm::dvec4 middle =
      glm::inverse(view.ndcToLogical) * glm::dvec4(glm::dvec3(bounds.lo + bounds.hi) * 0.5, 1.0);
    return 0.5 + 0.5 * middle.z / middle.w;
  }

  View toView(const reference::View& from) const
  {
    View view;
    glm::dmat4 toHalfCells = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0));
    toHalfCells = glm::translate(toHalfCells, -glm::dvec3(this->structure.tree.bounds.lo));
    view.camera.ndcToHalfCells = toHalfCells * from.ndcToLogical;
    view.camera.halfCellsToData =
      glm::dmat3(from.ndcToWorld * glm::inverse(view.camera.ndcToHalfCells));
    view.target.width = from.width;
    view.target.height = from.height;
    view.target.depth = from.depth.empty() ? nullptr : from.depth.data();
    view.opacityUnitDistance = this->opacityUnitDistance;
    view.quality.stepScale = this->stepScale;
    view.quality.errorTolerance = this->errorTolerance;
    view.quality.levelsLeftOut = this->levelsLeftOut;
    view.quality.jittered = this->jittered;
    view.quality.terminationOpacity = this->terminationOpacity;
    view.quality.reconstruction = this->reconstruction;
    view.blending = this->blending;
    view.isoValues = this->isoValues;
    view.averageRanges = this->averageRanges;
    view.lighting = this->lighting;
    for (const glm::dvec4& plane : from.cut.planes)
    {
      view.cutaway.clippingPlanes.push_back(plane * glm::inverse(toHalfCells));
    }
    if (from.cut.cropped)
    {
      const glm::dvec3 corner(this->structure.tree.bounds.lo);
      view.cutaway.cropping = Cropping{ 2.0 * (from.cut.lower - corner),
        2.0 * (from.cut.upper - corner), from.cut.shownRegions };
    }
    return view;
  }

  reference::Image render(const reference::View& from)
  {
    std::vector<glm::vec4> pixels;
    this->Check(this->renderer.render(this->toView(from), pixels));
    pixels.resize(static_cast<std::size_t>(from.width) * from.height);
    return { from.width, from.height, { pixels.begin(), pixels.end() } };
  }

  reference::Image renderOracle(const reference::View& from) const
  {
    const reference::Oracle oracle(
      this->scene.hierarchy, findLeafBoxes(this->scene.hierarchy), this->scene.cells);
    reference::Oracle::Settings settings;
    settings.opacityUnitDistance = this->opacityUnitDistance;
    settings.reconstruction = this->reconstruction == Reconstruction::Nearest
      ? reference::Reconstruction::Nearest
      : reference::Reconstruction::Basis;
    return oracle.render(from, this->transfer, settings);
  }

  const reference::Scene scene;
  const Volume plain;
  const Structure& structure;              // of both
  std::shared_ptr<const Values> completed; // null: not asked for
  VolumeRenderer renderer;
  TransferFunction transfer;
  double opacityUnitDistance = 1.0;
  double stepScale = 0.25;
  double errorTolerance = 0.0;
  std::optional<int> levelsLeftOut;
  bool jittered = false;
  double terminationOpacity = 1.0; // never
  Reconstruction reconstruction = Reconstruction::Basis;
  Blending blending = Blending::Composite;
  std::vector<double> isoValues; // normalised
  AverageRanges averageRanges = wholeAverageRanges();
  std::optional<Lighting> lighting;

private:
  static Volume MakeVolume(const reference::Scene& scene)
  {
    auto structure = std::make_shared<const Structure>(buildStructure(scene.hierarchy));
    return { structure, makeValues(*structure, scene.cells) };
  }

  static void Check(const std::string& fault)
  {
    if (!fault.empty())
    {
      throw std::runtime_error(fault);
    }
  }
};

/// Root mean square over the channels of the pixels that are drawn in either picture.
inline double errorOfDrawn(const reference::Image& a, const reference::Image& b)
{
  return std::pow(10.0, -reference::psnrOfDrawn(a, b) / 20.0);
}

inline double largestDifference(const reference::Image& a, const reference::Image& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
  {
    const glm::dvec4 d = glm::abs(a.pixels[i] - b.pixels[i]);
    largest = std::max({ largest, d.r, d.g, d.b, d.a });
  }
  return largest;
}

/// Mean opacity: a picture to compare has to show something.
inline double coverage(const reference::Image& image)
{
  double sum = 0.0;
  for (const glm::dvec4& pixel : image.pixels)
  {
    sum += pixel.a;
  }
  return sum / static_cast<double>(image.pixels.size());
}
}

#endif
