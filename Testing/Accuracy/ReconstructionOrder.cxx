// SPDX-License-Identifier: BSD-3-Clause
#include "Accuracy/ReconstructionOrder.h"

#include "Accuracy/ObservedOrder.h"

#include <cmath>
#include <glm/common.hpp>

namespace exabricks
{
namespace accuracy
{
namespace
{
constexpr Zone parts[] = { Zone::Interior, Zone::LevelBoundary, Zone::DataBounds };

// The n-th point of an additive recurrence that fills the unit cube evenly (Roberts 2018).
glm::dvec3 evenPoint(int n)
{
  constexpr double g = 1.2207440846057596; // g^4 = g + 1
  return glm::fract(
    0.5 + static_cast<double>(n) * glm::dvec3(1.0 / g, 1.0 / (g * g), 1.0 / (g * g * g)));
}

double cubed(double x) { return x * x * x; }

// The zones of makeBoxGrid, in shares of the cube.
struct Zones
{
  double reach; // half a coarse cell
  bool levels;  // there are two

  Zones(int ratio, int coarseCells)
    : reach(0.5 / coarseCells)
    , levels(ratio > 1)
  {
  }
  Zone zoneOf(const glm::dvec3& p) const
  {
    const glm::dvec3 off = glm::abs(p - 0.5);
    const double most = std::max({ off.x, off.y, off.z });
    return most > 0.5 - this->reach                   ? Zone::DataBounds
      : levels && std::abs(most - 0.25) < this->reach ? Zone::LevelBoundary
                                                      : Zone::Interior;
  }
  double volume(Zone zone) const
  {
    const double boundary =
      this->levels ? cubed(0.5 + 2.0 * this->reach) - cubed(0.5 - 2.0 * this->reach) : 0.0;
    const double bounds = 1.0 - cubed(1.0 - 2.0 * this->reach);
    return zone == Zone::Whole      ? 1.0
      : zone == Zone::LevelBoundary ? boundary
      : zone == Zone::DataBounds    ? bounds
                                    : 1.0 - boundary - bounds;
  }
  // Points of the zone, from those that fill a cube around it.
  std::vector<glm::dvec3> points(Zone zone, int count) const
  {
    const double side = zone == Zone::LevelBoundary ? 0.5 + 2.0 * this->reach : 1.0;
    std::vector<glm::dvec3> chosen;
    for (int n = 0; this->volume(zone) > 0.0 && static_cast<int>(chosen.size()) < count; ++n)
    {
      const glm::dvec3 p = 0.5 + side * (evenPoint(n) - 0.5);
      if (this->zoneOf(p) == zone)
      {
        chosen.push_back(p);
      }
    }
    return chosen;
  }
};

// By a hair on this side of the nearest multiples of half a finest cell: errors are greatest at
// cell corners (nearest; basis, between centres) or half a fine cell from a level's face (basis).
glm::dvec3 nearHalfCells(const glm::dvec3& p, double cellWidth)
{
  return glm::mix(0.5 * cellWidth * glm::round(p / (0.5 * cellWidth)), p, 1e-9);
}
}

const char* nameOf(Method method)
{
  constexpr const char* names[] = { "nearest", "basis", "corrected", "completed beyond bounds",
    "completed" };
  return names[static_cast<int>(method)];
}

const char* nameOf(Zone zone)
{
  constexpr const char* names[] = { "interior", "level boundary", "data bounds", "whole" };
  return names[static_cast<int>(zone)];
}

Sampler::Sampler(const Grid& grid, const Field& field)
  // the range makes normalised values the field's own
  : Judge(grid.hierarchy, grid.leaves, reference::fillCells(grid.hierarchy, atCenters(grid, field)),
      Range{ 0.0, 1.0 })
  , Others(grid.hierarchy, grid.leaves, atCenters(grid, field))
{
}

std::optional<double> Sampler::sample(const glm::dvec3& logical, Method method) const
{
  switch (method)
  {
    case Method::Nearest:
      return this->Judge.sample(logical, reference::Reconstruction::Nearest);
    case Method::Basis:
      return this->Judge.sample(logical, reference::Reconstruction::Basis);
    case Method::Corrected:
      return this->Others.corrected(logical);
    case Method::CompletedBeyond:
      return this->Others.completedBeyond(logical);
    case Method::Completed:
      return this->Others.completed(logical);
  }
  return {};
}

std::vector<ErrorRow> measureErrors(const Field& field, int ratio,
  const std::vector<int>& coarseCells, const std::vector<Method>& methods, int points)
{
  std::vector<ErrorRow> rows;
  for (const int cells : coarseCells)
  {
    const Grid grid = makeBoxGrid(ratio, cells);
    const Sampler sampler(grid, field);
    const Zones zones(ratio, cells);
    std::vector<std::vector<glm::dvec3>> chosen; // [part]
    for (const Zone zone : parts)
    {
      chosen.push_back(zones.points(zone, points));
    }
    for (const Method method : methods)
    {
      const auto errorAt = [&](const glm::dvec3& p)
      { return std::abs(*sampler.sample(p / grid.cellShare, method) - field.value(p)); };
      ErrorRow whole{ field.name, ratio, method, Zone::Whole, grid.coarseWidth(), 0.0, 0.0 };
      for (std::size_t part = 0; part < chosen.size(); ++part)
      {
        if (chosen[part].empty())
        {
          continue;
        }
        double max = 0.0;
        double squares = 0.0;
        for (const glm::dvec3& p : chosen[part])
        {
          const double error = errorAt(p);
          const glm::dvec3 extreme = nearHalfCells(p, grid.cellShare);
          max = std::max(max, error);
          if (zones.zoneOf(extreme) == parts[part])
          {
            max = std::max(max, errorAt(extreme));
          }
          squares += error * error;
        }
        const double mean = squares / static_cast<double>(chosen[part].size());
        rows.push_back(
          { field.name, ratio, method, parts[part], grid.coarseWidth(), max, std::sqrt(mean) });
        whole.max = std::max(whole.max, max);
        whole.rms += mean * zones.volume(parts[part]);
      }
      whole.rms = std::sqrt(whole.rms);
      rows.push_back(whole);
    }
  }
  return rows;
}

double observedOrder(const std::vector<ErrorRow>& rows, Method method, Zone zone, Norm norm)
{
  std::vector<std::pair<double, double>> errors;
  for (const ErrorRow& row : rows)
  {
    if (row.method == method && row.zone == zone)
    {
      errors.emplace_back(row.coarseWidth, norm == Norm::Max ? row.max : row.rms);
    }
  }
  return observedOrder(errors);
}

std::vector<double> measureJumps(
  const Sampler& sampler, const Grid& grid, Method method, const std::vector<double>& distances)
{
  constexpr int points = 500; // on each face
  const double side = 1.0 / grid.cellShare;
  std::vector<double> jumps;
  for (const double distance : distances)
  {
    double greatest = 0.0;
    for (int face = 0; face < 6; ++face)
    {
      for (int n = 0; n < points; ++n)
      {
        const int axis = face / 2;
        glm::dvec3 p = side * (0.25 + 0.5 * evenPoint(n));
        p[axis] = side * (face % 2 ? 0.75 : 0.25);
        glm::dvec3 off(0.0);
        off[axis] = distance;
        greatest = std::max(
          greatest, std::abs(*sampler.sample(p + off, method) - *sampler.sample(p - off, method)));
      }
    }
    jumps.push_back(greatest);
  }
  return jumps;
}

NormalErrors measureNormals(
  const Sampler& sampler, const Grid& grid, const Field& field, Method method, bool inside)
{
  constexpr int linesOfFace = 30;
  constexpr double spacing = 0.01; // of points on a line, finest cells
  constexpr double difference = 1e-4;
  const double side = 1.0 / grid.cellShare;
  const double reach = side / grid.coarseCells; // a coarse cell
  const auto direction = [&](const auto& value, const glm::dvec3& p, double step)
  {
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 off(0.0);
      off[axis] = step;
      gradient[axis] = value(p + off) - value(p - off);
    }
    return glm::normalize(gradient);
  };
  const auto degrees = [](const glm::dvec3& a, const glm::dvec3& b)
  { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / 3.14159265358979; };
  double off = 0.0;
  double turns = 0.0;
  double greatestTurn = 0.0;
  int points = 0;
  for (int line = 0; line < 6 * linesOfFace; ++line)
  {
    const int axis = line / linesOfFace / 2;
    glm::dvec3 middle = side * (0.3 + 0.4 * evenPoint(line % linesOfFace));
    middle[axis] = side * (inside ? 0.5 : line / linesOfFace % 2 ? 0.75 : 0.25);
    double turn = 0.0;
    glm::dvec3 last(0.0);
    for (double t = -reach + 0.37 * spacing; t < reach; t += spacing)
    {
      glm::dvec3 p = middle;
      p[axis] += t;
      const glm::dvec3 found =
        direction([&](const glm::dvec3& at) { return *sampler.sample(at, method); }, p, difference);
      const glm::dvec3 truth =
        direction([&](const glm::dvec3& at) { return field.value(at * grid.cellShare); }, p, 1e-3);
      off += degrees(found, truth);
      ++points;
      turn = last == glm::dvec3(0.0) ? turn : std::max(turn, degrees(found, last));
      last = found;
    }
    turns += turn;
    greatestTurn = std::max(greatestTurn, turn);
  }
  return { off / points, greatestTurn, turns / (6 * linesOfFace) };
}

double basisAcrossLevels(double r, double x)
{
  if (std::abs(x) >= 0.5 * r)
  {
    return x;
  }
  if (x <= -0.5)
  {
    return -0.5 * r;
  }
  return x < 0.5 ? (x - 0.25 * (r - 1.0)) / (1.0 + x * (r - 1.0) / r)
                 : x - (0.25 * r * r - x * x) / (1.5 * r - x);
}

double greatestDeviationAcrossLevels(double ratio) { return 0.5 * (ratio - 1.0); }
}
}
