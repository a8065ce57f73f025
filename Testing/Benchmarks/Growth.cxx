// SPDX-License-Identifier: BSD-3-Clause
#include "Growth.h"

#include "Machine.h"
#include "Measure.h"

#include <cstdio>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// Host and device: values twice, once more while they are gathered, regions and their trees.
constexpr double BytesPerCell = 60.0;
constexpr int Frames = 3;
}

void measureGrowth(const SceneKind& kind, double largest, const Size& size, Results& results)
{
  for (double cells = 1e5; cells < 1.01 * largest; cells *= 10.0)
  {
    char text[64];
    std::snprintf(text, sizeof text, "%.2g", cells);
    const double available = availableMemory();
    if (available > 0.0 && BytesPerCell * cells > available)
    {
      say(kind.name + ": not enough memory for " + text + " leaf cells");
      return;
    }
    say(kind.name + ": growth, " + text + " leaf cells");
    const Scene scene(kind.make(cells));
    if (cells > 1e5 &&
      results.growth.back().leafCells == static_cast<double>(scene.structure().leafCells))
    {
      continue; // not made any smaller
    }
    results.growth.push_back(measureStructure(scene, kind.group, size, Frames));
    results.growth.back().scene = kind.name;
  }
}
}
}
