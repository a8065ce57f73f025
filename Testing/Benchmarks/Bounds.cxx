// SPDX-License-Identifier: BSD-3-Clause
#include "Bounds.h"

#include <cmath>
#include <cstdio>

namespace exabricks
{
namespace benchmarks
{
namespace
{
// dB over drawn pixels against the integral of the method's own reconstruction. Nearest is exact
// but for float32; the basis is worst where few cells hold many folds of the transfer function.
constexpr double LeastNearest = 80.0;
constexpr double LeastBasisAt1 = 37.0;
constexpr double LeastBasisAtQuarter = 55.0;
constexpr double LeastSimilarity = 0.98;
constexpr double TraversalsApart = 0.5; // dB

bool startsWith(const std::string& text, const std::string& with)
{
  return text.compare(0, with.size(), with) == 0;
}

std::string describe(const Result& row, const char* what, double is, double bound)
{
  char text[256];
  std::snprintf(text, sizeof text, "%s, %s, %s %g: expected %s of at least %g, found %.4g",
    row.scene.c_str(), row.method.c_str(), row.parameter.c_str(), row.value, what, bound, is);
  return text;
}

// The same reconstruction drawn by the other traversal.
const Result* findTwin(const Results& results, const Result& row)
{
  const std::size_t end = row.method.find(", k-d tree");
  if (end == std::string::npos)
  {
    return nullptr;
  }
  const std::string name = row.method.substr(0, end) + ", ray query";
  for (const Result& other : results.rows)
  {
    if (other.scene == row.scene && other.method == name && other.value == row.value)
    {
      return &other;
    }
  }
  return nullptr;
}
}

std::vector<std::string> findBrokenStructure(const Scene& scene)
{
  std::vector<std::string> broken;
  const Structure& structure = scene.structure();
  std::uint64_t cells = 0;
  for (const Brick& brick : structure.bricks)
  {
    cells += brick.numberOfCells();
  }
  if (cells != structure.leafCells)
  {
    broken.push_back(scene.name() + ": expected bricks of " + std::to_string(structure.leafCells) +
      " cells, found " + std::to_string(cells));
  }
  double volume = 0.0;
  for (const layout::Region& region : structure.tree.regions)
  {
    const glm::dvec3 size(region.hi - region.lo);
    volume += size.x * size.y * size.z;
  }
  const glm::dvec3 all(structure.tree.size);
  const double expected = all.x * all.y * all.z;
  if (std::abs(volume - expected) > 1e-9 * expected)
  {
    char text[128];
    std::snprintf(text, sizeof text, ": expected regions of %.0f cubic half cells, found %.0f",
      expected, volume);
    broken.push_back(scene.name() + text);
  }
  return broken;
}

std::vector<std::string> findBrokenBounds(const Results& results)
{
  std::vector<std::string> broken;
  const auto expect = [&](const Result& row, const char* what, double is, double bound)
  {
    if (!(is >= bound))
    {
      broken.push_back(describe(row, what, is, bound));
    }
  };
  for (const Result& row : results.rows)
  {
    const bool basis = startsWith(row.method, "basis,");
    if (row.role != Role::Ours)
    {
      continue;
    }
    if (startsWith(row.method, "nearest,"))
    {
      expect(row, "dB against the nearest reconstruction", -20.0 * std::log10(row.rmseOwn),
        LeastNearest);
    }
    if (basis && row.value == 1.0)
    {
      expect(row, "dB over drawn pixels", row.psnrRGBADrawn, LeastBasisAt1);
      expect(row, "SSIM", row.ssim, LeastSimilarity);
    }
    if (basis && row.value == 0.25)
    {
      expect(row, "dB over drawn pixels", row.psnrRGBADrawn, LeastBasisAtQuarter);
    }
    const Result* twin = findTwin(results, row);
    if (twin && row.psnrRGBA < 90.0 && std::abs(row.psnrRGBA - twin->psnrRGBA) > TraversalsApart)
    {
      char text[192];
      std::snprintf(text, sizeof text, "%s, %s: the traversals differ: %.2f and %.2f dB",
        row.scene.c_str(), row.method.c_str(), row.psnrRGBA, twin->psnrRGBA);
      broken.emplace_back(text);
    }
  }
  return broken;
}
}
}
