// SPDX-License-Identifier: BSD-3-Clause
// Draws an AMR data set with vtkExaBricksVolumeMapper, and on request with what VTK offers beside
// it; measures what that takes, and how near the pictures come to the oracle's. It prints Markdown
// tables:
//
//   data       what the data set is cut into, and what building and keeping it takes;
//   frames     per method: time to set up from the AMR in memory to the first picture (of those in
//              windows with the start of OpenGL, of the mapper with that of Vulkan too), a frame's
//              wall and processor time (medians; all methods are drawn in turn), time of the march
//              alone, and PSNR of the whole picture with a peak of 1. By "direct", the renderer of
//              the mapper is called without a window and its float picture compared; the others are
//              read back from their windows with 8 bits a channel, so that a picture without any
//              black comes to 59 dB at most;
//   changes    what has to be done anew when colours, the height of opacities, the values that show
//              anything, or the camera change.
//
//   CompareMappers INPUT [--array NAME] [--log] [--size WxH] [--peers] [--json FILE] ...
//
// for any input that exabricks-render opens, with its defaults for array, opacity and camera; see
// --help. --scene takes camera and transfer function from a JSON file instead:
//
//   { "camera": { "position": [x, y, z], "focal": [...], "up": [...], "view_angle": degrees },
//     "unit_distance": length, "tf": [[value, red, green, blue, opacity], ...] }
//
// Run it on a display (xvfb-run -a CompareMappers ...). Compare methods by ratios, and by processor
// time where other programs run: the load average is printed too.
#include "Changes.h"
#include "Methods.h"

#include "Failure.h"
#include "Messages.h"
#include "Output.h"
#include "ParseValues.h"

#include "vtkVersion.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace
{
using namespace exabricks;
using namespace exabricks::benchmarks;
using Json = nlohmann::ordered_json;

bool parse(int argc, char** argv, Request& request)
{
  CLI::App app("Measures vtkExaBricksVolumeMapper, and what else VTK has, on an AMR data set.");
  render::Options& draw = request.draw;
  draw.Quiet = true;
  std::string size = "256x256";
  std::string accuracySize;
  std::string opacity;
  std::string component;
  app.add_option("input", draw.Input, "AMR data set")->required();
  app.add_option("-a,--array", draw.Array, "Cell array [the first scalar one]");
  app.add_option("--component", component, "Of a vector: N from 0, or magnitude [magnitude]");
  app.add_flag("--log", draw.Log, "Draw log10 of the array");
  app.add_option("--levels", draw.Levels, "Number of levels to use, from the coarsest [all]");
  app.add_option("--size", size, "Of the pictures that are timed [256x256]");
  app.add_option("--accuracy-size", accuracySize, "Of those compared with the oracle [--size]");
  app.add_option("--view", draw.View, "Side to look from: iso +x -x +y -y +z -z [iso]");
  app.add_option("--color-map", draw.ColorMap, "Colour map [viridis]");
  app.add_option("--opacity", opacity, "Opacity points V:O,V:O,... [from the histogram]");
  app.add_option("--opacity-unit", draw.OpacityUnit, "Unit distance [diagonal / 100]");
  app.add_option("--scene", request.scene, "JSON file with camera and transfer function");
  app.add_option("--rounds", request.rounds, "Frames and changes to take the median of [7]")
    ->check(CLI::Range(1, 10000));
  app.add_option("--step-scales", request.stepScales, "Of the direct methods [1,0.25]")
    ->delimiter(',');
  app.add_flag("--peers", request.peers, "Measure VTK's other mappers too");
  app.add_option("--json", request.json, "Write all numbers to this file");
  app.add_option("--pictures", request.pictures, "Write pictures; what their names begin with");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (app.exit(error) != 0)
    {
      throw render::Failure(render::ExitCode::BadArguments, "See --help.");
    }
    return false;
  }
  draw.Size = render::ParseSize("--size", size);
  request.accuracySize =
    accuracySize.empty() ? draw.Size : render::ParseSize("--accuracy-size", accuracySize);
  draw.Component =
    component.empty() ? std::nullopt : render::ParseComponent("--component", component);
  if (!opacity.empty())
  {
    draw.Opacity = render::ParseOpacity("--opacity", opacity);
  }
  return true;
}

double load()
{
  double average = -1.0;
  getloadavg(&average, 1);
  return average;
}

Json describeMethod(const Method& method)
{
  return { { "name", method.name }, { "set_up", method.setUp },
    { "frame_median", median(method.costs.wall) }, { "cpu_median", median(method.costs.cpu) },
    { "march_median", median(method.marches) }, { "frames", method.costs.wall },
    { "psnr_rgba", method.decibelRGBA }, { "psnr_rgba_drawn", method.decibelDrawn },
    { "psnr_rgb", method.decibelRGB } };
}

Json describeChange(const Change& change)
{
  return { { "change", change.what }, { "traversal", change.traversal },
    { "total_median", median(change.total.wall) }, { "color_median", median(change.color) },
    { "opacity_median", median(change.opacity) }, { "march_median", median(change.march) },
    { "kept_volume", change.keptVolume }, { "kept_colors", change.keptColors },
    { "kept_opacity", change.keptOpacity } };
}

// "-" for what was not measured.
std::string number(double value, const char* format)
{
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return std::isnan(value) ? "-" : text;
}

std::string ms(double seconds)
{
  return number(1e3 * seconds, seconds < 0.001 ? "%.3f" : seconds < 0.1 ? "%.2f" : "%.0f");
}

void printMethods(const std::vector<Method>& methods)
{
  std::printf(
    "\n| method | set-up ms | frame ms | CPU ms | march ms | dB RGBA | dB RGBA drawn | dB RGB |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Method& method : methods)
  {
    std::printf("| %s | %s | %s | %s | %s | %s | %s | %s |\n", method.name.c_str(),
      ms(method.setUp).c_str(), ms(median(method.costs.wall)).c_str(),
      ms(median(method.costs.cpu)).c_str(), ms(median(method.marches)).c_str(),
      number(method.decibelRGBA, "%.1f").c_str(), number(method.decibelDrawn, "%.1f").c_str(),
      number(method.decibelRGB, "%.1f").c_str());
  }
}

void printChanges(const std::vector<Change>& changes)
{
  std::printf("\n| change | traversal | total ms | colour ms | opacity ms | march ms | kept |\n"
              "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Change& change : changes)
  {
    const std::string kept = std::string(change.keptVolume ? "volume " : "") +
      (change.keptColors ? "colours " : "") + (change.keptOpacity ? "opacity" : "");
    std::printf("| %s | %s | %s | %s | %s | %s | %s |\n", change.what.c_str(),
      change.traversal.c_str(), ms(median(change.total.wall)).c_str(),
      ms(median(change.color)).c_str(), ms(median(change.opacity)).c_str(),
      ms(median(change.march)).c_str(), kept.c_str());
  }
}

void run(const Request& request)
{
  const double loadBefore = load();
  const Subject subject(request);
  const vtkExaBricksData::Contents& contents = subject.contents();
  const Structure& structure = *contents.Structure;
  std::vector<double> structureTimes;
  std::vector<double> scalarsTimes;
  subject.measureBuilds(request.rounds, structureTimes, scalarsTimes);
  const double buildTime = median(structureTimes) + median(scalarsTimes);

  // The device stays in use, so that none of the set-ups to come has to start it.
  VolumeRenderer first;
  Costs deviceStart;
  deviceStart.measure([&] { first.prepare(); }); // what it may say, the next ones say too
  DirectRenderer kdTree(subject, Traversal::KdTree);
  DirectRenderer rayQuery(subject, Traversal::RayQuery);
  std::vector<Method> methods;
  for (const double scale : request.stepScales)
  {
    const std::string name = ", step " + number(scale, "%g");
    methods.push_back(
      makeDirectMethod(subject, request, kdTree, "direct, k-d tree" + name, scale, buildTime));
    methods.push_back(
      makeDirectMethod(subject, request, rayQuery, "direct, ray query" + name, scale, buildTime));
  }
  methods.push_back(makeMapperMethod(subject, request, buildTime));
  if (request.peers)
  {
    for (Method& method : makePeers(subject, request))
    {
      methods.push_back(std::move(method));
    }
  }
  measureInTurn(methods, request.rounds);
  Costs oracleCosts;
  reference::Image oracle;
  double oracleError = 0.0;
  oracleCosts.measure([&] { oracle = subject.renderOracle(request.accuracySize, oracleError); });
  judge(methods, oracle, request.pictures);
  const auto kdFigures = kdTree.renderer.statistics();
  const auto rayFigures = rayQuery.renderer.statistics();

  const std::string array = subject.array();
  std::printf("%s, %s: device %s, started in %s ms; frames %d x %d, oracle's %d x %d in %.1f s "
              "(error %.1e, mean opacity %.3f); "
              "%d rounds\n\n",
    request.draw.Input.c_str(), array.c_str(), kdFigures.device.c_str(),
    ms(deviceStart.wall.front()).c_str(), request.draw.Size[0], request.draw.Size[1], oracle.width,
    oracle.height, oracleCosts.wall.front(), oracleError, meanOpacity(oracle), request.rounds);
  std::printf("| levels | blocks | leaf cells | bricks | regions | active | structure ms | "
              "scalars ms | host MiB | device MiB, k-d tree | device MiB, ray query |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
              "| %d | %zu | %llu | %zu | %zu | %zu | %s | %s | %.2f | %.2f | %.2f |\n",
    structure.hierarchy.levels(), structure.hierarchy.blocks.size(),
    static_cast<unsigned long long>(structure.leafCells), structure.bricks.size(),
    structure.tree.regions.size(), kdFigures.activeRegions, ms(median(structureTimes)).c_str(),
    ms(median(scalarsTimes)).c_str(), subject.hostBytes() / 1048576.0,
    static_cast<double>(kdFigures.deviceBytes) / 1048576.0,
    static_cast<double>(rayFigures.deviceBytes) / 1048576.0);
  printMethods(methods);
  const std::vector<Change> changes = measureChanges(subject, request, kdTree, rayQuery);
  printChanges(changes);
  std::printf("\nload average %.1f before, %.1f after; %u processors\n", loadBefore, load(),
    std::thread::hardware_concurrency());
  std::fflush(stdout);

  if (!request.json.empty())
  {
    Json json;
    json["input"] = { { "file", request.draw.Input }, { "array", array },
      { "vtk", vtkVersion::GetVTKVersion() }, { "device", kdFigures.device },
      { "device_start", deviceStart.wall.front() }, { "size", request.draw.Size },
      { "accuracy_size", request.accuracySize }, { "rounds", request.rounds },
      { "load_before", loadBefore }, { "load_after", load() } };
    json["data"] = { { "levels", structure.hierarchy.levels() },
      { "blocks", structure.hierarchy.blocks.size() }, { "leaf_cells", structure.leafCells },
      { "bricks", structure.bricks.size() }, { "regions", structure.tree.regions.size() },
      { "active_regions", kdFigures.activeRegions },
      { "structure_seconds", median(structureTimes) }, { "scalars_seconds", median(scalarsTimes) },
      { "host_bytes", subject.hostBytes() },
      { "scalar_bytes", contents.Scalars.values.size() * sizeof(float) },
      { "device_bytes_kd_tree", kdFigures.deviceBytes },
      { "device_bytes_ray_query", rayFigures.deviceBytes } };
    json["oracle"] = { { "seconds", oracleCosts.wall.front() }, { "error", oracleError },
      { "mean_opacity", meanOpacity(oracle) } };
    for (const Method& method : methods)
    {
      json["methods"].push_back(describeMethod(method));
    }
    for (const Change& change : changes)
    {
      json["changes"].push_back(describeChange(change));
    }
    render::WriteText(request.json, json.dump(2) + "\n");
  }
}
}

int main(int argc, char** argv)
{
  try
  {
    Request request;
    if (parse(argc, argv, request))
    {
      render::TakeMessages(false);
      run(request);
      render::ThrowIfErrors(render::ExitCode::RenderingFailed, "VTK reported errors");
    }
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "CompareMappers: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
