// SPDX-License-Identifier: BSD-3-Clause
#include "Changes.h"

#include "DirectMethods.h"
#include "Timing.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace exabricks
{
namespace benchmarks
{
namespace
{
using Points = std::vector<TransferFunction::Point>;

struct Change
{
  std::string what;
  std::string traversal;
  Costs total; // from the transfer function to tables on the device; of the camera: a frame
  std::vector<double> color;   // of the tables, where they were made anew
  std::vector<double> opacity; // of active regions and their tree, likewise
  std::vector<double> march;
  // Never done anew: the renderer's own times of them stayed as they were.
  bool keptVolume = true;
  bool keptColors = true;
  bool keptOpacity = true;
};

TransferFunction swapRedAndBlue(Points points)
{
  for (TransferFunction::Point& point : points)
  {
    std::swap(point.color.r, point.color.b);
  }
  return TransferFunction(points);
}

TransferFunction scaleOpacity(Points points, double factor)
{
  for (TransferFunction::Point& point : points)
  {
    point.color.a *= factor;
  }
  return TransferFunction(points);
}

// Clear below the middle of the values that show.
TransferFunction cutOff(const TransferFunction& from)
{
  Range shown;
  for (const TransferFunction::Point& point : from.points())
  {
    if (point.color.a > 0.0)
    {
      shown.add(point.value);
    }
  }
  const double middle = 0.5 * (shown.min + shown.max);
  const glm::dvec4 at = from.evaluate(middle);
  Points points{ { middle, glm::dvec4(glm::dvec3(at), 0.0) }, { middle, at } };
  for (const TransferFunction::Point& point : from.points())
  {
    if (point.value > middle)
    {
      points.push_back(point);
    }
  }
  return TransferFunction(points);
}

struct Traverser
{
  DirectMethod& direct;
  const char* name;
};

void look(
  Change& change, const VolumeRenderer::Statistics& before, const VolumeRenderer::Statistics& after)
{
  change.keptVolume = change.keptVolume && before.uploadTime == after.uploadTime;
  if (before.colorTime != after.colorTime)
  {
    change.keptColors = false;
    change.color.push_back(after.colorTime);
  }
  if (before.opacityTime != after.opacityTime)
  {
    change.keptOpacity = false;
    change.opacity.push_back(after.opacityTime);
  }
  if (before.marchTime != after.marchTime)
  {
    change.march.push_back(after.marchTime);
  }
}

template <typename Work>
void measure(Change& change, DirectMethod& direct, const Work& work)
{
  const auto before = direct.statistics();
  change.total.measure(work);
  look(change, before, direct.statistics());
}

void add(const Scene& scene, const Change& change, accuracy::CsvTable& table)
{
  const auto ms = [](const std::vector<double>& seconds)
  { return accuracy::csvNumber(1e3 * median(seconds)); };
  const std::string kept = std::string(change.keptVolume ? "volume " : "") +
    (change.keptColors ? "colours " : "") + (change.keptOpacity ? "opacity" : "");
  table.add({ scene.name(), change.what, change.traversal, ms(change.total.wall), ms(change.color),
    ms(change.opacity), ms(change.march), kept });
}
}

void measureChanges(const Scene& scene, const Size& size, int rounds, accuracy::CsvTable& table)
{
  if (table.columns().empty())
  {
    table = accuracy::CsvTable({ "scene", "change", "traversal", "total_ms", "colour_ms",
      "opacity_ms", "march_ms", "kept" });
  }
  DirectMethod kdTree(scene, { Reconstruction::Basis, Traversal::KdTree });
  DirectMethod rayQuery(scene, { Reconstruction::Basis, Traversal::RayQuery });
  const Traverser traversers[] = { { kdTree, "k-d tree" }, { rayQuery, "ray query" } };
  for (const Traverser& traverser : traversers)
  {
    traverser.direct.setUp(DefaultStepScale);
    traverser.direct.draw(size, DefaultStepScale);
  }

  const Points& points = scene.transfer().points();
  const std::pair<const char*, TransferFunction> others[] = { { "colours", swapRedAndBlue(points) },
    { "height of opacity", scaleOpacity(points, 0.9) },
    { "values that show", cutOff(scene.transfer()) } };
  for (const auto& other : others)
  {
    for (const Traverser& traverser : traversers)
    {
      Change change;
      change.what = other.first;
      change.traversal = traverser.name;
      for (int i = 0; i < 2 * rounds; ++i)
      {
        const TransferFunction& next = i % 2 == 0 ? other.second : scene.transfer();
        measure(change, traverser.direct, [&] { traverser.direct.setTransferFunction(next); });
      }
      add(scene, change, table);
    }
  }

  const View view = scene.view(size, Reconstruction::Basis);
  View turned = view;
  const glm::dmat4 roll =
    glm::rotate(glm::dmat4(1.0), glm::radians(5.0), glm::dvec3(0.0, 0.0, 1.0));
  turned.camera.ndcToHalfCells = view.camera.ndcToHalfCells * roll;
  for (const Traverser& traverser : traversers)
  {
    Change change;
    change.what = "camera";
    change.traversal = traverser.name;
    for (int i = 0; i < 2 * rounds; ++i)
    {
      measure(change, traverser.direct, [&] { traverser.direct.draw(i % 2 == 0 ? turned : view); });
    }
    add(scene, change, table);
  }
}
}
}
