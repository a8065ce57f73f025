// SPDX-License-Identifier: BSD-3-Clause
#include "SourceTables.h"

#include "Report.h"

#include <algorithm>
#include <cmath>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// Their unit of time is not given: ratios count. MB as they write it.
struct Source
{
  const char* scene;
  double cellLocation;
  double regions;
  double timeRatio; // ours is to be no less
  double scalarsMB; // NaN: the data of the line above
  double bricksMB;
  double regionsMB;
  double totalMB;
  double memoryRatio; // regions / scalars: ours is to be no more
};

const Source sources[] = {
  { "Cloud", 88.5, 37.8, 3.5, 307, 31.8, 1000, 2060, 0.8 },
  { "Impact-5K", 80.6, 38.9, 3.2, 102, 17.7, 676, 2190, 1.6 },
  { "Impact-20K", 258, 130, 3.0, 604, 104, 4820, 12900, 2.0 },
  { "Impact-46K", 391, 202, 2.9, 1060, 95.1, 4150, 11700, 1.0 },
  { "Wind", 151, 75.8, 3.0, 1530, 0.767, 36.3, 2160, 0.01 },
  { "Gear", 288, 56.5, 7.6, 1960, 0.813, 42.2, 2700, 0.01 },
  { "Exajet-rear", 218, 80.6, 4.0, 2450, 95.0, 2950, 13400, 0.3 },
  { "Exajet-wing", 88.5, 36.2, 3.6, NotMeasured, NotMeasured, NotMeasured, NotMeasured,
    NotMeasured },
};

// At the step that users get.
const Result* findBaseline(const Results& results, const std::string& scene, const char* method)
{
  for (const Result& r : results.rows)
  {
    if (r.scene == scene && r.method.compare(0, std::string(method).size(), method) == 0 &&
      r.value == DefaultStepScale)
    {
      return &r;
    }
  }
  return nullptr;
}

std::string verdict(double is, double bound, bool atLeast)
{
  return std::isnan(is) ? "-" : (atLeast ? is >= bound : is <= bound) ? "kept" : "missed";
}
}

std::string sourceTimesTable(const Results& results)
{
  std::string text;
  for (const Source& source : sources)
  {
    const Result* regions = findDefault(results, source.scene);
    const Result* location = findBaseline(results, source.scene, CellLocation);
    if (!regions)
    {
      continue;
    }
    const double ratio = location ? location->wall / regions->wall : NotMeasured;
    text += row({ source.scene, number(source.cellLocation, "%.3g"), number(source.regions, "%.3g"),
      number(source.cellLocation / source.regions, "%.1f"),
      milliseconds(location ? location->wall : NotMeasured), milliseconds(regions->wall),
      number(ratio, "%.1f"), number(source.timeRatio, "%.1f"),
      verdict(ratio, source.timeRatio, true) });
  }
  return text.empty()
    ? text
    : row({ "scene", "source: cell location", "source: regions", "source: ratio",
        "ours: cell location, ms", "ours: regions, ms", "ours: ratio", "target, at least", "" }) +
      rule(9) + text;
}

std::string sourceMemoryTable(const Results& results)
{
  std::string text;
  for (const Source& source : sources)
  {
    const SceneFigures* found = nullptr;
    for (const SceneFigures& scene : results.scenes)
    {
      found = scene.scene == source.scene ? &scene : found;
    }
    if (!found || std::isnan(source.scalarsMB))
    {
      continue;
    }
    const auto mb = [](double bytes) { return number(1e-6 * bytes, "%.3g"); };
    const auto theirs = [](double megabytes) { return number(megabytes, "%.4g"); };
    const double onHost = found->regionHostBytes / found->scalarBytes;
    const double ratio = found->regionBytes / found->scalarBytes;
    text += row({ source.scene, "source", theirs(source.scalarsMB), theirs(source.bricksMB), "",
      theirs(source.regionsMB), "", "", theirs(source.totalMB),
      number(source.regionsMB / source.scalarsMB, "%.2g"), "", "", "" });
    text +=
      row({ "", "ours", mb(found->scalarBytes), mb(found->brickBytes), mb(found->regionHostBytes),
        mb(found->regionBytes), mb(found->accelerationBytes), mb(found->surfaceBytes),
        mb(found->rayQueryTotal), number(ratio, "%.2g"), number(source.memoryRatio, "%g"),
        verdict(ratio, source.memoryRatio, false), number(onHost, "%.2g") });
  }
  return text.empty()
    ? text
    : row({ "scene", "", "scalars MB", "bricks MB", "regions on the host MB",
        "regions on the device MB", "acceleration structure MB", "surface MB", "total MB",
        "regions / scalars, device", "target, at most", "", "the same on the host" }) +
      rule(13) + text;
}
}
}
