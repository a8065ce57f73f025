// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/AnalyticFields.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace exabricks
{
namespace accuracy
{
namespace
{
Grid finish(Hierarchy hierarchy, int coarseCells)
{
  Grid grid;
  grid.hierarchy = std::move(hierarchy);
  grid.leaves = findLeafBoxes(grid.hierarchy);
  grid.coarseCells = coarseCells;
  grid.cellShare = 1.0 / static_cast<double>(coarseCells * grid.hierarchy.cellWidth[0]);
  return grid;
}
}

Field constant(double value)
{
  return { "constant", [=](const glm::dvec3&) { return value; } };
}

Field linear(const glm::dvec3& slope)
{
  return { "linear", [=](const glm::dvec3& p) { return 0.1 + glm::dot(slope, p); } };
}

Field quadratic(const glm::dvec3& coefficients)
{
  return { "quadratic", [=](const glm::dvec3& p) { return glm::dot(coefficients, p * p); } };
}

Field gaussian(const glm::dvec3& center, double width)
{
  return { "Gaussian",
    [=](const glm::dvec3& p)
    {
      const glm::dvec3 off = (p - center) / width;
      return std::exp(-glm::dot(off, off));
    } };
}

Field movingFront(double time, double width)
{
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.8, 0.6)); // along no grid line
  const double position = time * glm::dot(direction, glm::dvec3(1.0));
  return { "moving front", [=](const glm::dvec3& p) {
            return 0.5 - 0.5 * std::tanh((glm::dot(direction, p) - position) / width);
          } };
}

Field shellAndBlobs()
{
  const std::int64_t fine =
    1 << 20; // the unit cube as a lattice box, for its shares are all it uses
  return { "shell and blobs", [=](const glm::dvec3& p) {
            return reference::shellAndBlobs({ Int3(0), Int3(fine) }, p * static_cast<double>(fine));
          } };
}

Grid makeBoxGrid(int ratio, int coarseCells)
{
  Hierarchy hierarchy;
  hierarchy.cellWidth = { 1 };
  hierarchy.blocks = { { 0, { Int3(0), Int3(coarseCells) } } };
  if (ratio > 1)
  {
    hierarchy.cellWidth = { ratio, 1 };
    const std::int64_t quarter = static_cast<std::int64_t>(ratio) * coarseCells / 4;
    hierarchy.blocks.push_back({ 1, { Int3(quarter), Int3(3 * quarter) } });
  }
  return finish(std::move(hierarchy), coarseCells);
}

Grid makeShellGrid(const std::vector<int>& ratios, int coarseCells)
{
  return finish(reference::refinedAtShell(ratios, coarseCells, 4), coarseCells);
}

reference::CellField atCenters(const Grid& grid, const Field& field)
{
  return [value = field.value, widths = grid.hierarchy.cellWidth, share = grid.cellShare](
           int level, const Int3& cell)
  { return value((glm::dvec3(cell) + 0.5) * (static_cast<double>(widths[level]) * share)); };
}
}
}
