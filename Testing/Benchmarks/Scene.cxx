// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Timing.h"
#include "VTKScene.h"

#include "Core/Completion.h"

#include <glm/ext/matrix_transform.hpp>
#include <stdexcept>

namespace exabricks
{
namespace benchmarks
{
namespace
{
template <typename Work>
double secondsOf(const Work& work)
{
  Costs costs;
  costs.measure(work);
  return costs.wall.front();
}
}

Scene::Scene(Model from)
  : Made(std::move(from))
{
  const std::string fault = findFault(this->Made.hierarchy);
  if (!fault.empty())
  {
    throw std::runtime_error("scene '" + this->Made.name + "': " + fault);
  }
  this->structureTime = secondsOf([&]
    { this->Plain.structure = std::make_shared<Structure>(buildStructure(this->Made.hierarchy)); });
  auto values = std::make_shared<Values>();
  this->gatherTime =
    secondsOf([&] { *values = gatherValues(this->structure(), *this->Made.cells); });
  this->rangesTime =
    secondsOf([&] { values->ranges = findValueRanges(this->structure(), *values); });
  this->Plain.values = std::move(values);
  if (this->values().range.empty())
  {
    throw std::runtime_error("scene '" + this->Made.name + "': no cell holds a number");
  }
  this->Transfer = this->Made.transfer(this->values().range);
}

Scene::~Scene() = default;

Volume Scene::volume(Reconstruction reconstruction) const
{
  if (reconstruction != Reconstruction::Completed)
  {
    return this->Plain;
  }
  if (!this->Completed)
  {
    this->CompletionTime =
      secondsOf([&] { this->Completed = complete(this->structure(), this->values()); });
  }
  return { this->Plain.structure, this->Completed };
}

double Scene::buildTime(Reconstruction reconstruction) const
{
  this->volume(reconstruction); // completes it, if that is to be counted
  return this->structureTime + this->gatherTime + this->rangesTime +
    (reconstruction == Reconstruction::Completed ? this->CompletionTime : 0.0);
}

std::uint64_t Scene::hostBytes(Reconstruction reconstruction) const
{
  return this->structure().bytes() + this->volume(reconstruction).values->bytes();
}

reference::View Scene::referenceView(const Size& size) const
{
  reference::View view =
    reference::makeView(this->Made.hierarchy, this->Made.camera, size[0], size[1]);
  if (!this->Made.surface.triangles.empty())
  {
    std::vector<float>& depth = this->Depths[size];
    depth = depth.empty() ? drawDepth(this->Made.surface, view) : depth;
    view.depth = depth;
  }
  return view;
}

View Scene::view(const Size& size, Reconstruction reconstruction) const
{
  const reference::View from = this->referenceView(size);
  glm::dmat4 toHalfCells = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0));
  toHalfCells = glm::translate(toHalfCells, -glm::dvec3(this->structure().tree.bounds.lo));
  View view;
  view.camera.ndcToHalfCells = toHalfCells * from.ndcToLogical;
  const glm::dvec3 half = 0.5 * this->Made.hierarchy.spacing;
  view.camera.halfCellsToData = { half.x, 0.0, 0.0, 0.0, half.y, 0.0, 0.0, 0.0, half.z };
  view.target.width = size[0];
  view.target.height = size[1];
  view.quality.reconstruction = reconstruction;
  view.opacityUnitDistance = this->Made.opacityUnitDistance;
  view.target.depth = from.depth.empty() ? nullptr : this->Depths.at(size).data();
  return view;
}

reference::Image Scene::renderReference(
  const Size& size, reference::Reconstruction reconstruction, double& error) const
{
  const reference::Oracle oracle(
    this->Made.hierarchy, findLeafBoxes(this->Made.hierarchy), *this->Made.cells);
  reference::Oracle::Settings settings;
  settings.reconstruction = reconstruction;
  settings.opacityUnitDistance = this->Made.opacityUnitDistance;
  settings.tolerance = this->Made.tolerance;
  return oracle.render(this->referenceView(size), this->Transfer, settings, error);
}

reference::Image Scene::renderTruth(const Size& size, double& error) const
{
  if (this->Made.truth)
  {
    error = 0.0;
    return this->Made.truth(size);
  }
  return this->renderReference(size, reference::Reconstruction::Basis, error);
}

const VTKScene& Scene::vtk() const
{
  if (!this->ForVTK)
  {
    this->ForVTK = this->Made.makeVTK ? this->Made.makeVTK(*this) : makeVTKScene(*this);
  }
  return *this->ForVTK;
}
}
}
