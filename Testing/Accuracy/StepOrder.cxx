// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/StepOrder.h"

#include "Accuracy/ObservedOrder.h"
#include "Vulkan/SceneRenderer.h"

#include <cmath>

namespace exabricks
{
namespace accuracy
{
namespace
{
TransferFunction rampTo(double opacity)
{
  return TransferFunction({ { 0.0, { 0.1, 0.2, 0.9, 0.0 } }, { 1.0, { 0.9, 0.4, 0.1, opacity } } });
}

TransferFunction jumpAt(double value)
{
  return TransferFunction({ { value, { 0.2, 0.6, 1.0, 0.0 } }, { value, { 0.2, 0.6, 1.0, 0.3 } },
    { 1.0, { 1.0, 0.6, 0.2, 0.3 } } });
}

TransferFunction spikeAt(double value, double width)
{
  const glm::dvec4 color(1.0, 0.8, 0.3, 0.0);
  const glm::dvec4 opaque(1.0, 0.8, 0.3, 0.9);
  return TransferFunction(
    { { value - 0.5 * width, color }, { value, opaque }, { value + 0.5 * width, color } });
}
}

StepScene smoothScene()
{
  StepScene scene;
  scene.name = "smooth field, linear transfer function";
  scene.scene.hierarchy.cellWidth = { 1 };
  scene.scene.hierarchy.blocks = { { 0, { Int3(0), Int3(2) } } };
  scene.scene.cells = reference::fillCells(scene.scene.hierarchy,
    [](int, const Int3& c)
    {
      const double values[8] = { 0.0, 0.9, 0.2, 0.5, 0.8, 0.1, 1.0, 0.3 };
      return values[c.x + 2 * c.y + 4 * c.z];
    });
  scene.transfer = rampTo(0.9);
  // From x = 0.55 to x = 1.45, slanting, between the cells' centres at 0.5 and 1.5.
  scene.view.ndcToLogical = glm::dmat4(0.0);
  scene.view.ndcToLogical[0] = { 0.0, 0.2, 0.0, 0.0 };
  scene.view.ndcToLogical[1] = { 0.0, 0.0, 0.2, 0.0 };
  scene.view.ndcToLogical[2] = { 0.45, 0.25, -0.2, 0.0 };
  scene.view.ndcToLogical[3] = { 1.0, 1.0, 1.0, 1.0 };
  scene.view.ndcToWorld = scene.view.ndcToLogical;
  scene.view.width = scene.view.height = 32;
  scene.stepScales = { 0.4, 0.2, 0.1, 0.05 };
  return scene;
}

std::vector<StepScene> kinkedScenes()
{
  const std::pair<std::string, TransferFunction> functions[] = {
    { "linear transfer function", rampTo(0.3) }, { "layers", layeredTransfer() },
    { "a jump", jumpAt(0.4) }, { "a spike of 1/1000 of the values", spikeAt(0.45, 1e-3) }
  };
  std::vector<StepScene> scenes;
  for (const auto& function : functions)
  {
    StepScene scene;
    scene.name = function.first;
    scene.scene = reference::twoLevels();
    scene.transfer = function.second;
    scene.view = reference::lookAt(scene.scene.hierarchy,
      reference::boundsOf(scene.scene.hierarchy), { -0.6, 0.5, -0.4 }, 30.0, 96, 96);
    // Regions of this small scene are up to about four cells long, and cut longer intervals.
    scene.stepScales = { 2.0, 1.0, 0.5, 0.25, 0.125 };
    // A spike is thin: let it show.
    scene.opacityUnitDistance = function.first.find("spike") != std::string::npos ? 0.01 : 1.0;
    scenes.push_back(scene);
  }
  return scenes;
}

std::vector<StepError> measureStepErrors(const StepScene& scene)
{
  SceneRenderer subject(scene.scene);
  subject.renderer.selectTraversal(Traversal::KdTree);
  subject.opacityUnitDistance = scene.opacityUnitDistance;
  subject.setTransfer(scene.transfer);
  const reference::Image truth = subject.renderOracle(scene.view);
  std::vector<StepError> rows;
  for (const double stepScale : scene.stepScales)
  {
    subject.stepScale = stepScale;
    const reference::Image image = subject.render(scene.view);
    double opacity = 0.0;
    double color = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
    {
      const glm::dvec4 off = image.pixels[i] - truth.pixels[i];
      opacity += off.a * off.a;
      color += (off.r * off.r + off.g * off.g + off.b * off.b) / 3.0;
    }
    const double pixels = static_cast<double>(image.pixels.size());
    rows.push_back({ stepScale, std::sqrt(opacity / pixels), std::sqrt(color / pixels) });
  }
  return rows;
}

double observedOrder(const std::vector<StepError>& rows, double StepError::*error)
{
  std::vector<std::pair<double, double>> errors;
  for (const StepError& row : rows)
  {
    errors.emplace_back(row.stepScale, row.*error);
  }
  return observedOrder(errors);
}
}
}
