// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h" // fileNameOf
#include "Report.h"
#include "TargetTables.h"

#include "Accuracy/Charts.h"
#include "Accuracy/ObservedOrder.h"

#include "Failure.h"
#include "Output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace exabricks
{
namespace benchmarks
{
namespace
{
using namespace accuracy;
namespace fs = std::filesystem;

// Whole, or not there: drawn under another name first.
void draw(const Chart& chart, const std::string& folder, const std::string& name)
{
  const fs::path path = fs::path(folder) / (name + ".png");
  const fs::path part = fs::path(folder) / ("." + name + ".part.png");
  std::error_code error;
  if (drawChart(chart, part.string()))
  {
    fs::rename(part, path, error);
    if (!error)
    {
      return;
    }
  }
  fs::remove(part, error);
  throw render::Failure(
    render::ExitCode::OutputUnwritable, "'" + path.string() + "' cannot be written.");
}

// The slower of the two traversals is left out: its pictures are the same.
bool isSlowerTwin(const Results& results, const Result& row)
{
  const std::size_t comma = row.method.rfind(", ");
  const std::string end = comma == std::string::npos ? "" : row.method.substr(comma);
  if (end != ", k-d tree" && end != ", ray query")
  {
    return false;
  }
  const std::string twin =
    row.method.substr(0, comma) + (end == ", k-d tree" ? ", ray query" : ", k-d tree");
  double own = 0.0;
  double other = 0.0;
  bool both = false;
  for (const Result& a : results.rows)
  {
    for (const Result& b : results.rows)
    {
      if (a.scene == row.scene && b.scene == row.scene && a.method == row.method &&
        b.method == twin && a.value == b.value)
      {
        own += a.wall;
        other += b.wall;
        both = true;
      }
    }
  }
  return both && (own > other || (own == other && end == ", ray query"));
}

std::string shortName(const std::string& method)
{
  const std::pair<const char*, const char*> names[] = {
    { "resampled, vtkGPUVolumeRayCastMapper", "resampled, GPU mapper" },
    { "resampled, vtkFixedPointVolumeRayCastMapper", "resampled, fixed point" },
    { "vtkMultiBlockVolumeMapper, all blocks", "MultiBlock mapper" },
    { "vtkMultiBlockVolumeMapper, covered cells blanked", "MultiBlock, blanked" },
    { "vtkAMRVolumeMapper", "AMR mapper" },
    { "vtkExaBricksVolumeMapper", "ours in a window" },
  };
  for (const auto& name : names)
  {
    if (method == name.first)
    {
      return name.second;
    }
  }
  return method;
}

// Against the integral of the basis, completed levels have no error that says anything: they are
// compared with analytic fields.
bool isComparable(const Results& results, const Result& row)
{
  const bool isField = std::any_of(results.scenes.begin(), results.scenes.end(),
    [&](const SceneFigures& scene) { return scene.scene == row.scene && scene.group == "field"; });
  return isField || row.method.compare(0, 9, "completed") != 0;
}

using Measure = std::function<double(const Result&)>;

// Ours with something taken away, and what else is compared with the basis alone, has a chart of
// its own: there are many of them.
bool isAblation(const Result& row)
{
  return row.method == ByToleranceOfAllLevels ||
    (row.role == Role::Baseline && row.method != CellLocation);
}

// One curve for each method of a scene, in the order of its parameter.
std::vector<Series> curves(
  const Results& results, const std::string& scene, const Measure& x, const Measure& y)
{
  std::vector<Series> series;
  std::vector<std::string> done;
  for (const Result& first : results.rows)
  {
    if (first.scene != scene || std::count(done.begin(), done.end(), first.method) > 0 ||
      isSlowerTwin(results, first) || !isComparable(results, first))
    {
      continue;
    }
    done.push_back(first.method);
    std::vector<const Result*> rows;
    for (const Result& r : results.rows)
    {
      if (r.scene == scene && r.method == first.method && std::isfinite(x(r)) &&
        std::isfinite(y(r)))
      {
        rows.push_back(&r);
      }
    }
    std::sort(rows.begin(), rows.end(),
      [](const Result* a, const Result* b) { return a->value < b->value; });
    Series curve;
    curve.name = shortName(first.method);
    for (const Result* r : rows)
    {
      curve.points.emplace_back(x(*r), y(*r));
    }
    if (!curve.points.empty())
    {
      series.push_back(curve);
    }
  }
  return series;
}

double frame(const Result& r) { return 1e3 * r.wall; }

template <typename Predicate>
Results only(const Results& results, const Predicate& wanted)
{
  Results some = results;
  some.rows.erase(
    std::remove_if(some.rows.begin(), some.rows.end(), [&](const Result& r) { return !wanted(r); }),
    some.rows.end());
  return some;
}

Chart timeChart(const Results& results, const std::string& scene, const Axis& errorAxis,
  const Measure& error, bool largerIsBetter)
{
  Chart chart;
  chart.title = scene;
  chart.x = { "frame, ms", true, {} };
  chart.y = errorAxis;
  chart.series = curves(results, scene, frame, error);
  const Series front = paretoFront(chart.series, largerIsBetter);
  chart.series.insert(chart.series.begin(), front);
  return chart;
}

double psnrOf(const Result& r) { return r.psnr; }

Chart psnrChart(const Results& results, const std::string& scene)
{
  return timeChart(only(results, [](const Result& r) { return !isAblation(r); }), scene,
    { "PSNR, dB", false, {} }, psnrOf, true);
}

void drawAblations(const Results& results, const std::string& scene, const std::string& folder)
{
  const auto compared = [](const Result& r)
  { return r.role == Role::Baseline || r.method.compare(0, 6, "basis,") == 0; };
  Chart chart = timeChart(only(results, compared), scene, { "PSNR, dB", false, {} }, psnrOf, true);
  chart.title = scene + ": ours with something taken away";
  if (chart.series.size() >= 3)
  {
    draw(chart, folder, fileNameOf(scene) + "_ablations");
  }
}

void drawSamples(const Results& results, const std::string& scene, const std::string& folder)
{
  Chart chart;
  chart.title = scene + ": samples";
  chart.x = { "samples of the field in a pixel", true, {} };
  chart.y = { "PSNR, dB", false, {} };
  chart.series = curves(
    results, scene, [](const Result& r) { return r.samples; }, psnrOf);
  if (!chart.series.empty())
  {
    draw(chart, folder, fileNameOf(scene) + "_samples");
  }
}

void drawTimeCharts(const Results& all, const std::string& scene, const std::string& folder)
{
  const Results results = only(all, [](const Result& r) { return !isAblation(r); });
  const std::string name = fileNameOf(scene);
  const Chart psnr = psnrChart(results, scene);
  if (psnr.series.size() < 2)
  {
    return;
  }
  draw(psnr, folder, name + "_psnr");
  draw(timeChart(
         results, scene, { "RMSE", true, {} }, [](const Result& r) { return r.rmse; }, false),
    folder, name + "_rmse");
  draw(timeChart(
         results, scene, { "1 - SSIM", true, {} }, [](const Result& r) { return 1.0 - r.ssim; },
         false),
    folder, name + "_ssim");
}

void drawStepChart(const Results& results, const std::string& scene, const std::string& folder)
{
  Chart chart;
  chart.title = scene + ": integration";
  chart.x = { "step scale", true, {} };
  chart.y = { "RMSE against the own field's integral", true, {} };
  Results steps;
  for (const Result& r : results.rows)
  {
    if (r.parameter == StepScale && r.rmseOwn > 0.0)
    {
      steps.rows.push_back(r);
    }
  }
  chart.series = curves(
    steps, scene, [](const Result& r) { return r.value; },
    [](const Result& r) { return r.rmseOwn; });
  for (Series& series : chart.series)
  {
    if (series.points.size() >= 3)
    {
      char order[32];
      std::snprintf(order, sizeof order, ": order %.1f", observedOrder(series.points));
      series.name += order;
    }
  }
  const auto isShort = [](const Series& s) { return s.points.size() < 2; };
  chart.series.erase(
    std::remove_if(chart.series.begin(), chart.series.end(), isShort), chart.series.end());
  if (!chart.series.empty())
  {
    chart.series.push_back(orderGuide(chart.series.front(), 2.0, 0.5));
    draw(chart, folder, fileNameOf(scene) + "_steps");
  }
}

struct Part
{
  const char* name;
  double SceneFigures::*member;
  double scale;
};

void drawGrowth(const Results& results, const std::string& folder, const std::string& name,
  const std::string& unit, const std::vector<Part>& parts)
{
  Chart chart;
  chart.title = name;
  chart.x = { "leaf cells", true, {} };
  chart.y = { unit, true, {} };
  std::vector<std::string> scenes;
  for (const SceneFigures& figures : results.growth)
  {
    if (std::find(scenes.begin(), scenes.end(), figures.scene) == scenes.end())
    {
      scenes.push_back(figures.scene);
    }
  }
  for (const Part& part : parts)
  {
    for (const std::string& scene : scenes)
    {
      Series series;
      series.name = scenes.size() > 1 ? scene + ", " + part.name : std::string(part.name);
      for (const SceneFigures& figures : results.growth)
      {
        const double value = part.scale * figures.*part.member;
        if (figures.scene == scene && value > 0.0)
        {
          series.points.emplace_back(figures.leafCells, value);
        }
      }
      if (!series.points.empty())
      {
        chart.series.push_back(series);
      }
    }
  }
  if (!chart.series.empty())
  {
    draw(chart, folder, fileNameOf(name));
  }
}

// What a reader sees first: the scene with known targets; else one of those on which peers were
// measured, real data if there are.
std::string mainScene(const Results& results)
{
  std::string found;
  bool isData = false;
  for (const SceneFigures& scene : results.scenes)
  {
    const bool hasPeers = std::any_of(results.rows.begin(), results.rows.end(),
      [&](const Result& r)
      { return r.scene == scene.scene && r.role == Role::Peer && std::isfinite(r.psnr); });
    if (hasPeers && scene.scene == TargetScene)
    {
      return scene.scene;
    }
    if (hasPeers && (found.empty() || (!isData && scene.group == "data")))
    {
      found = scene.scene;
      isData = scene.group == "data";
    }
  }
  return found;
}
}

void drawCharts(const Results& results, const std::string& folder)
{
  for (const std::string& scene : sceneNames(results))
  {
    drawTimeCharts(results, scene, folder);
    drawAblations(results, scene, folder);
    drawSamples(results, scene, folder);
    drawStepChart(results, scene, folder);
  }
  const double mib = 1.0 / 1048576.0;
  drawGrowth(results, folder, "Growth of time", "seconds",
    { { "leaf boxes, bricks, regions", &SceneFigures::structureTime, 1.0 },
      { "values", &SceneFigures::gatherTime, 1.0 }, { "ranges", &SceneFigures::rangesTime, 1.0 },
      { "frame, k-d tree", &SceneFigures::frameKdTree, 1.0 },
      { "frame, ray query", &SceneFigures::frameRayQuery, 1.0 } });
  drawGrowth(results, folder, "Growth of frames by tolerance", "seconds",
    { { "all levels", &SceneFigures::frameOfAllLevels, 1.0 },
      { "some left out", &SceneFigures::frameByTolerance, 1.0 } });
  drawGrowth(results, folder, "Growth of memory", "MiB",
    { { "scalars", &SceneFigures::scalarBytes, mib }, { "bricks", &SceneFigures::brickBytes, mib },
      { "regions on the host", &SceneFigures::regionHostBytes, mib },
      { "regions on the device", &SceneFigures::regionBytes, mib },
      { "acceleration structure", &SceneFigures::accelerationBytes, mib },
      { "host, all", &SceneFigures::hostBytes, mib } });
  const std::string main = mainScene(results);
  if (!main.empty())
  {
    Chart chart = psnrChart(results, main);
    chart.title = "Frame time against accuracy: " + main;
    draw(chart, folder, "main");
  }
}

void writeReport(const Results& results, const std::string& folder)
{
  for (const auto& table : makeTables(results))
  {
    render::WriteText((fs::path(folder) / table.first).string(), table.second);
  }
  drawCharts(results, folder);
}
}
}
