// SPDX-License-Identifier: BSD-3-Clause
#include "TargetTables.h"

#include "Report.h"
#include "SourceTables.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace benchmarks
{
const char* const TargetScene = "rt_medium magvort, scene";

namespace
{
constexpr double LeastDecibels = 51.0;
constexpr double MostOfPeer = 0.8;
constexpr double PeerGrid = 128.0;
const char* const Peer = "resampled, vtkFixedPointVolumeRayCastMapper";
constexpr double MostOfNative = 2.0;
constexpr double MostOffTolerance = 2.0;
constexpr double MostSamples = 0.5;

const Result* find(
  const Results& results, const std::string& scene, const std::string& method, double value)
{
  for (const Result& r : results.rows)
  {
    if (r.scene == scene && r.method == method && r.value == value)
    {
      return &r;
    }
  }
  return nullptr;
}

const char* verdict(double ratio, double most) { return ratio <= most ? "kept" : "missed"; }
}

std::string frameTargetTable(const Results& results)
{
  const Result* peer = find(results, TargetScene, Peer, PeerGrid);
  if (!peer)
  {
    return {};
  }
  std::string text;
  std::vector<std::string> done;
  for (const Result& first : results.rows)
  {
    const bool basis =
      first.method.compare(0, 6, "basis,") == 0 || first.method == "vtkExaBricksVolumeMapper";
    if (first.scene != TargetScene || !basis ||
      std::find(done.begin(), done.end(), first.method) != done.end())
    {
      continue;
    }
    done.push_back(first.method);
    const Result* fastest = nullptr;
    for (const Result& r : results.rows)
    {
      if (r.scene == TargetScene && r.method == first.method && r.psnr >= LeastDecibels &&
        (!fastest || r.wall < fastest->wall))
      {
        fastest = &r;
      }
    }
    const double ratio = fastest ? fastest->wall / peer->wall : NotMeasured;
    text += row(
      { first.method, fastest ? fastest->parameter + " " + number(fastest->value, "%g") : "none",
        fastest ? number(fastest->psnr, "%.1f") : "-", fastest ? milliseconds(fastest->wall) : "-",
        milliseconds(peer->wall), number(peer->psnr, "%.1f"), number(ratio, "%.2f"),
        number(MostOfPeer, "%g"), verdict(ratio, MostOfPeer) });
  }
  return text.empty() ? text
                      : row({ "ours", "fastest with at least 51 dB", "dB", "frame ms",
                          "resampled to 128³, fixed-point mapper: frame ms", "its dB", "ours / its",
                          "target, at most", "" }) +
      rule(9) + text;
}

std::string nativeTargetTable(const Results& results)
{
  std::string text;
  for (const std::string& scene : sceneNames(results))
  {
    const Result* native = find(results, scene, NativeMarch, DefaultStepScale);
    const Result* ours = find(results, scene, "basis, k-d tree", DefaultStepScale);
    if (native && ours && native->cpu > 0.0)
    {
      const double ratio = ours->cpu / native->cpu;
      text += row({ scene, milliseconds(ours->cpu), milliseconds(native->cpu),
        number(ratio, "%.2f"), number(MostOfNative, "%g"), verdict(ratio, MostOfNative),
        milliseconds(ours->wall), milliseconds(native->wall) });
    }
  }
  return text.empty()
    ? text
    : row({ "scene", "ours, k-d tree: CPU ms", "native march: CPU ms", "ours / its",
        "target, at most", "", "ours: frame ms", "native: frame ms" }) +
      rule(8) + text;
}

std::string toleranceTargetTable(const Results& results)
{
  std::string text;
  for (const Result& r : results.rows)
  {
    if (r.method == ByTolerance && !std::isnan(r.psnrRGBADrawn))
    {
      const double got = std::pow(10.0, -r.psnrRGBADrawn / 20.0);
      const double ratio = got / r.value;
      text += row({ r.scene, number(r.value, "%g"), number(got, "%.2g"), number(ratio, "%.2f"),
        ratio > MostOffTolerance           ? "missed"
          : ratio < 1.0 / MostOffTolerance ? "better than asked for"
                                           : "kept" });
    }
  }
  return text.empty()
    ? text
    : row({ "scene", "asked for", "got", "got / asked for", "" }) + rule(5) + text;
}

std::string levelsTable(const Results& results)
{
  std::string text;
  for (const Result& r : results.rows)
  {
    const Result* all =
      r.method == ByTolerance ? find(results, r.scene, ByToleranceOfAllLevels, r.value) : nullptr;
    // Pilots that begin elsewhere may end elsewhere.
    if (all && r.samples < 0.9 * all->samples)
    {
      text += row({ r.scene, number(r.value, "%g"), milliseconds(all->cpu), milliseconds(r.cpu),
        number(r.cpu / all->cpu, "%.2f"), number(all->samples, "%.1f"), number(r.samples, "%.1f"),
        number(all->psnrRGBADrawn, "%.1f"), number(r.psnrRGBADrawn, "%.1f") });
    }
  }
  return text.empty()
    ? text
    : row({ "scene", "error tolerance", "all levels: CPU ms", "some left out: CPU ms", "ratio",
        "all levels: samples", "some left out", "all levels: dB, RGBA drawn", "some left out" }) +
      rule(9) + text;
}

namespace
{
// Samples at an accuracy, between the two values of the parameter around it.
double samplesAt(
  const Results& results, const std::string& scene, const std::string& method, double decibels)
{
  std::vector<std::pair<double, double>> points; // dB, samples
  for (const Result& r : results.rows)
  {
    if (r.scene == scene && r.method == method && r.samples > 0.0)
    {
      points.emplace_back(r.psnr, r.samples);
    }
  }
  std::sort(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const auto& a = points[i - 1];
    const auto& b = points[i];
    if (a.first <= decibels && decibels <= b.first && a.first < b.first)
    {
      const double share = (decibels - a.first) / (b.first - a.first);
      return std::pow(a.second, 1.0 - share) * std::pow(b.second, share);
    }
  }
  return NotMeasured;
}
}

std::string samplesTargetTable(const Results& results)
{
  std::string text;
  for (const std::string& scene : sceneNames(results))
  {
    for (const double decibels : { 50.0, 60.0, 70.0 })
    {
      const double fixed = samplesAt(results, scene, "basis, k-d tree", decibels);
      const double chosen = samplesAt(results, scene, ByTolerance, decibels);
      const double ratio = chosen / fixed;
      if (!std::isnan(ratio))
      {
        text += row({ scene, number(decibels, "%g"), number(fixed, "%.2f"), number(chosen, "%.2f"),
          number(ratio, "%.2f"), number(MostSamples, "%g"), verdict(ratio, MostSamples) });
      }
    }
  }
  return text.empty() ? text
                      : row({ "scene", "dB", "samples a pixel, fixed steps", "by tolerance",
                          "ratio", "target, at most", "" }) +
      rule(7) + text;
}
}
}
