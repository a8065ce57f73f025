// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Timing.h"
#include "VTKScene.h"

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
  this->structureTime = secondsOf([&] { this->Built = buildStructure(this->Made.hierarchy); });
  this->gatherTime = secondsOf(
    [&] {
      this->Values = gatherScalars(this->Built.hierarchy, this->Built.bricks, *this->Made.cells);
    });
  this->rangesTime = secondsOf(
    [&]
    {
      this->Ranges = findValueRanges(
        this->Built.tree, this->Built.bricks, this->Built.hierarchy.cellWidth, this->Values);
    });
  if (this->Values.range.empty())
  {
    throw std::runtime_error("scene '" + this->Made.name + "': no cell holds a number");
  }
  this->Transfer = this->Made.transfer(this->Values.range);
}

Scene::~Scene() = default;

const Scene::Completed& Scene::complete() const
{
  if (!this->CompletedParts)
  {
    auto made = std::make_unique<Completed>();
    const std::vector<std::int64_t>& width = this->Built.hierarchy.cellWidth;
    made->time = secondsOf(
      [&]
      {
        made->completion =
          exabricks::complete(this->Built.tree, this->Built.bricks, width, this->Values);
        made->ranges = findValueRanges(
          this->Built.tree, made->completion.bricks, width, made->completion.scalars);
      });
    this->CompletedParts = std::move(made);
  }
  return *this->CompletedParts;
}

Volume Scene::volume(Reconstruction reconstruction) const
{
  const std::vector<std::int64_t>& width = this->Built.hierarchy.cellWidth;
  if (reconstruction == Reconstruction::Completed)
  {
    const Completed& made = this->complete();
    return { &this->Built.tree, &made.completion.bricks, &width, &made.completion.scalars,
      &made.ranges };
  }
  return { &this->Built.tree, &this->Built.bricks, &width, &this->Values, &this->Ranges };
}

double Scene::buildTime(Reconstruction reconstruction) const
{
  return this->structureTime + this->gatherTime + this->rangesTime +
    (reconstruction == Reconstruction::Completed ? this->complete().time : 0.0);
}

std::uint64_t Scene::hostBytes(Reconstruction reconstruction) const
{
  const bool completed = reconstruction == Reconstruction::Completed;
  const Scalars& scalars = completed ? this->complete().completion.scalars : this->Values;
  const ValueRanges& valueRanges = completed ? this->complete().ranges : this->Ranges;
  return this->Built.bytes() + scalars.values.capacity() * sizeof(float) + valueRanges.bytes();
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
  toHalfCells = glm::translate(toHalfCells, -glm::dvec3(this->Built.tree.bounds.lo));
  View view;
  view.camera.ndcToHalfCells = toHalfCells * from.ndcToLogical;
  view.camera.ndcToData = from.ndcToWorld;
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
