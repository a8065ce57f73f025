// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "SourceTables.h"
#include "TargetTables.h"

#include "Accuracy/ObservedOrder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace exabricks
{
namespace benchmarks
{
namespace
{
constexpr double MiB = 1048576.0;

std::string valueOf(const Result& row)
{
  return std::isnan(row.value) ? "" : row.parameter + " " + number(row.value, "%g");
}

std::string seconds(double value)
{
  return number(value, value < 0.1 ? "%.3f" : value < 1.0 ? "%.2f" : "%.1f");
}
std::string mib(double bytes) { return number(bytes / MiB, bytes < 100.0 * MiB ? "%.1f" : "%.0f"); }
std::string count(double value) { return number(value, "%.0f"); }

std::string machineTable(const Results& results)
{
  std::string text = row({ "machine", "" }) + rule(2);
  for (const auto& line : results.machine)
  {
    text += row({ line.first, line.second });
  }
  return text;
}

std::string scenesTable(const std::vector<SceneFigures>& scenes)
{
  std::string text = row({ "scene", "levels", "blocks", "leaf cells", "bricks", "cells per brick",
                       "regions", "of them active", "structure s", "values and ranges s",
                       "k-d tree, device MiB", "ray query, device MiB" }) +
    rule(12);
  for (const SceneFigures& scene : scenes)
  {
    text += row({ scene.scene, count(scene.levels), count(scene.blocks), count(scene.leafCells),
      count(scene.bricks), number(scene.leafCells / scene.bricks, "%.3g"), count(scene.regions),
      count(scene.activeRegions), seconds(scene.structureTime),
      seconds(scene.gatherTime + scene.rangesTime), mib(scene.kdTreeTotal),
      mib(scene.rayQueryTotal) });
  }
  return text;
}

std::string growthTable(const std::vector<SceneFigures>& scenes)
{
  std::string text =
    row({ "scene", "leaf cells", "structure s", "values and ranges s", "frame ms, k-d tree",
      "frame ms, ray query", "by tolerance, all levels", "by tolerance", "levels left out",
      "host MiB", "device MiB, k-d tree", "device MiB, ray query", "bytes per cell, k-d tree" }) +
    rule(13);
  for (const SceneFigures& scene : scenes)
  {
    text += row({ scene.scene, number(scene.leafCells, "%.3g"), seconds(scene.structureTime),
      seconds(scene.gatherTime + scene.rangesTime), milliseconds(scene.frameKdTree),
      milliseconds(scene.frameRayQuery), milliseconds(scene.frameOfAllLevels),
      milliseconds(scene.frameByTolerance), count(scene.levelsLeftOut), mib(scene.hostBytes),
      mib(scene.kdTreeTotal), mib(scene.rayQueryTotal),
      number(scene.kdTreeTotal / scene.leafCells, "%.1f") });
  }
  return text;
}

std::string resultsTable(const Results& results)
{
  std::string text;
  for (const std::string& scene : sceneNames(results))
  {
    text += (text.empty() ? "**" : "\n**") + scene + "**\n\n" +
      row({ "method", "", "frame ms", "CPU ms", "dB", "dB drawn", "SSIM", "set-up s",
        "of it resampling", "host MiB", "device MiB", "samples", "" }) +
      rule(13);
    for (const Result& r : results.rows)
    {
      if (r.scene == scene)
      {
        text += row({ r.method, valueOf(r), milliseconds(r.wall), milliseconds(r.cpu),
          number(r.psnr, "%.1f"), number(r.psnrDrawn, "%.1f"), number(r.ssim, "%.4f"),
          seconds(r.setUp), r.resampling > 0.0 ? seconds(r.resampling) : "", mib(r.hostBytes),
          mib(r.deviceBytes), number(r.samples, "%.1f"), r.note });
      }
    }
  }
  return text;
}

// The mapper as users get it, in a window as its peers are; without it, the renderer alone.
std::vector<const Result*> ours(const Results& results, const std::string& scene)
{
  std::vector<const Result*> mapper;
  std::vector<const Result*> direct;
  for (const Result& r : results.rows)
  {
    if (r.scene == scene && r.role == Role::Ours && !std::isnan(r.psnr))
    {
      (r.method == "vtkExaBricksVolumeMapper" ? mapper : direct).push_back(&r);
    }
  }
  return mapper.empty() ? direct : mapper;
}

const Result* fastestOf(const std::vector<const Result*>& rows, double leastPsnr)
{
  const Result* fastest = nullptr;
  for (const Result* r : rows)
  {
    if (r->psnr >= leastPsnr && (!fastest || r->wall < fastest->wall))
    {
      fastest = r;
    }
  }
  return fastest;
}

std::string peersTable(const Results& results)
{
  std::string text = row({ "scene", "peer", "", "its frame ms", "its dB", "ours at no less dB",
                       "frame ms", "dB", "times less", "dB short of ours at step 1" }) +
    rule(10);
  bool any = false;
  for (const Result& peer : results.rows)
  {
    if (peer.role != Role::Peer)
    {
      continue;
    }
    any = true;
    const auto rows = ours(results, peer.scene);
    const Result* fastest = fastestOf(rows, peer.psnr);
    double atDefault = NotMeasured;
    for (const Result* r : rows)
    {
      atDefault = r->value == DefaultStepScale && std::isnan(atDefault) ? r->psnr : atDefault;
    }
    const double missing = atDefault - peer.psnr;
    text += row({ peer.scene, peer.method, valueOf(peer), milliseconds(peer.wall),
      std::isnan(peer.psnr) ? peer.note : number(peer.psnr, "%.1f"),
      fastest ? valueOf(*fastest) : "-", fastest ? milliseconds(fastest->wall) : "-",
      fastest ? number(fastest->psnr, "%.1f") : "-",
      fastest ? number(peer.wall / fastest->wall, "%.1f") : "-",
      missing > 0.0 ? number(missing, "%.1f") : "reaches it" });
  }
  return any ? text : "";
}

std::string changesTable(const accuracy::CsvTable& changes)
{
  if (changes.size() == 0)
  {
    return {};
  }
  std::string text = row({ "scene", "change", "traversal", "total ms", "colour ms", "opacity ms",
                       "march ms", "kept" }) +
    rule(8);
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const auto ms = [&](const char* column)
    { return milliseconds(1e-3 * changes.number(i, column)); };
    text += row({ changes.field(i, "scene"), changes.field(i, "change"),
      changes.field(i, "traversal"), ms("total_ms"), ms("colour_ms"), ms("opacity_ms"),
      ms("march_ms"), changes.field(i, "kept") });
  }
  return text;
}

std::string ordersTable(const Results& results)
{
  std::string text;
  for (const std::string& scene : sceneNames(results))
  {
    std::vector<std::string> done;
    for (const Result& first : results.rows)
    {
      if (first.scene != scene || first.parameter != StepScale || std::isnan(first.rmseOwn) ||
        std::count(done.begin(), done.end(), first.method) > 0)
      {
        continue;
      }
      done.push_back(first.method);
      std::vector<std::pair<double, double>> errors;
      for (const Result& r : results.rows)
      {
        if (r.scene == scene && r.method == first.method && r.rmseOwn > 0.0)
        {
          errors.emplace_back(r.value, r.rmseOwn);
        }
      }
      const auto ends = std::minmax_element(errors.begin(), errors.end());
      if (errors.size() < 3)
      {
        continue;
      }
      text += row({ scene, first.method, number(ends.second->second, "%.2g"),
        number(ends.first->second, "%.2g"), number(accuracy::observedOrder(errors), "%.2f") });
    }
  }
  return text.empty()
    ? text
    : row({ "scene", "method", "RMSE at the longest step", "at the shortest", "fitted order" }) +
      rule(5) + text;
}
}

std::string number(double value, const char* format)
{
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return std::isnan(value) ? "-" : text;
}

std::string milliseconds(double value)
{
  return number(1e3 * value, value < 0.001 ? "%.3f" : value < 0.1 ? "%.1f" : "%.0f");
}

std::string row(const std::vector<std::string>& cells)
{
  std::string text = "|";
  for (const std::string& cell : cells)
  {
    text += " " + cell + (cell.empty() ? "|" : " |");
  }
  return text + "\n";
}

std::string rule(int columns)
{
  std::string text;
  for (int i = 0; i < columns; ++i)
  {
    text += "| --- ";
  }
  return text + "|\n";
}

std::vector<std::string> sceneNames(const Results& results)
{
  std::vector<std::string> names;
  for (const Result& r : results.rows)
  {
    if (std::find(names.begin(), names.end(), r.scene) == names.end())
    {
      names.push_back(r.scene);
    }
  }
  return names;
}

const Result* findDefault(const Results& results, const std::string& scene)
{
  const Result* fastest = nullptr;
  for (const Result& r : results.rows)
  {
    if (r.scene == scene && r.role == Role::Ours && r.method.compare(0, 6, "basis,") == 0 &&
      r.value == DefaultStepScale && (!fastest || r.wall < fastest->wall))
    {
      fastest = &r;
    }
  }
  return fastest;
}

std::map<std::string, std::string> makeTables(const Results& results)
{
  std::map<std::string, std::string> tables{ { "machine.md", machineTable(results) },
    { "scenes.md", scenesTable(results.scenes) },
    { "growth.md", results.growth.empty() ? "" : growthTable(results.growth) },
    { "results.md", resultsTable(results) }, { "peers.md", peersTable(results) },
    { "orders.md", ordersTable(results) }, { "changes.md", changesTable(results.changes) },
    { "target_frame.md", frameTargetTable(results) },
    { "target_native.md", nativeTargetTable(results) },
    { "target_tolerance.md", toleranceTargetTable(results) }, { "levels.md", levelsTable(results) },
    { "target_samples.md", samplesTargetTable(results) },
    { "source_times.md", sourceTimesTable(results) },
    { "source_memory.md", sourceMemoryTable(results) } };
  for (auto& table : tables)
  {
    table.second = table.second.empty() ? "Not measured.\n" : table.second;
  }
  return tables;
}
}
}
