// SPDX-License-Identifier: BSD-3-Clause
// exabricks-benchmark: the order of the work is the order of this file.
#include "Bounds.h"
#include "BrickSizes.h"
#include "Growth.h"
#include "Machine.h"
#include "MarchCounts.h"
#include "Measure.h"
#include "RankCosts.h"
#include "Request.h"

#include "Display.h"
#include "Failure.h"
#include "Messages.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace
{
using namespace exabricks::benchmarks;
using exabricks::benchmarks::say;
using render::ExitCode;
using render::Failure;

void makeFolder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
  {
    throw Failure(ExitCode::OutputUnwritable,
      "'" + folder + "' cannot be made: " + (error ? error.message() : "it is a file") + ".");
  }
}

std::vector<SceneKind> chooseScenes(const Request& request)
{
  std::vector<std::string> missing;
  const std::vector<SceneKind> all = listScenes(request.data, request.input, missing);
  std::vector<SceneKind> chosen;
  for (const std::string& name : request.scenes)
  {
    const bool known = std::any_of(all.begin(), all.end(),
      [&](const SceneKind& kind) { return kind.name == name || kind.group == name; });
    if (!known)
    {
      std::string why = "There is no scene '" + name + "'. --list says which there are.";
      for (const std::string& line : missing)
      {
        why +=
          line.compare(0, name.size() + 1, name + ":") == 0 ? " Its data are missing: " + line : "";
      }
      throw Failure(ExitCode::BadArguments, why);
    }
  }
  for (const SceneKind& kind : all)
  {
    const auto is = [&](const std::string& name)
    { return kind.name == name || kind.group == name; };
    const bool named = std::any_of(request.scenes.begin(), request.scenes.end(), is);
    const bool byDefault =
      request.scenes.empty() && request.input.draw.Input.empty() && !request.structure;
    const bool part = request.plan.quick ? kind.quick : kind.full;
    if (named || kind.group == "input" || (byDefault && part))
    {
      chosen.push_back(kind);
    }
  }
  if (!request.data.empty() && !request.plan.quick)
  {
    for (const std::string& line : missing)
    {
      say("left out: " + line);
    }
  }
  return chosen;
}

Plan planFor(const SceneKind& kind, const Request& request)
{
  Plan plan = request.plan;
  if (request.full && !kind.thorough)
  {
    plan.quick = true;
    plan.methods.erase(std::remove_if(plan.methods.begin(), plan.methods.end(),
                         [](const MethodKind& method) { return !method.everywhere; }),
      plan.methods.end());
  }
  return plan;
}

void list(const Request& request)
{
  std::vector<std::string> missing;
  std::cout << "Scenes (group: name)\n";
  for (const SceneKind& kind : listScenes(request.data, request.input, missing))
  {
    std::cout << "  " << kind.group << ": " << kind.name << (kind.scalable ? " (any size)" : "")
              << '\n';
  }
  for (const std::string& line : missing)
  {
    std::cout << "  not found, data: " << line << '\n';
  }
  std::cout << "Methods\n";
  for (const MethodKind& kind : listMethods())
  {
    std::cout << "  " << nameOf(kind.role) << ": " << kind.name
              << (kind.parameter.empty() ? "" : ", by " + kind.parameter) << '\n';
  }
}

void checkBounds(const std::vector<std::string>& broken)
{
  if (!broken.empty())
  {
    std::string text;
    for (const std::string& line : broken)
    {
      text += "\n  " + line;
    }
    throw Failure(ExitCode::RenderingFailed, "bounds are not kept:" + text);
  }
}

void measure(const Request& request)
{
  const std::vector<SceneKind> scenes = chooseScenes(request);
  render::makeWindow(); // says what is missing before hours of work
  makeFolder(request.folder);
  if (!request.plan.pictures.empty())
  {
    makeFolder(request.plan.pictures);
  }
  const double loadBefore = loadAverage();
  Results results;
  std::vector<std::string> broken;
  const auto write = [&]
  {
    char text[64];
    std::snprintf(text, sizeof text, "%.1f before, %.1f after", loadBefore, loadAverage());
    results.machine = describeMachine();
    results.machine.emplace_back("load average of the last minute", text);
    const auto pixels = [](const Size& size)
    { return std::to_string(size[0]) + "x" + std::to_string(size[1]); };
    results.machine.emplace_back("frames",
      pixels(request.plan.size) + ", at most " + std::to_string(request.plan.rounds) + " of each");
    results.machine.emplace_back("compared", pixels(request.plan.accuracySize));
    writeResults(results, request.folder);
  };
  for (const SceneKind& kind : scenes)
  {
    say(kind.name + ": making it");
    const Scene scene(kind.make(request.leafCells));
    const auto faults = findBrokenStructure(scene);
    broken.insert(broken.end(), faults.begin(), faults.end());
    measureScene(scene, kind.group, planFor(kind, request), results);
    render::throwIfErrors(ExitCode::RenderingFailed, "VTK reported errors");
    write(); // what is done is kept, whatever comes
  }
  if (request.growth)
  {
    std::vector<std::string> missing;
    for (const SceneKind& kind : listScenes({}, {}, missing))
    {
      if (kind.scalable)
      {
        measureGrowth(kind, request.largest, request.plan.size, results);
        write();
      }
    }
  }
  if (!results.rows.empty())
  {
    say("written to '" + request.folder + "'; Utilities/report draws tables and charts of it");
  }
  const auto faults = findBrokenBounds(results);
  broken.insert(broken.end(), faults.begin(), faults.end());
  checkBounds(request.plan.quick ? broken : std::vector<std::string>{});
}

void printStructure(const Request& request)
{
  std::vector<std::string> missing;
  std::cout << BrickSizesHeader << std::endl;
  for (const SceneKind& kind : listScenes({}, {}, missing))
  {
    if (kind.scalable)
    {
      printBrickSizes(kind.name, kind.make(0.0).hierarchy, request.plan.rounds);
    }
  }
}

void printMarch(const Request& request)
{
  std::cout << MarchCountsHeader << std::endl;
  for (const SceneKind& kind : chooseScenes(request))
  {
    const Scene scene(kind.make(request.leafCells));
    const std::vector<double>& asked = request.plan.stepScales;
    for (const double stepScale : asked.empty() ? std::vector<double>{ 1.0 } : asked)
    {
      printMarchCounts(scene, request.plan.size, stepScale);
    }
  }
}

void printRanks(const Request& request)
{
  std::cout << RankCostsHeader << std::endl;
  for (const SceneKind& kind : chooseScenes(request))
  {
    printRankCosts(kind.make(request.leafCells), request.plan.size, request.ranks);
  }
}

void run(const Request& request)
{
  switch (request.task)
  {
    case Request::Task::List:
      list(request);
      break;
    case Request::Task::Measure:
      if (request.structure)
      {
        printStructure(request);
      }
      if (request.march)
      {
        printMarch(request);
      }
      if (request.ranks > 0)
      {
        printRanks(request);
      }
      if (!request.folder.empty())
      {
        measure(request);
      }
      break;
  }
}
}

int main(int argc, char** argv)
{
  try
  {
    Request request;
    if (parseRequest(argc, argv, request))
    {
      render::takeMessages(true);
      run(request);
      render::throwIfErrors(ExitCode::RenderingFailed, "VTK met an error while it cleaned up");
    }
    return static_cast<int>(ExitCode::Fine);
  }
  catch (const Failure& failure)
  {
    std::cerr << "exabricks-benchmark: " << failure.what() << '\n';
    return static_cast<int>(failure.Code);
  }
  catch (const std::exception& error)
  {
    std::cerr << "exabricks-benchmark: " << error.what() << '\n';
    return static_cast<int>(ExitCode::RenderingFailed);
  }
}
